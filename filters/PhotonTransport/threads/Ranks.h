// SPDX-License-Identifier: BSD-3-Clause
// Processes that share the work on a scene. How they talk to each other is not known here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace PhotonTransport
{

/// The ranks that work on a run together. Each has the whole scene and calls the same functions in
/// the same order: every function below but Number and Index waits for all ranks. This class
/// itself is one rank, alone.
///
/// All that ranks tell each other are sums of integers, which have the same bits in any order.
class Ranks
{
public:
  /// Sum is called with at most so many values.
  static constexpr std::size_t MostAtOnce = std::size_t{ 1 } << 21;

  virtual ~Ranks() = default;

  virtual std::uint64_t Number() const { return 1; }
  virtual std::uint64_t Index() const { return 0; } ///< In [0, Number()).
  bool AreSeveral() const { return this->Number() > 1; }

  /// Replaces each value by its sum, modulo 2^64, over all ranks.
  virtual void Sum(std::uint64_t* values, std::size_t count);

  /// Whether it is so on any rank.
  bool Any(bool here);
  /// The number that the first rank gives.
  double OfFirst(double here);
  /// The least of the numbers that ranks give.
  std::uint64_t Least(std::uint64_t here);

  /// The same as Sum for what consists of unsigned or signed integers of 64 bits, or of smaller
  /// ones whose sums do not overflow. Other values come out as they are if all ranks but one have
  /// zero bits there.
  template <typename Value>
  void SumAll(std::vector<Value>& values, std::size_t first = 0)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    this->SumBytes(values.data() + first, (values.size() - first) * sizeof(Value));
  }
  template <typename Value>
  void SumOne(Value& value)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    this->SumBytes(&value, sizeof(Value));
  }

private:
  void SumBytes(void* bytes, std::size_t count);
};

} // namespace PhotonTransport
