// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/MeshNotes.h"

#include "Illumination/map/SceneBlocks.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/pipeline/Text.h"

#include "PhotonTransport/geometry/SharpEdges.h"
#include "PhotonTransport/geometry/TriangleArea.h"
#include "PhotonTransport/scene/FacetSide.h"
#include "PhotonTransport/scene/Scene.h"

#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace Illumination
{
namespace
{

using PhotonTransport::Surface;

void AddNotesOnCells(std::vector<std::string>& notes, const SceneBlock& block)
{
  const auto add = [&](const LeftOut& leftOut, const char* what, const char* why)
  {
    if (leftOut.number > 0)
    {
      notes.push_back(Text(leftOut.number, what, ", the first being ",
        NameOfCell(block.data, leftOut.first, block.name), ", ", why));
    }
  };
  if (block.normalsWereComputed)
  {
    notes.push_back("the points" + block.name + " had no normals; they were computed");
  }
  add(block.ghosts, " cells",
    "are duplicate, refined or hidden ones (vtkGhostType): they are not part of the scene");
  add(block.uncut, " polygons", "cross or touch themselves: they were left out, at least in part");
  add(block.withoutArea, " triangles or polygons", "have no area and were left out");
  if (block.ownerlessGhosts > 0)
  {
    notes.push_back(Text(block.ownerlessGhosts, " points, the first being ",
      NameOfPoint(block.data, block.firstOwnerlessGhost, block.name),
      ", belong to duplicate cells only (vtkGhostType) and their owners are not in the input: they "
      "were left out, at 0 lx"));
  }
}

/// Normals that do not tell a front.
void AddNoteOnPlaneNormals(std::vector<std::string>& notes, const SceneBlocks& blocks,
  const PhotonTransport::SceneNotes& found)
{
  const PhotonTransport::Finding& facets = found.undecidedFacets;
  const PhotonTransport::Finding& points = found.inPlaneNormals;
  if (facets.number == 0 && points.number == 0)
  {
    return;
  }
  std::string who;
  if (facets.number > 0)
  {
    who = Text(facets.number, " triangles, the first in ", blocks.NameOfFacet(facets.first));
  }
  if (points.number > 0)
  {
    who += Text(who.empty() ? "" : ", and ", points.number, " points, the first being ",
      blocks.NameOfVertex(points.first));
  }
  notes.push_back(who +
    ", have point normals that lie in the triangles' own plane or cancel, and so do not tell the "
    "front: the side round which the corners run counter-clockwise stands in; compute the normals "
    "anew by Generate Surface Normals, or remove them");
}

/// A block's triangles by the points of the input, and their unit normals on their fronts.
struct BlockFacets
{
  std::vector<glm::uvec3> points;
  std::vector<glm::vec3> normals;
};

BlockFacets FacetsOf(const SceneBlock& block, const Surface& surface)
{
  // The direction of a lower triangle is more rounding than shape.
  constexpr double Rounding = 1e-5;
  BlockFacets facets;
  for (std::size_t f = 0; f < block.cellOfFacet.size(); ++f)
  {
    const glm::uvec3& ids = surface.facets[block.firstFacet + f];
    const auto point = [&](unsigned vertex)
    { return static_cast<unsigned>(block.pointOfVertex[vertex - block.firstVertex]); };
    facets.points.emplace_back(point(ids.x), point(ids.y), point(ids.z));
    const glm::dvec3 &a = surface.points[ids.x], &b = surface.points[ids.y],
                     &c = surface.points[ids.z];
    if (!PhotonTransport::HasArea(a, b, c, Rounding))
    {
      facets.normals.emplace_back(0.0f);
      continue;
    }
    const glm::dvec3 normal =
      glm::cross(PhotonTransport::UsableNormal(b - a), PhotonTransport::UsableNormal(c - a));
    const bool turned = PhotonTransport::SideOf(
      normal, { surface.normals[ids.x], surface.normals[ids.y], surface.normals[ids.z] })
                          .turned;
    facets.normals.emplace_back((turned ? -1.0 : 1.0) * PhotonTransport::UsableNormal(normal));
  }
  return facets;
}

/// Points that stand for the light of several sides.
void AddNoteOnSharedPoints(std::vector<std::string>& notes, const SceneBlocks& blocks)
{
  // Coarse shapes with smooth normals stay below: an octahedron's facets meet at 71 degrees.
  constexpr float CosineOf75Degrees = 0.2588f;
  std::size_t number = 0;
  std::string first;
  for (const SceneBlock& block : blocks.Blocks())
  {
    const BlockFacets facets = FacetsOf(block, blocks.Surface());
    const std::vector<std::uint8_t> shared =
      PhotonTransport::PointsOnSharpEdges(static_cast<std::size_t>(block.data->GetNumberOfPoints()),
        facets.points, facets.normals, CosineOf75Degrees);
    const auto found = std::find(shared.begin(), shared.end(), std::uint8_t{ 1 });
    if (number == 0 && found != shared.end())
    {
      first = NameOfPoint(block.data, found - shared.begin(), block.name);
    }
    number += static_cast<std::size_t>(std::count(found, shared.end(), std::uint8_t{ 1 }));
  }
  if (number > 0)
  {
    notes.push_back(Text(number, " points, the first being ", first,
      ", are shared by facets that meet at more than 75 degrees: their values mix the light of all "
      "these sides; split them by Generate Surface Normals, with Splitting on, before the map is "
      "computed"));
  }
}

} // namespace

std::vector<std::string> NotesOnMesh(
  const SceneBlocks& blocks, const PhotonTransport::SceneNotes& found)
{
  std::vector<std::string> notes;
  for (const SceneBlock& block : blocks.Blocks())
  {
    AddNotesOnCells(notes, block);
  }
  const auto count = [&](std::size_t number, const char* what)
  {
    if (number > 0)
    {
      notes.push_back(Text(number, " ", what));
    }
  };
  count(found.replacedNormals,
    "point normals were zero or not finite; the mean of the facets around the point stands in");
  count(found.turnedFacets,
    "triangles wind against their point normals; the normals decide which side is the front");
  count(found.droppedFacets,
    "triangles are too small, next to the whole scene, to have an area and were left out");
  AddNoteOnPlaneNormals(notes, blocks, found);
  AddNoteOnSharedPoints(notes, blocks);
  return notes;
}

} // namespace Illumination
