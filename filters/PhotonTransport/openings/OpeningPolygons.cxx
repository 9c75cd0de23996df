// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/OpeningPolygons.h"

#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/openings/ConvexCover.h"
#include "PhotonTransport/openings/FlatLoops.h"
#include "PhotonTransport/openings/Patches.h"
#include "PhotonTransport/openings/PolygonTriangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// Sine of the angle up to which facets of a curved pane are covered by one polygon: 25 degrees.
constexpr double PaneTurn = 0.42;

Opening::Triangle InScene(const Scene& scene, const TriangleCorners& corners)
{
  const Placement& placement = scene.GetPlacement();
  return { glm::vec3(placement.PointToScene(corners[0])),
    glm::vec3(placement.PointToScene(corners[1])), glm::vec3(placement.PointToScene(corners[2])) };
}

/// Collects polygons that may be openings.
class Polygons
{
public:
  Polygons(const Surface& surface, const Scene& scene)
    : Described(surface)
    , Prepared(scene)
  {
  }

  void AddHoles()
  {
    const TriangleMesh mesh = this->Mesh();
    for (const FlatLoop& loop : FindFlatLoops(mesh, FindOpenBorder(mesh)))
    {
      const bool refused = std::any_of(loop.facets.begin(), loop.facets.end(),
        [&](std::uint32_t f) { return this->MarkOf(f) == OpeningMark::NoOpening; });
      if (!refused)
      {
        this->Add(TrianglesOfPolygon(loop.corners, loop.normal), loop.normal, OpeningKind::Hole);
      }
    }
  }

  /// Facets that let light straight through, with a mark.
  void AddPanes(OpeningMark mark, OpeningKind kind)
  {
    std::vector<std::uint32_t> panes;
    for (std::uint32_t f = 0; f < this->Described.facets.size(); ++f)
    {
      if (this->MarkOf(f) == mark && PassesStraightOn(this->Described, f))
      {
        panes.push_back(f);
      }
    }
    std::vector<Patch> patches = PatchesOf(this->Mesh(), panes);
    if (patches.size() > MostOpenings)
    {
      patches = PatchesOf(this->Mesh(), panes, PaneTurn);
    }
    for (const Patch& patch : patches)
    {
      const std::vector<TriangleCorners> triangles = this->FacingAlike(patch.facets);
      const ConvexCover cover = CoverOf(triangles);
      this->Add(
        patch.flat ? triangles : cover.triangles, cover.normal, kind, cover.above, cover.below);
    }
  }

  /// From the largest to the smallest.
  std::vector<OpeningPolygon> Sorted()
  {
    std::stable_sort(this->Found.begin(), this->Found.end(),
      [](const OpeningPolygon& a, const OpeningPolygon& b)
      { return a.shape.Area() > b.shape.Area(); });
    return std::move(this->Found);
  }

private:
  TriangleMesh Mesh() const
  {
    const Surface& surface = this->Described;
    return { surface.points, surface.normals, surface.facets, surface.rounding };
  }

  OpeningMark MarkOf(std::uint32_t facet) const
  {
    const std::vector<OpeningMark>& marks = this->Described.openingOfFacet;
    return marks.empty() ? OpeningMark::None : marks[facet];
  }

  TriangleCorners CornersOf(std::uint32_t facet) const
  {
    const glm::uvec3& ids = this->Described.facets[facet];
    const std::vector<glm::dvec3>& points = this->Described.points;
    return { points[ids.x], points[ids.y], points[ids.z] };
  }

  /// Triangles that run the same way round as the first.
  std::vector<TriangleCorners> FacingAlike(const std::vector<std::uint32_t>& facets) const
  {
    const auto across = [](const TriangleCorners& c)
    { return glm::cross(c[1] - c[0], c[2] - c[0]); };
    std::vector<TriangleCorners> triangles;
    for (const std::uint32_t f : facets)
    {
      triangles.push_back(this->CornersOf(f));
      if (glm::dot(across(triangles.back()), across(triangles.front())) < 0.0)
      {
        std::swap(triangles.back()[1], triangles.back()[2]);
      }
    }
    return triangles;
  }

  void Add(const std::vector<TriangleCorners>& triangles, const glm::dvec3& normal,
    OpeningKind kind, double above = 0.0, double below = 0.0)
  {
    std::vector<Opening::Triangle> inScene;
    for (const TriangleCorners& corners : triangles)
    {
      inScene.push_back(InScene(this->Prepared, corners));
    }
    if (!inScene.empty())
    {
      Opening shape = MakeOpening(std::move(inScene), glm::vec3(normal), kind);
      const Placement& placement = this->Prepared.GetPlacement();
      if (shape.Area() > 0.0f) // in single precision
      {
        this->Found.push_back(
          { std::move(shape), static_cast<float>(placement.LengthToScene(above)),
            static_cast<float>(placement.LengthToScene(below)) });
      }
    }
  }

  const Surface& Described;
  const Scene& Prepared;
  std::vector<OpeningPolygon> Found;
};

} // namespace

std::vector<OpeningPolygon> OpeningPolygonsOf(const Surface& surface, const Scene& scene)
{
  Polygons polygons(surface, scene);
  polygons.AddHoles();
  polygons.AddPanes(OpeningMark::Opening, OpeningKind::Marked);
  polygons.AddPanes(OpeningMark::None, OpeningKind::Glass);
  return polygons.Sorted();
}

std::vector<OpeningPolygon> RefusedPolygonsOf(const Surface& surface, const Scene& scene)
{
  Polygons polygons(surface, scene);
  if (!surface.openingOfFacet.empty())
  {
    polygons.AddPanes(OpeningMark::NoOpening, OpeningKind::Marked);
  }
  return polygons.Sorted();
}

bool PassesStraightOn(const Surface& surface, std::size_t facet)
{
  return PassesStraightOn(surface.materials[surface.materialOfFacet[facet]]);
}

} // namespace PhotonTransport
