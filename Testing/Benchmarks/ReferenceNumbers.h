// SPDX-License-Identifier: BSD-3-Clause
// Random numbers of the reference, which has nothing in common with the product's.
#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014,
/// figure 16).
class ReferenceNumbers
{
public:
  explicit ReferenceNumbers(std::uint64_t seed)
    : State(seed)
  {
  }
  std::uint64_t Bits()
  {
    std::uint64_t z = this->State += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double operator()() { return static_cast<double>(this->Bits() >> 11) * 0x1p-53; } ///< [0, 1)

private:
  std::uint64_t State;
};

/// Pairs of numbers that are spread evenly over the unit square, in random order: Sobol's first two
/// dimensions, moved at random (Kollig and Keller, "Efficient Multidimensional Sampling", 2002).
/// @param count A power of two.
inline std::vector<glm::dvec2> EvenPairs(std::size_t count, ReferenceNumbers& random)
{
  const auto turnX = static_cast<std::uint32_t>(random.Bits());
  const auto turnY = static_cast<std::uint32_t>(random.Bits());
  std::vector<glm::dvec2> pairs(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::uint32_t x = turnX, y = turnY;
    std::uint32_t columnX = 1u << 31, columnY = 1u << 31;
    for (std::size_t bits = i; bits != 0; bits >>= 1)
    {
      x ^= (bits & 1u) != 0 ? columnX : 0u;
      y ^= (bits & 1u) != 0 ? columnY : 0u;
      columnX >>= 1;
      columnY ^= columnY >> 1;
    }
    pairs[i] = { x * 0x1p-32, y * 0x1p-32 };
  }
  for (std::size_t i = count; i > 1; --i)
  {
    std::swap(pairs[i - 1], pairs[random.Bits() % i]);
  }
  return pairs;
}

/// What one path draws at one vertex.
struct PathNumbers
{
  glm::dvec2 direction, place, choices;
};

/// The numbers of many paths, vertex by vertex: at their first vertices spread evenly over all
/// paths.
class WaveNumbers
{
public:
  /// @param paths A power of two.
  WaveNumbers(std::size_t paths, std::uint64_t seed)
    : Random(seed)
    , Even(paths)
  {
  }

  /// To be called before the numbers at a vertex are drawn. @param depth Of the vertex, from 0.
  void StartVertex(unsigned depth)
  {
    this->IsEven = depth < EvenDepth;
    if (this->IsEven)
    {
      const auto direction = EvenPairs(this->Even.size(), this->Random);
      const auto place = EvenPairs(this->Even.size(), this->Random);
      const auto choices = EvenPairs(this->Even.size(), this->Random);
      for (std::size_t p = 0; p < this->Even.size(); ++p)
      {
        this->Even[p] = { direction[p], place[p], choices[p] };
      }
    }
  }
  PathNumbers Of(std::size_t path)
  {
    if (this->IsEven)
    {
      return this->Even[path];
    }
    const auto pair = [this]
    {
      const double first = this->Random();
      return glm::dvec2(first, this->Random());
    };
    const glm::dvec2 direction = pair(), place = pair();
    return { direction, place, pair() };
  }
  double Single() { return this->Random(); }

private:
  static constexpr unsigned EvenDepth = 3;
  ReferenceNumbers Random;
  std::vector<PathNumbers> Even;
  bool IsEven = false;
};
