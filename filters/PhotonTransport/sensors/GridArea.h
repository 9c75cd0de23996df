// SPDX-License-Identifier: BSD-3-Clause
// The area over which a grid of sensors lies, in plan.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace PhotonTransport
{

using AreaTriangle = std::array<glm::dvec3, 3>;

/// In the plane: two coordinates, and the height as the third.
struct GridPlan
{
  glm::dvec3 u, v, up;
  glm::dvec3 ToPlan(const glm::dvec3& p) const
  {
    return { glm::dot(p, this->u), glm::dot(p, this->v), glm::dot(p, this->up) };
  }
  glm::dvec3 FromPlan(const glm::dvec3& p) const
  {
    return p.x * this->u + p.y * this->v + p.z * this->up;
  }
};

inline double CrossInPlan(const glm::dvec3& a, const glm::dvec3& b)
{
  return a.x * b.y - a.y * b.x;
}

struct GridEdge
{
  glm::dvec3 from, to;
};

inline double DistanceTo(const GridEdge& edge, const glm::dvec3& point)
{
  const glm::dvec2 along(edge.to - edge.from), way(point - edge.from);
  const double length2 = glm::dot(along, along);
  const double place = length2 > 0.0 ? std::clamp(glm::dot(way, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(way - place * along);
}

/// Triangles in a plan, counter-clockwise.
class GridArea
{
public:
  GridArea(const std::vector<AreaTriangle>& triangles, const GridPlan& plan)
  {
    for (const AreaTriangle& triangle : triangles)
    {
      AreaTriangle flat{ plan.ToPlan(triangle[0]), plan.ToPlan(triangle[1]),
        plan.ToPlan(triangle[2]) };
      if (CrossInPlan(flat[1] - flat[0], flat[2] - flat[0]) < 0.0)
      {
        std::swap(flat[1], flat[2]);
      }
      this->Triangles.push_back(flat);
      for (const glm::dvec3& corner : flat)
      {
        this->Low = glm::min(this->Low, corner);
        this->High = glm::max(this->High, corner);
      }
    }
  }

  glm::dvec3 Low{ std::numeric_limits<double>::max() };
  glm::dvec3 High{ std::numeric_limits<double>::lowest() };

  /// The height of the area at a point of the plan, or nothing beside it.
  std::optional<double> HeightAt(const glm::dvec3& point) const
  {
    std::optional<double> lowest;
    for (const AreaTriangle& t : this->Triangles)
    {
      const double a = CrossInPlan(t[2] - t[1], point - t[1]);
      const double b = CrossInPlan(t[0] - t[2], point - t[2]);
      const double c = CrossInPlan(t[1] - t[0], point - t[0]);
      const double sum = a + b + c;
      const double least = -1e-12 * sum; // a point on an edge belongs to both its triangles
      if (sum > 0.0 && a >= least && b >= least && c >= least)
      {
        const double height = (a * t[0].z + b * t[1].z + c * t[2].z) / sum;
        lowest = std::min(height, lowest.value_or(height));
      }
    }
    return lowest;
  }

  /// Edges beyond which there is nothing. An edge that is there once may also be a seam, all along
  /// or in part: it is cut where corners lie on it, and each piece is looked at by itself.
  std::vector<GridEdge> Outline() const
  {
    const double size = glm::length(this->High - this->Low);
    std::vector<GridEdge> outline;
    for (const GridEdge& single : this->SingleEdges())
    {
      for (const GridEdge& piece : this->Pieces(single, 1e-7 * size))
      {
        const glm::dvec3 along = piece.to - piece.from;
        const double length = std::hypot(along.x, along.y);
        const glm::dvec3 beyond = 0.5 * (piece.from + piece.to) +
          (length > 0.0 ? 1e-5 * size / length : 0.0) * glm::dvec3(along.y, -along.x, 0.0);
        if (!this->HeightAt(beyond))
        {
          outline.push_back(piece);
        }
      }
    }
    return outline;
  }

private:
  std::vector<GridEdge> SingleEdges() const
  {
    const auto less = [](const glm::dvec3& a, const glm::dvec3& b)
    { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    const auto lessEdge = [less](const GridEdge& a, const GridEdge& b)
    { return less(a.from, b.from) || (!less(b.from, a.from) && less(a.to, b.to)); };
    std::map<GridEdge, int, decltype(lessEdge)> edges(lessEdge); // by how often it is there
    for (const AreaTriangle& t : this->Triangles)
    {
      for (int c = 0; c < 3; ++c)
      {
        const GridEdge edge{ t[c], t[(c + 1) % 3] };
        const auto twin = edges.find(GridEdge{ edge.to, edge.from });
        twin != edges.end() ? ++twin->second : ++edges[edge];
      }
    }
    std::vector<GridEdge> single;
    for (const auto& [edge, number] : edges)
    {
      if (number == 1)
      {
        single.push_back(edge);
      }
    }
    return single;
  }

  std::vector<GridEdge> Pieces(const GridEdge& edge, double rounding) const
  {
    const glm::dvec3 way = edge.to - edge.from;
    const double length2 = way.x * way.x + way.y * way.y;
    std::vector<double> cuts{ 0.0, 1.0 };
    for (const AreaTriangle& t : this->Triangles)
    {
      for (const glm::dvec3& corner : t)
      {
        const glm::dvec3 to = corner - edge.from;
        const double place = (to.x * way.x + to.y * way.y) / length2;
        if (place > 0.0 && place < 1.0 && DistanceTo(edge, corner) < rounding)
        {
          cuts.push_back(place);
        }
      }
    }
    std::sort(cuts.begin(), cuts.end());
    std::vector<GridEdge> pieces;
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
      if (cuts[i] > cuts[i - 1])
      {
        pieces.push_back({ edge.from + cuts[i - 1] * way, edge.from + cuts[i] * way });
      }
    }
    return pieces;
  }

  std::vector<AreaTriangle> Triangles;
};

} // namespace PhotonTransport
