// SPDX-License-Identifier: BSD-3-Clause
#ifndef ControllerRanks_h
#define ControllerRanks_h

#include "PhotonTransport/threads/Ranks.h"

#include "vtkSmartPointer.h"

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

class vtkMultiProcessController;

namespace Illumination
{

/// The message where memory ran out.
constexpr const char* OutOfMemory = "out of memory";

/// Calls work(). @return The message of what it has thrown; empty if nothing.
std::string MessageOf(const std::function<void()>& work);

/// The MPI ranks of a ParaView server or pvbatch, by VTK's global controller. Without a controller,
/// or with one of a single process, it is one rank alone.
///
/// All ranks make one at the same time, since messages have a communicator of their own, and
/// destroy it at the same time.
///
/// What waits for all ranks would wait for ever if one of them left early. So ranks meet before
/// each exchange, and one that fails tells the others at the next meeting, whichever that is; see
/// Together.
class ControllerRanks : public PhotonTransport::Ranks
{
public:
  ControllerRanks();
  ~ControllerRanks() override;
  ControllerRanks(const ControllerRanks&) = delete;
  ControllerRanks& operator=(const ControllerRanks&) = delete;

  std::uint64_t Number() const override;
  std::uint64_t Index() const override;
  void Sum(std::uint64_t* values, std::size_t count) override;

  /// What each of the ranks has given, by rank.
  std::vector<std::vector<char>> Gather(const std::vector<char>& own);

  /// The same for values that are their bytes.
  template <typename Value>
  std::vector<std::vector<Value>> GatherValues(const std::vector<Value>& own)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* bytes = reinterpret_cast<const char*>(own.data());
    std::vector<std::vector<Value>> values;
    for (const std::vector<char>& given :
      this->Gather(std::vector<char>(bytes, bytes + own.size() * sizeof(Value))))
    {
      values.emplace_back(given.size() / sizeof(Value));
      std::copy(given.begin(), given.end(), reinterpret_cast<char*>(values.back().data()));
    }
    return values;
  }

  /// Calls work(), which throws on all ranks as soon as it has thrown on any: at their next
  /// exchange, or at the end. @return Why it failed, the same on all ranks; empty if it did not. If
  /// it failed for different reasons, that of the first rank that had one, with its number.
  std::string Together(const std::function<void()>& work);

private:
  /// Waits for all ranks. @return Whether one of them has failed.
  bool OneFailed(bool here);
  std::string FirstMessage(bool failedHere, const std::string& message);

  vtkSmartPointer<vtkMultiProcessController> Controller; ///< Null if this rank is alone.
  std::vector<std::uint64_t> Sums;
};

} // namespace Illumination

#endif
