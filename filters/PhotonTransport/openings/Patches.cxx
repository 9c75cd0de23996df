// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/Patches.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// Sine of the angle up to which facets lie in one plane.
constexpr double Flat = 1e-3;

/// Zero for a facet without an area.
glm::dvec3 NormalOf(const TriangleMesh& mesh, const glm::uvec3& facet)
{
  const glm::dvec3& a = mesh.points[facet.x];
  const glm::dvec3 across = glm::cross(mesh.points[facet.y] - a, mesh.points[facet.z] - a);
  const double length = glm::length(across);
  return length > 0.0 ? across / length : glm::dvec3(0.0);
}

/// Divides the facets of a mesh.
class PatchDivider
{
public:
  PatchDivider(const TriangleMesh& mesh, double turn)
    : Mesh(mesh)
    , Turn(std::max(turn, Flat))
    , Edges(mesh)
    , Taken(mesh.facets.size(), 0)
  {
    for (const glm::uvec3& facet : mesh.facets)
    {
      this->Normals.push_back(NormalOf(mesh, facet));
    }
  }

  std::vector<Patch> Divide()
  {
    std::vector<Patch> patches;
    for (std::uint32_t first = 0; first < this->Taken.size(); ++first)
    {
      if (this->Taken[first] == 0 && this->Normals[first] != glm::dvec3(0.0))
      {
        patches.push_back(this->PatchWith(first));
      }
    }
    return patches;
  }

private:
  Patch PatchWith(std::uint32_t first)
  {
    Patch patch{ { first }, true };
    this->Taken[first] = 1;
    for (std::size_t i = 0; i < patch.facets.size(); ++i)
    {
      for (std::uint32_t side = 0; side < 3; ++side)
      {
        const FacetEdge own{ patch.facets[i], side };
        this->Edges.ForEachSide(this->Edges.EdgeOf(patch.facets[i], side),
          [&](const FacetEdge& other)
          {
            if (this->Taken[other.facet] == 0 && this->Continues(own, other, first))
            {
              this->Taken[other.facet] = 1;
              patch.facets.push_back(other.facet);
              patch.flat = patch.flat && this->TurnFrom(other.facet, first) <= Flat;
            }
          });
      }
    }
    return patch;
  }

  /// The sine of the angle between the planes of two facets.
  double TurnFrom(std::uint32_t one, std::uint32_t other) const
  {
    return glm::length(glm::cross(this->Normals[one], this->Normals[other]));
  }

  /// Whether the facets face about as the first one does, on both sides of their common edge. Two
  /// sheets of one pane lie on one side.
  bool Continues(const FacetEdge& own, const FacetEdge& other, std::uint32_t first) const
  {
    return this->Normals[other.facet] != glm::dvec3(0.0) &&
      this->TurnFrom(other.facet, first) <= this->Turn &&
      glm::dot(this->Inwards(own), this->Inwards(other)) < 0.0;
  }

  /// From a facet's edge towards its third corner, at right angles to the edge.
  glm::dvec3 Inwards(const FacetEdge& edge) const
  {
    const glm::uvec3& facet = this->Mesh.facets[edge.facet];
    const glm::dvec3& from = this->Mesh.points[facet[(edge.side + 1) % 3]];
    const glm::dvec3& to = this->Mesh.points[facet[(edge.side + 2) % 3]];
    return glm::cross(this->Normals[edge.facet], to - from);
  }

  const TriangleMesh Mesh; // a few references
  double Turn;
  MeshEdges Edges;
  std::vector<glm::dvec3> Normals;
  std::vector<std::uint8_t> Taken;
};

} // namespace

std::vector<Patch> PatchesOf(
  const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets, double turn)
{
  std::vector<glm::uvec3> chosen;
  for (const std::uint32_t f : facets)
  {
    chosen.push_back(mesh.facets[f]);
  }
  std::vector<Patch> patches;
  if (!chosen.empty())
  {
    patches = PatchDivider({ mesh.points, mesh.normals, chosen, mesh.rounding }, turn).Divide();
  }
  for (Patch& patch : patches)
  {
    for (std::uint32_t& f : patch.facets)
    {
      f = facets[f];
    }
  }
  return patches;
}

} // namespace PhotonTransport
