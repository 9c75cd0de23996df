// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/ranks/ControllerRanks.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <exception>
#include <new>

namespace Illumination
{
namespace
{

/// Thrown on a rank that could have gone on.
struct AnotherRankFailed
{
};

/// MPI counts by int.
constexpr std::size_t MostBytesAtOnce = std::size_t{ 1 } << 28;

} // namespace

std::string MessageOf(const std::function<void()>& work)
{
  try
  {
    work();
    return "";
  }
  catch (const std::bad_alloc&)
  {
    return OutOfMemory;
  }
  catch (const std::exception& thrown)
  {
    const std::string message = thrown.what();
    return message.empty() ? "unknown error" : message;
  }
}

ControllerRanks::ControllerRanks()
{
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  if (all && all->GetNumberOfProcesses() > 1)
  {
    this->Controller.TakeReference(all->PartitionController(0, all->GetLocalProcessId()));
    if (!this->Controller)
    {
      this->Controller = all;
    }
  }
}

ControllerRanks::~ControllerRanks() = default;

std::uint64_t ControllerRanks::Number() const
{
  return this->Controller ? static_cast<std::uint64_t>(this->Controller->GetNumberOfProcesses())
                          : 1;
}

std::uint64_t ControllerRanks::Index() const
{
  return this->Controller ? static_cast<std::uint64_t>(this->Controller->GetLocalProcessId()) : 0;
}

bool ControllerRanks::OneFailed(bool here)
{
  const int own = here ? 1 : 0;
  int any = own;
  if (this->Controller)
  {
    this->Controller->AllReduce(&own, &any, 1, vtkCommunicator::MAX_OP);
  }
  return any != 0;
}

void ControllerRanks::Sum(std::uint64_t* values, std::size_t count)
{
  if (!this->Controller)
  {
    return;
  }
  this->Sums.resize(std::max(this->Sums.size(), count)); // which may fail, so before they meet
  if (this->OneFailed(false))
  {
    throw AnotherRankFailed();
  }
  this->Controller->AllReduce(
    values, this->Sums.data(), static_cast<vtkIdType>(count), vtkCommunicator::SUM_OP);
  std::copy_n(this->Sums.begin(), count, values);
}

std::vector<std::vector<char>> ControllerRanks::Gather(const std::vector<char>& own)
{
  if (!this->Controller)
  {
    return { own };
  }
  std::vector<std::uint64_t> sizes(static_cast<std::size_t>(this->Number()), 0);
  sizes[static_cast<std::size_t>(this->Index())] = own.size();
  this->SumAll(sizes);
  std::vector<std::vector<char>> all;
  for (const std::uint64_t size : sizes)
  {
    all.emplace_back(static_cast<std::size_t>(size));
  }
  std::copy(own.begin(), own.end(), all[static_cast<std::size_t>(this->Index())].begin());
  if (this->OneFailed(false))
  {
    throw AnotherRankFailed();
  }
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    for (std::size_t first = 0; first < all[rank].size(); first += MostBytesAtOnce)
    {
      const std::size_t count = std::min(MostBytesAtOnce, all[rank].size() - first);
      this->Controller->Broadcast(
        all[rank].data() + first, static_cast<vtkIdType>(count), static_cast<int>(rank));
    }
  }
  return all;
}

std::string ControllerRanks::Together(const std::function<void()>& work)
{
  bool anotherFailed = false;
  const std::string message = MessageOf(
    [&]
    {
      try
      {
        work();
        anotherFailed = this->OneFailed(false);
      }
      catch (const AnotherRankFailed&)
      {
        anotherFailed = true;
      }
    });
  const bool failedHere = !message.empty();
  if (failedHere)
  {
    this->OneFailed(true);
  }
  return failedHere || anotherFailed ? this->FirstMessage(failedHere, message) : "";
}

std::string ControllerRanks::FirstMessage(bool failedHere, const std::string& message)
{
  if (!this->Controller)
  {
    return message;
  }
  std::vector<int> failed(static_cast<std::size_t>(this->Number()), 0);
  const int own = failedHere ? 1 : 0;
  this->Controller->AllGather(&own, failed.data(), 1);
  const auto first = static_cast<int>(std::find(failed.begin(), failed.end(), 1) - failed.begin());
  std::string told = message;
  auto size = static_cast<vtkIdType>(told.size());
  this->Controller->Broadcast(&size, 1, first);
  told.resize(static_cast<std::size_t>(size));
  this->Controller->Broadcast(&told[0], size, first);
  const int same = told == message ? 1 : 0;
  int allSame = 0;
  this->Controller->AllReduce(&same, &allSame, 1, vtkCommunicator::MIN_OP);
  return allSame != 0
    ? told
    : "rank " + std::to_string(first) + " of " + std::to_string(this->Number()) + ": " + told;
}

} // namespace Illumination
