// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/LuminaireGeometry.h"

#include "Illumination/luminaires/PhotometricSurface.h"
#include "Illumination/pipeline/FieldArrays.h"

#include "vtkAlgorithm.h"
#include "vtkArrowSource.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkLineSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTrivialProducer.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <variant>
#include <vector>

namespace Illumination
{
namespace
{

using namespace PhotonTransport;

constexpr int Sides = 48; ///< Of what is round.
/// The source's output, which aims along -z at the origin, scaled, turned so that it aims along
/// `aim`, and moved to the position.
vtkSmartPointer<vtkPolyData> Placed(vtkAlgorithm* source, double scale, const glm::dvec3& position,
  const glm::dvec3& aim, double rotation = 0.0)
{
  const ShortestTurn turn(Unit(aim));
  const glm::dvec3 axis = turn.About();
  vtkNew<vtkTransform> transform;
  transform->Translate(position.x, position.y, position.z); // each acts before those above it
  transform->RotateWXYZ(vtkMath::DegreesFromRadians(turn.Angle()), axis.x, axis.y, axis.z);
  transform->RotateZ(vtkMath::DegreesFromRadians(rotation));
  transform->Scale(scale, scale, scale);
  vtkNew<vtkTransformPolyDataFilter> placed;
  placed->SetInputConnection(source->GetOutputPort());
  placed->SetTransform(transform);
  placed->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  placed->Update();
  return placed->GetOutput();
}

/// A line along the light: it shows to which side a flat thing shines, and tells its mirror image
/// from its back when points are moved.
void AddAim(
  vtkPolyData* glyph, const glm::dvec3& from, const glm::dvec3& unitDirection, double length)
{
  const glm::dvec3 to = from + length * unitDirection;
  const vtkIdType ids[2] = { glyph->GetPoints()->InsertNextPoint(from.x, from.y, from.z),
    glyph->GetPoints()->InsertNextPoint(to.x, to.y, to.z) };
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(2, ids);
  glyph->SetLines(line);
}

/// An arrow that starts at the position.
vtkSmartPointer<vtkPolyData> Arrow(
  const glm::dvec3& position, const glm::dvec3& direction, double length)
{
  vtkNew<vtkTransform> down;
  down->RotateY(90.0); // from +x
  vtkNew<vtkArrowSource> arrow;
  arrow->SetShaftResolution(Sides);
  arrow->SetTipResolution(Sides);
  vtkNew<vtkTransformPolyDataFilter> downward;
  downward->SetInputConnection(arrow->GetOutputPort());
  downward->SetTransform(down);
  return Placed(downward, length, position, direction);
}

vtkSmartPointer<vtkPolyData> Ball(const glm::dvec3& centre, double radius)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(centre.x, centre.y, centre.z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(Sides);
  ball->SetPhiResolution(Sides / 2 + 1);
  ball->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  ball->Update();
  return ball->GetOutput();
}

/// Zenith along `up`.
vtkSmartPointer<vtkPolyData> Dome(const glm::dvec3& up, bool whole, const LuminaireGlyph& glyph)
{
  vtkNew<vtkSphereSource> dome;
  dome->SetRadius(1.0);
  dome->SetThetaResolution(Sides);
  dome->SetPhiResolution(Sides / (whole ? 2 : 4) + 1);
  dome->SetEndPhi(whole ? 180.0 : 90.0);
  dome->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  return Placed(dome, glyph.size, glyph.position, -up);
}

/// The sky's luminance, cd/m^2, at each point of its dome.
void AddLuminance(vtkPolyData* dome, const CieSky& sky, const glm::dvec3& centre)
{
  std::vector<glm::dvec3> towards(static_cast<std::size_t>(dome->GetNumberOfPoints()));
  for (std::size_t p = 0; p < towards.size(); ++p)
  {
    dome->GetPoint(static_cast<vtkIdType>(p), &towards[p].x);
    towards[p] -= centre;
  }
  AddArray(dome->GetPointData(), "Luminance", sky.Luminance(towards));
  dome->GetPointData()->SetActiveScalars("Luminance");
}

class Geometry
{
public:
  explicit Geometry(const LuminaireGlyph& glyph)
    : Glyph(glyph)
  {
  }
  using Result = vtkSmartPointer<vtkPolyData>;

