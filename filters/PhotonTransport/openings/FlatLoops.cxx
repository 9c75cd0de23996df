// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/FlatLoops.h"

#include "PhotonTransport/openings/CoplanarSegments.h"
#include "PhotonTransport/openings/PlaneGraph.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Sine of the angle within which a facet lies in a plane.
constexpr double InPlane = 0.05;
/// A polygon narrower than this, relative to half its perimeter, is a crack.
constexpr double Narrowest = 1e-3;

/// Some segments of a plane, with the nodes in the plane's own coordinates.
class PlaneBorder
{
public:
  PlaneBorder(const TriangleMesh& mesh, const OpenBorder& border, const CoplanarSegments& flat,
    const std::vector<std::uint32_t>& segmentsAtNode)
    : Mesh(mesh)
    , Border(border)
    , Flat(flat)
    , U(flat.plane.AnyDirection())
    , V(glm::cross(flat.plane.normal, this->U))
  {
    for (const std::uint32_t s : flat.segments)
    {
      this->Ids.push_back(border.segments[s].from);
      this->Ids.push_back(border.segments[s].to);
    }
    std::sort(this->Ids.begin(), this->Ids.end());
    this->Ids.erase(std::unique(this->Ids.begin(), this->Ids.end()), this->Ids.end());
    for (const std::uint32_t id : this->Ids)
    {
      this->Nodes.push_back(this->InPlaneOf(border.nodes[id]));
    }
    for (const std::uint32_t s : flat.segments)
    {
      this->Pieces.push_back(this->PieceOf(border.segments[s]));
    }
    this->CloseChain(segmentsAtNode);
  }

  void AddLoops(std::vector<FlatLoop>& loops) const
  {
    for (const PlaneFace& face : PlaneGraph(this->Nodes, this->Pieces).FreeFaces())
    {
      FlatLoop loop;
      loop.normal = this->Flat.plane.normal;
      for (const std::uint32_t node : face.nodes)
      {
        loop.corners.push_back(this->Border.nodes[this->Ids[node]]);
      }
      for (const std::uint32_t piece : face.pieces)
      {
        if (piece < this->Flat.segments.size())
        {
          loop.facets.push_back(this->Border.segments[this->Flat.segments[piece]].facet);
        }
      }
      if (!IsCrack(loop))
      {
        loops.push_back(std::move(loop));
      }
    }
  }

private:
  glm::dvec2 InPlaneOf(const glm::dvec3& point) const
  {
    const glm::dvec3 from = point - this->Flat.plane.point;
    return { glm::dot(from, this->U), glm::dot(from, this->V) };
  }

  PlanePiece PieceOf(const BorderSegment& segment) const
  {
    const auto local = [&](std::uint32_t id)
    {
      return static_cast<std::uint32_t>(
        std::lower_bound(this->Ids.begin(), this->Ids.end(), id) - this->Ids.begin());
    };
    PlanePiece piece{ local(segment.from), local(segment.to) };
    const glm::dvec3& from = this->Border.nodes[segment.from];
    const glm::dvec3 along = glm::normalize(this->Border.nodes[segment.to] - from);
    glm::dvec3 inFacet(0.0); // to the corner farthest from the segment, at right angles to it
    for (int corner = 0; corner < 3; ++corner)
    {
      const glm::dvec3 to = this->Mesh.points[this->Mesh.facets[segment.facet][corner]] - from;
      const glm::dvec3 beside = to - glm::dot(to, along) * along;
      inFacet = glm::length(beside) > glm::length(inFacet) ? beside : inFacet;
    }
    const glm::dvec3& normal = this->Flat.plane.normal;
    if (std::fabs(glm::dot(inFacet, normal)) <= InPlane * glm::length(inFacet))
    {
      piece.coveredLeft = glm::dot(glm::cross(normal, along), inFacet) > 0.0;
      piece.coveredRight = !piece.coveredLeft;
    }
    return piece;
  }

  /// Joins the two nodes at which the pieces end, if there are two and nothing of the border goes
  /// on elsewhere there, or if the line that joins them runs along the pieces there: a wall's foot
  /// on both sides of a door.
  void CloseChain(const std::vector<std::uint32_t>& segmentsAtNode)
  {
    std::vector<std::uint32_t> count(this->Nodes.size(), 0), last(this->Nodes.size(), 0);
    for (std::uint32_t i = 0; i < this->Pieces.size(); ++i)
    {
      for (const std::uint32_t node : { this->Pieces[i].from, this->Pieces[i].to })
      {
        ++count[node];
        last[node] = i;
      }
    }
    std::vector<std::uint32_t> ends;
    for (std::uint32_t node = 0; node < count.size(); ++node)
    {
      if (count[node] == 1)
      {
        ends.push_back(node);
      }
    }
    const auto isEnd = [&](std::uint32_t node)
    {
      return segmentsAtNode[this->Ids[node]] == 1 ||
        this->RunsAlong(this->Pieces[last[node]], this->Nodes[ends[1]] - this->Nodes[ends[0]]);
    };
    if (ends.size() == 2 && isEnd(ends[0]) && isEnd(ends[1]))
    {
      this->Pieces.push_back({ ends[0], ends[1] });
    }
  }

  bool RunsAlong(const PlanePiece& piece, const glm::dvec2& line) const
  {
    const glm::dvec2 along = this->Nodes[piece.to] - this->Nodes[piece.from];
    constexpr double Alike = 1e-3;
    return std::fabs(along.x * line.y - along.y * line.x) <=
      Alike * glm::length(along) * glm::length(line);
  }

  static bool IsCrack(const FlatLoop& loop)
  {
    glm::dvec3 twiceArea(0.0);
    double perimeter = 0.0;
    for (std::size_t i = 0; i < loop.corners.size(); ++i)
    {
      const glm::dvec3 a = loop.corners[i] - loop.corners.front();
      const glm::dvec3 b = loop.corners[(i + 1) % loop.corners.size()] - loop.corners.front();
      twiceArea += glm::cross(a, b);
      perimeter += glm::distance(a, b);
    }
    const double half = 0.5 * perimeter;
    return !(0.5 * glm::length(twiceArea) > Narrowest * half * half);
  }

  const TriangleMesh& Mesh;
  const OpenBorder& Border;
  const CoplanarSegments& Flat;
  glm::dvec3 U, V;
  std::vector<std::uint32_t> Ids; ///< Nodes of the border, by node of the plane.
  std::vector<glm::dvec2> Nodes;
  std::vector<PlanePiece> Pieces; ///< As the segments; the one that closes a chain is last.
};

} // namespace

std::vector<FlatLoop> FindFlatLoops(const TriangleMesh& mesh, const OpenBorder& border)
{
  std::vector<std::uint32_t> segmentsAtNode(border.nodes.size(), 0);
  for (const BorderSegment& segment : border.segments)
  {
    ++segmentsAtNode[segment.from];
    ++segmentsAtNode[segment.to];
  }
  std::vector<FlatLoop> loops;
  for (const CoplanarSegments& flat : FindCoplanarSegments(border))
  {
    PlaneBorder(mesh, border, flat, segmentsAtNode).AddLoops(loops);
  }
  return loops;
}

} // namespace PhotonTransport
