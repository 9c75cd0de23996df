// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

namespace PhotonTransport
{

/// Four values that are computed side by side. Compilers see that they fit one register; they take
/// longer arrays apart.
struct FourFloats
{
  float values[4];
};

inline FourFloats operator+(FourFloats a, const FourFloats& b)
{
  for (int i = 0; i < 4; ++i)
  {
    a.values[i] += b.values[i];
  }
  return a;
}

inline FourFloats operator-(FourFloats a, const FourFloats& b)
{
  for (int i = 0; i < 4; ++i)
  {
    a.values[i] -= b.values[i];
  }
  return a;
}

inline FourFloats operator*(float factor, FourFloats a)
{
  for (int i = 0; i < 4; ++i)
  {
    a.values[i] *= factor;
  }
  return a;
}

/// The N values of a vertex, four at a time.
template <std::size_t N>
class Row
{
public:
  Row() = default;
  explicit Row(const std::array<float, N>& values)
  {
    for (std::size_t i = 0; i < N / 4; ++i)
    {
      std::memcpy(&this->Fours[i], values.data() + 4 * i, sizeof(FourFloats));
    }
  }
  void StoreTo(std::array<float, N>& values) const
  {
    for (std::size_t i = 0; i < N / 4; ++i)
    {
      std::memcpy(values.data() + 4 * i, &this->Fours[i], sizeof(FourFloats));
    }
  }
  friend Row operator-(Row a, const Row& b)
  {
    for (std::size_t i = 0; i < N / 4; ++i)
    {
      a.Fours[i] = a.Fours[i] - b.Fours[i];
    }
    return a;
  }
  void Add(float factor, const Row& row)
  {
    for (std::size_t i = 0; i < N / 4; ++i)
    {
      this->Fours[i] = this->Fours[i] + factor * row.Fours[i];
    }
  }
  friend Row operator*(float factor, Row row)
  {
    for (FourFloats& four : row.Fours)
    {
      four = factor * four;
    }
    return row;
  }

private:
  static_assert(N % 4 == 0);
  FourFloats Fours[N / 4] = {};
};

} // namespace PhotonTransport