  Result operator()(const ParallelLight& lamp) const
  {
    return Arrow(this->Glyph.position, lamp.direction, this->Glyph.size);
  }
  Result operator()(const PointLamp& lamp) const
  {
    return Ball(lamp.position, this->Glyph.size / 2.0);
  }
  Result operator()(const LambertianPointLamp& lamp) const
  {
    return Arrow(lamp.position, lamp.direction, this->Glyph.size);
  }
  Result operator()(const SpotLamp& lamp) const
  {
    // Half-angles above 90 degrees leave out a cone behind the lamp.
    const double height = std::cos(lamp.halfAngle);
    vtkNew<vtkConeSource> cone;
    cone->SetHeight(std::fabs(height));
    cone->SetRadius(std::sin(lamp.halfAngle));
    cone->SetDirection(0.0, 0.0, height < 0.0 ? -1.0 : 1.0);
    cone->SetCenter(0.0, 0.0, -height / 2.0);
    cone->SetResolution(Sides);
    cone->CappingOff();
    cone->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    const Result spot = Placed(cone, this->Glyph.size, lamp.position, lamp.direction);
    AddAim(spot, lamp.position, Unit(lamp.direction), this->Glyph.size);
    return spot;
  }
  Result operator()(const RectangleLamp& lamp) const
  {
    if (lamp.width == 0.0 && lamp.height == 0.0)
    {
      return Arrow(lamp.centre, lamp.direction, this->Glyph.size);
    }
    const auto axes = lamp.Axes();
    const glm::dvec3 width = axes.width * (lamp.width / 2.0);
    const glm::dvec3 height = axes.height * (lamp.height / 2.0);

    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const glm::dvec3& corner :
      { -width - height, width - height, width + height, height - width })
    {
      const glm::dvec3 point = lamp.centre + corner;
      points->InsertNextPoint(point.x, point.y, point.z);
    }
    const vtkIdType ids[4] = { 0, 1, 2, 3 };
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(4, ids);
    auto panel = Result::New();
    panel->SetPoints(points);
    panel->SetPolys(cells);
    AddAim(panel, lamp.centre, axes.aim, (lamp.width + lamp.height) / 4.0);
    return panel;
  }
  Result operator()(const DiskLamp& lamp) const
  {
    if (lamp.radius == 0.0)
    {
      return Arrow(lamp.centre, lamp.direction, this->Glyph.size);
    }
    const glm::dvec3 aim = Unit(lamp.direction);
    vtkNew<vtkRegularPolygonSource> disk;
    disk->SetNumberOfSides(Sides);
    disk->SetCenter(lamp.centre.x, lamp.centre.y, lamp.centre.z);
    disk->SetNormal(-aim.x, -aim.y, -aim.z); // round which it winds clockwise
    disk->SetRadius(lamp.radius);
    disk->GeneratePolylineOff();
    disk->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    disk->Update();
    AddAim(disk->GetOutput(), lamp.centre, aim, lamp.radius);
    return disk->GetOutput();
  }
  Result operator()(const SphereLamp& lamp) const
  {
    return Ball(lamp.centre, lamp.radius > 0.0 ? lamp.radius : this->Glyph.size / 2.0);
  }
  Result operator()(const LineLamp& lamp) const
  {
    if (lamp.length == 0.0)
    {
      return Arrow(lamp.centre, lamp.axis, this->Glyph.size);
    }
    const glm::dvec3 half = Unit(lamp.axis) * (lamp.length / 2.0);
    const glm::dvec3 from = lamp.centre - half;
    const glm::dvec3 to = lamp.centre + half;
    vtkNew<vtkLineSource> line;
    line->SetPoint1(from.x, from.y, from.z);
    line->SetPoint2(to.x, to.y, to.z);
    line->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    line->Update();
    return line->GetOutput();
  }
  Result operator()(const UniformSky& sky) const
  {
    return Dome(sky.up, sky.wholeSphere, this->Glyph);
  }
  Result operator()(const CieSky& sky) const
  {
    auto dome = Dome(sky.up, false, this->Glyph);
    AddLuminance(dome, sky, this->Glyph.position);
    return dome;
  }
  Result operator()(const PhotometricLamp& lamp) const
  {
    vtkNew<vtkPolyData> solid;
    DrawPhotometricSolid(lamp.solid, 1.0, solid);
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(solid);
    return Placed(producer, this->Glyph.size, lamp.position, lamp.direction, lamp.rotation);
  }
  Result operator()(const EmittingFacets&) const { return Result::New(); }
  Result operator()(const EmittingMesh&) const { return Result::New(); }

private:
  LuminaireGlyph Glyph;
};

} // namespace

vtkSmartPointer<vtkPolyData> LuminaireGeometry(const Lamp& lamp, const LuminaireGlyph& glyph)
{
  return std::visit(Geometry(glyph), lamp);
}

} // namespace Illumination
