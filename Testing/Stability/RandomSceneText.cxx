// SPDX-License-Identifier: BSD-3-Clause
#include "RandomScene.h"

#include <limits>
#include <ostream>

namespace
{

using namespace PhotonTransport;

std::ostream& operator<<(std::ostream& out, const glm::dvec3& v)
{
  return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
}

struct DescribeLamp
{
  std::ostream& out;
  void operator()(const ParallelLight& l) const
  {
    out << "parallel " << l.direction << ' ' << l.illuminance << " lx";
  }
  void operator()(const PointLamp& l) const { out << "point " << l.position << ' ' << l.flux; }
  void operator()(const LambertianPointLamp& l) const
  {
    out << "Lambertian " << l.position << ' ' << l.direction << ' ' << l.flux;
  }
  template <typename AnyLamp>
  void operator()(const AnyLamp&) const
  {
  }
  void operator()(const SpotLamp& l) const
  {
    out << "spot " << l.position << ' ' << l.direction << ' ' << l.halfAngle << " rad, exponent "
        << l.exponent << ' ' << l.flux;
  }
  void operator()(const RectangleLamp& l) const
  {
    out << "rectangle " << l.centre << ' ' << l.direction << ' ' << l.width << " x " << l.height
        << ' ' << l.flux;
  }
  void operator()(const DiskLamp& l) const
  {
    out << "disk " << l.centre << ' ' << l.direction << ' ' << l.radius << ' ' << l.flux;
  }
  void operator()(const EmittingFacets&) const { out << "facets"; }
  void operator()(const UniformSky& l) const
  {
    out << "sky " << l.up << ' ' << l.luminance << (l.wholeSphere ? " whole" : " half");
  }
};

} // namespace

std::ostream& operator<<(std::ostream& out, const RandomScene& scene)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  const Surface& surface = scene.surface;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    out << "\n  point " << p << ' ' << surface.points[p];
    if (p < surface.normals.size())
    {
      out << " normal " << surface.normals[p];
    }
  }
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
  {
    const glm::uvec3& ids = surface.facets[f];
    out << "\n  facet " << ids.x << ' ' << ids.y << ' ' << ids.z << " reflectance "
        << surface.reflectance[f];
    if (!surface.exitance.empty())
    {
      out << " exitance " << surface.exitance[f];
    }
  }
  const TraceSettings& s = scene.settings;
  out << "\n  " << surface.metresPerUnit << " m per unit\n  lamp: ";
  std::visit(DescribeLamp{ out }, scene.lamp);
  return out << "\n  seed " << s.seed << ", sampling " << static_cast<int>(s.sampling)
             << ", registration " << static_cast<int>(s.registration) << ", scatterings "
             << s.scatterings << ", back " << s.registerBackSide << ", bound " << s.weightBound
             << ", longest path " << s.maximumPathLength << ", threads " << s.threads
             << "\n  mistake: " << (scene.mistake.empty() ? "none" : scene.mistake);
}
