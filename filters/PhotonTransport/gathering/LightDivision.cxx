// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/LightDivision.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace PhotonTransport
{
namespace
{

/// A box that starts with nothing in it.
struct Extent
{
  glm::dvec3 low{ std::numeric_limits<double>::max() }, high{ -low };

  void Add(const glm::dvec3& from, const glm::dvec3& to)
  {
    this->low = glm::min(this->low, from);
    this->high = glm::max(this->high, to);
  }
  glm::dvec3 Size() const { return this->high - this->low; }
};

/// What pieces cover, and the ways that they face.
struct Group
{
  Extent box, axes;
  std::size_t count = 0;

  void Add(const LightBounds& piece)
  {
    this->box.Add(piece.centre - piece.half, piece.centre + piece.half);
    this->axes.Add(piece.axis, piece.axis);
    ++this->count;
  }
  /// About from how many points, and in how many ways, the group is seen: the area of its box times
  /// the directions of its light, after the surface area orientation heuristic of Conty Estevez and
  /// Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018.
  double Cost() const
  {
    if (this->count == 0)
    {
      return 0.0;
    }
    const glm::dvec3 size = this->box.Size();
    const double area = size.x * size.y + size.y * size.z + size.z * size.x;
    const double ways = 1.0 + std::min(3.0, 1.5 * glm::length(this->axes.Size()));
    return static_cast<double>(this->count) * area * ways;
  }
};

/// By what pieces are divided: their places or the ways that they face, along one axis.
struct Criterion
{
  bool byWay;
  int axis;
  double middle;

  double Of(const LightBounds& piece) const
  {
    return this->byWay ? piece.axis[this->axis] : piece.centre[this->axis];
  }
};

std::array<Criterion, 6> Candidates(const Extent& places, const Extent& ways)
{
  std::array<Criterion, 6> all;
  for (int axis = 0; axis < 3; ++axis)
  {
    all[static_cast<std::size_t>(axis)] = { false, axis,
      0.5 * (places.low[axis] + places.high[axis]) };
    all[static_cast<std::size_t>(axis) + 3] = { true, axis,
      0.5 * (ways.low[axis] + ways.high[axis]) };
  }
  const glm::dvec3 size = places.Size();
  const std::size_t longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::swap(all[0], all[longest]); // of equals the first is taken
  return all;
}

/// Some of the pieces show how a group is best divided.
constexpr std::ptrdiff_t MostLookedAt = 512;

Criterion Best(const std::vector<LightPiece>& pieces, const PieceRange& range)
{
  const std::ptrdiff_t step = (range.end - range.begin) / MostLookedAt + 1;
  const auto forEach = [&](const auto& f)
  {
    for (std::ptrdiff_t i = 0; i < range.end - range.begin; i += step)
    {
      f(pieces[range.begin[i]].bounds);
    }
  };
  Extent places, ways;
  forEach(
    [&](const LightBounds& piece)
    {
      places.Add(piece.centre, piece.centre);
      ways.Add(piece.axis, piece.axis);
    });
  const std::array<Criterion, 6> candidates = Candidates(places, ways);
  std::array<std::array<Group, 2>, 6> groups;
  forEach(
    [&](const LightBounds& piece)
    {
      for (std::size_t c = 0; c < candidates.size(); ++c)
      {
        groups[c][candidates[c].Of(piece) < candidates[c].middle ? 0 : 1].Add(piece);
      }
    });
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    const double cost = groups[c][0].Cost() + groups[c][1].Cost();
    if (groups[c][0].count > 0 && cost < least)
    {
      best = c;
      least = cost;
    }
  }
  return candidates[best];
}

} // namespace

std::uint32_t DividePieces(const std::vector<LightPiece>& pieces, const PieceRange& range)
{
  const Criterion by = Best(pieces, range);
  auto middle = std::stable_partition(
    range.begin, range.end, [&](std::uint32_t p) { return by.Of(pieces[p].bounds) < by.middle; });
  if (middle == range.begin || middle == range.end) // all are in one place
  {
    middle = range.begin + (range.end - range.begin) / 2;
  }
  return static_cast<std::uint32_t>(middle - range.begin);
}

} // namespace PhotonTransport
