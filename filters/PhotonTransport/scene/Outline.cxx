// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/Outline.h"

#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// By Steele, Lea and Flood's SplitMix64.
std::uint64_t NumberOf(const glm::vec3& point)
{
  std::uint64_t number = 0;
  for (int i = 0; i < 3; ++i)
  {
    const float coordinate = point[i] + 0.0f; // makes 0 of -0
    std::uint32_t bits;
    std::memcpy(&bits, &coordinate, sizeof bits);
    number = (number ^ bits) + 0x9e3779b97f4a7c15u;
    number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9u;
    number = (number ^ (number >> 27)) * 0x94d049bb133111ebu;
    number ^= number >> 31;
  }
  return number;
}

} // namespace

std::vector<std::uint64_t> NumbersOfPlaces(const LargeArray<glm::vec3>& points)
{
  std::vector<std::uint64_t> numbers(points.size());
  ForEach(points.size(), [&](std::size_t p) { numbers[p] = NumberOf(points[p]); });
  return numbers;
}

std::vector<std::uint32_t> Outline::TrianglesAt(const std::vector<PlaneTriangle>& triangles)
{
  this->AddEdges(triangles);
  this->JoinPoints(triangles);
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    const glm::uvec3& corners = this->Facets[triangles[t].facet].vertices;
    const int outside =
      (this->Sums[corners.x] != 0) + (this->Sums[corners.y] != 0) + (this->Sums[corners.z] != 0);
    if (outside > 1)
    {
      found.push_back(t);
    }
  }
  for (const PlaneTriangle& triangle : triangles)
  {
    const glm::uvec3& corners = this->Facets[triangle.facet].vertices;
    this->Sums[corners.x] = this->Sums[corners.y] = this->Sums[corners.z] = 0;
  }
  return found;
}

/// For each point the sum of numbers that stand for the points to which edges lead, less those
/// of the points from which edges come: 0 if every edge is there in both directions.
void Outline::AddEdges(const std::vector<PlaneTriangle>& triangles)
{
  if (this->Sums.empty())
  {
    this->Sums.assign(this->Numbers.size(), 0);
  }
  for (const PlaneTriangle& triangle : triangles)
  {
    glm::uvec3 corners = this->Facets[triangle.facet].vertices;
    if (triangle.turned)
    {
      std::swap(corners.y, corners.z);
    }
    const std::uint64_t a = this->Numbers[corners.x], b = this->Numbers[corners.y],
                        c = this->Numbers[corners.z];
    this->Sums[corners.x] += b - c;
    this->Sums[corners.y] += c - a;
    this->Sums[corners.z] += a - b;
  }
}

/// Points in the same place are one.
void Outline::JoinPoints(const std::vector<PlaneTriangle>& triangles)
{
  std::vector<std::uint32_t> open;
  for (const PlaneTriangle& triangle : triangles)
  {
    const glm::uvec3& corners = this->Facets[triangle.facet].vertices;
    for (int corner = 0; corner < 3; ++corner)
    {
      if (this->Sums[corners[corner]] != 0)
      {
        open.push_back(corners[corner]);
      }
    }
  }
  const auto byPlace = [&](std::uint32_t p, std::uint32_t q)
  { return this->Numbers[p] != this->Numbers[q] ? this->Numbers[p] < this->Numbers[q] : p < q; };
  std::sort(open.begin(), open.end(), byPlace);
  open.erase(std::unique(open.begin(), open.end()), open.end());
  for (auto first = open.begin(); first != open.end();)
  {
    std::uint64_t sum = 0;
    auto last = first;
    for (; last != open.end() && this->Numbers[*last] == this->Numbers[*first]; ++last)
    {
      sum += this->Sums[*last];
    }
    for (; first != last; ++first)
    {
      this->Sums[*first] = sum;
    }
  }
}

} // namespace PhotonTransport
