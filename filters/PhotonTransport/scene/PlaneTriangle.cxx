// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/PlaneTriangle.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace PhotonTransport
{
namespace
{

/// Twice the area of (a, b, p): positive where p is to the left of a -> b.
double Side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p)
{
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Whether an edge of `one` has all of `other` on its outer side, up to a sliver.
bool EdgeDivides(const PlaneTriangle& one, const PlaneTriangle& other, double width)
{
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec2 a(one.corners[i]), b(one.corners[(i + 1) % 3]);
    double inmost = Side(a, b, other.corners[0]);
    inmost = std::max(inmost, Side(a, b, other.corners[1]));
    inmost = std::max(inmost, Side(a, b, other.corners[2]));
    if (inmost <= 0.0 || inmost * inmost <= width * width * glm::dot(b - a, b - a))
    {
      return true;
    }
  }
  return false;
}

} // namespace

PlaneTriangle::PlaneTriangle(
  std::uint32_t f, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int axis)
  : facet(f)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const glm::vec2 p(a[u], a[v]), q(b[u], b[v]), r(c[u], c[v]);
  this->turned = Side(p, q, r) < 0.0;
  this->corners[0] = p;
  this->corners[1] = this->turned ? r : q;
  this->corners[2] = this->turned ? q : r;
  this->low = glm::min(p, glm::min(q, r));
  this->high = glm::max(p, glm::max(q, r));
  const glm::vec3 most = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
  this->reach = std::max({ most.x, most.y, most.z });
}

int BestAxis(const glm::vec3& normal)
{
  const glm::vec3 size = glm::abs(normal);
  return size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
}

bool Meet(const PlaneTriangle& one, const PlaneTriangle& other)
{
  const glm::vec2 common = glm::min(one.high, other.high) - glm::max(one.low, other.low);
  const float width =
    SliverWidth * std::max(one.reach, other.reach) + (one.rounding + other.rounding);
  return common.x > width && common.y > width && !EdgeDivides(one, other, double{ width }) &&
    !EdgeDivides(other, one, double{ width });
}

CommonPart Intersection(const PlaneTriangle& one, const PlaneTriangle& other)
{
  CommonPart common;
  common.corners.assign(one.corners, one.corners + 3);
  std::vector<glm::dvec2> clipped;
  for (int i = 0; i < 3; ++i) // Sutherland and Hodgman's algorithm
  {
    const glm::dvec2 a(other.corners[i]), b(other.corners[(i + 1) % 3]);
    clipped.clear();
    for (std::size_t k = 0; k < common.corners.size(); ++k)
    {
      const glm::dvec2& p = common.corners[k];
      const glm::dvec2& q = common.corners[(k + 1) % common.corners.size()];
      const double sideP = Side(a, b, p), sideQ = Side(a, b, q);
      if (sideP >= 0.0)
      {
        clipped.push_back(p);
      }
      if ((sideP > 0.0 && sideQ < 0.0) || (sideP < 0.0 && sideQ > 0.0))
      {
        clipped.push_back(p + sideP / (sideP - sideQ) * (q - p));
      }
    }
    common.corners.swap(clipped);
  }
  for (std::size_t k = 2; k < common.corners.size(); ++k)
  {
    common.area += 0.5 * Side(common.corners[0], common.corners[k - 1], common.corners[k]);
  }
  return common;
}

TriangleGrid::TriangleGrid(
  const std::vector<PlaneTriangle>& triangles, const std::vector<std::uint32_t>& members)
  : Low(std::numeric_limits<float>::max())
  , Seen(triangles.size(), 0)
{
  glm::vec2 high(std::numeric_limits<float>::lowest());
  for (const std::uint32_t m : members)
  {
    this->Low = glm::min(this->Low, triangles[m].low);
    high = glm::max(high, triangles[m].high);
  }
  this->Size = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(members.size()))), 1, 512);
  const float size = static_cast<float>(this->Size);
  this->Cell = glm::max((high - this->Low) / size, std::numeric_limits<float>::min());
  this->CellsPerUnit = 1.0f / this->Cell;
  const auto cells = static_cast<std::size_t>(this->Size) * static_cast<std::size_t>(this->Size);
  this->Offsets.assign(cells + 1, 0);
  const auto forEach = [&](const auto& f)
  {
    for (const std::uint32_t m : members)
    {
      this->AnyCell(triangles[m],
        [&](std::size_t cell)
        {
          f(cell, m);
          return false;
        });
    }
  };
  forEach([&](std::size_t cell, std::uint32_t) { ++this->Offsets[cell + 1]; });
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    this->Offsets[cell + 1] += this->Offsets[cell];
  }
  this->Members.resize(this->Offsets.back());
  std::vector<std::size_t> next(this->Offsets.begin(), this->Offsets.end() - 1);
  forEach([&](std::size_t cell, std::uint32_t m) { this->Members[next[cell]++] = m; });
}

std::pair<int, int> TriangleGrid::ColumnsOf(const PlaneTriangle& triangle, int row) const
{
  constexpr float Reserve = 0x1p-10f;
  const float bottom = this->Low.y + (static_cast<float>(row) - Reserve) * this->Cell.y;
  const float top = this->Low.y + (static_cast<float>(row + 1) + Reserve) * this->Cell.y;
  // Least and largest x of the part of the triangle that lies in the row.
  glm::vec2 span(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
  for (int i = 0; i < 3; ++i)
  {
    glm::vec2 a = triangle.corners[i], b = triangle.corners[(i + 1) % 3];
    if (a.y > b.y)
    {
      std::swap(a, b);
    }
    if (a.y > top || b.y < bottom)
    {
      continue;
    }
    const auto at = [&](float y) {
      return b.y > a.y ? a.x + std::clamp((y - a.y) / (b.y - a.y), 0.0f, 1.0f) * (b.x - a.x) : a.x;
    };
    const float x1 = at(std::max(bottom, a.y));
    const float x2 = b.y > a.y ? at(std::min(top, b.y)) : b.x;
    span.x = std::min({ span.x, x1, x2 });
    span.y = std::max({ span.y, x1, x2 });
  }
  return this->RangeOf(span.x, span.y, 0);
}

} // namespace PhotonTransport
