// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/MovedLamp.h"

#include "Illumination/pipeline/InputError.h"

#include "PhotonTransport/lights/LampTables.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

using namespace PhotonTransport;

/// The vector at unit length, without overflow at 1e200 or underflow at 1e-200.
glm::dvec3 Unit(const glm::dvec3& v)
{
  const double largest = std::max({ std::fabs(v.x), std::fabs(v.y), std::fabs(v.z) });
  return glm::normalize(v / largest);
}

/// Whether the intensities stay the same when the angles of the grid are replaced by others.
bool IsSame(
  const PhotometricSolid& solid, const std::function<void(double& polar, double& azimuth)>& replace)
{
  constexpr double Same = 1e-6; // of the largest intensity
  const double largest = *std::max_element(solid.candela.begin(), solid.candela.end());
  for (const double polar : solid.polar)
  {
    for (const double azimuth : solid.azimuth)
    {
      double otherPolar = polar;
      double otherAzimuth = azimuth;
      replace(otherPolar, otherAzimuth);
      const double difference =
        Intensity(solid, otherPolar, otherAzimuth) - Intensity(solid, polar, azimuth);
      if (std::fabs(difference) > Same * largest)
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether the mirror image of a lamp, left and right (x) or fore and aft (y), equals the lamp.
struct MirrorSymmetry
{
  bool x;
  bool y;
};

/// See PhotometricSolid for the angles of each type.
MirrorSymmetry SymmetryOf(const PhotometricSolid& solid)
{
  const bool back = IsSame(solid, [](double&, double& azimuth) { azimuth = -azimuth; });
  const bool across = IsSame(solid,
    [type = solid.type](double& polar, double& azimuth)
    {
      const bool isC = type == PhotometricSolid::Type::C;
      (isC ? azimuth : polar) = 180.0 - (isC ? azimuth : polar);
    });
  return solid.type == PhotometricSolid::Type::A ? MirrorSymmetry{ back, across }
                                                 : MirrorSymmetry{ across, back };
}

class Mover
{
public:
  explicit Mover(const GlyphMotion& motion)
    : Motion(motion)
  {
  }

  Lamp operator()(ParallelLight lamp) const
  {
    lamp.direction = this->Motion.Direction(lamp.direction);
    return lamp;
  }
  Lamp operator()(PointLamp lamp) const
  {
    lamp.position = this->Motion.Point(lamp.position);
    return lamp;
  }
  Lamp operator()(LambertianPointLamp lamp) const { return this->Directed(lamp); }
  Lamp operator()(SpotLamp lamp) const { return this->Directed(lamp); }
  Lamp operator()(RectangleLamp lamp) const
  {
    lamp.across = this->Motion.Direction(WidthAxis(lamp, Unit(lamp.direction)));
    lamp.centre = this->Motion.Point(lamp.centre);
    lamp.direction = this->Motion.Direction(lamp.direction);
    lamp.width *= this->Motion.scale;
    lamp.height *= this->Motion.scale;
    return lamp;
  }
  Lamp operator()(DiskLamp lamp) const
  {
    lamp.centre = this->Motion.Point(lamp.centre);
    lamp.direction = this->Motion.Direction(lamp.direction);
    lamp.radius *= this->Motion.scale;
    return lamp;
  }
  Lamp operator()(SphereLamp lamp) const
  {
    lamp.centre = this->Motion.Point(lamp.centre);
    lamp.radius *= this->Motion.scale;
    return lamp;
  }
  Lamp operator()(LineLamp lamp) const
  {
    lamp.centre = this->Motion.Point(lamp.centre);
    lamp.axis = this->Motion.Direction(lamp.axis);
    lamp.length *= this->Motion.scale;
    return lamp;
  }
  Lamp operator()(UniformSky sky) const
  {
    sky.up = this->Motion.Direction(sky.up);
    return sky;
  }
  Lamp operator()(CieSky sky) const
  {
    sky.up = this->Motion.Direction(sky.up);
    sky.sun = this->Motion.Direction(sky.sun);
    return sky;
  }
  Lamp operator()(PhotometricLamp lamp) const
  {
    const MirrorSymmetry same =
      this->Motion.mirrors ? SymmetryOf(lamp.solid) : MirrorSymmetry{ true, true };
    if (!same.x && !same.y)
    {
      throw InputError("it was mirrored, and its intensities are not the same left and right; turn "
                       "it in place of mirroring it");
    }
    const LampAxes axes = AxesOf(Unit(lamp.direction), lamp.rotation);
    lamp.position = this->Motion.Point(lamp.position);
    lamp.direction = Unit(this->Motion.Direction(axes.aim));
    // Of the two sides one follows the motion; the other does so too, unless it is mirrored.
    const LampAxes unturned = AxesOf(lamp.direction, 0.0);
    const glm::dvec3 side = this->Motion.Direction(same.y ? axes.x : axes.y);
    const double x = glm::dot(side, unturned.x);
    const double y = glm::dot(side, unturned.y);
    lamp.rotation = same.y ? std::atan2(y, x) : std::atan2(-x, y);
    return lamp;
  }
  // Surfaces are where their points are.
  Lamp operator()(const EmittingFacets& lamp) const { return lamp; }
  Lamp operator()(const EmittingMesh& lamp) const { return lamp; }

private:
  template <typename PlacedLamp>
  Lamp Directed(PlacedLamp& lamp) const
  {
    lamp.position = this->Motion.Point(lamp.position);
    lamp.direction = this->Motion.Direction(lamp.direction);
    return lamp;
  }

  const GlyphMotion& Motion;
};

} // namespace

Lamp Moved(const Lamp& lamp, const GlyphMotion& motion)
{
  return motion.isNone ? lamp : std::visit(Mover(motion), lamp);
}
