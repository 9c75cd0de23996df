// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/ReceivedLight.h"

namespace PhotonTransport
{

std::vector<double> SharesOfHalves(const CellExitance& exitance)
{
  std::vector<double> shares = exitance.shareOf;
  double halves[2] = { 0.0, 0.0 };
  for (std::size_t r = 0; r < shares.size(); ++r)
  {
    halves[r % 2] += shares[r];
  }
  for (std::size_t r = 0; r < shares.size(); ++r)
  {
    shares[r] = halves[r % 2] > 0.0 ? shares[r] / halves[r % 2] : 0.0;
  }
  return shares;
}

LightReader::LightReader(const CellExitance& exitance)
  : Exitance(exitance)
  , ShareOfHalf(SharesOfHalves(exitance))
{
}

void LightReader::OnCell(const GatherFlight& flight, std::uint32_t cell, bool front)
{
  this->Add(flight, this->Exitance.leaving.Of(SideIndex(cell, front)));
  if (!this->Light->ofLamps.empty())
  {
    this->AddByLamp(flight, this->Exitance.leavingByLamp.Of(SideIndex(cell, front)));
  }
}

void LightReader::OnFollowed(const GatherFlight& flight, std::uint32_t cell, bool front)
{
  const float* ofCell = this->Exitance.leaving.Of(SideIndex(cell, front));
  double mean = 0.0;
  for (const double share : this->Exitance.shareOf)
  {
    for (int c = 0; c < static_cast<int>(this->Exitance.channels); ++c)
    {
      mean += share * double{ flight.weight[c] } * *ofCell++;
    }
  }
  constexpr float Noisy = 2.0f; // what is found there by one ray is noise for the most part
  this->Followed[flight.ray] = 1;
  this->Expected[flight.ray] += Noisy * static_cast<float>(mean);
}

void LightReader::OnCaustics(const GatherFlight& flight, std::uint32_t cell, bool front)
{
  if (const float* caustics = this->Exitance.caustic.Of(SideIndex(cell, front)))
  {
    this->Add(flight, caustics);
    if (!this->Light->ofLamps.empty())
    {
      this->AddByLamp(flight, this->Exitance.causticByLamp.Of(SideIndex(cell, front)));
    }
  }
}

void LightReader::OnLamp(const GatherFlight& flight, const Colour& lux, std::uint32_t lamp)
{
  const double factor = this->Factors[flight.ray];
  const Colour weighed = flight.weight * lux;
  const double sum = SumOfChannels(weighed);
  this->AddFound(flight, glm::vec2(static_cast<float>(sum)));
  this->Light->channels += factor * glm::dvec3(weighed);
  if (flight.direct)
  {
    this->Light->direct += factor * sum;
  }
  else
  {
    for (double& indirect : this->Light->indirect)
    {
      indirect += factor * sum;
    }
  }
  if (!this->Light->ofLamps.empty())
  {
    this->Light->ofLamps[lamp] += factor * sum;
  }
}

/// The usual case, which the compiler makes vector operations of. @param ofCell [replicate]
void LightReader::AddOneChannel(const GatherFlight& flight, const float* ofCell)
{
  const double factor = double{ this->Factors[flight.ray] } * flight.weight.x;
  const double* share = this->Exitance.shareOf.data();
  const double* ofHalf = this->ShareOfHalf.data();
  double* indirect = this->Light->indirect.data();
  const std::size_t replicates = this->Light->indirect.size();
  double mean = 0.0;
  double halves[2] = { 0.0, 0.0 };
  for (std::size_t r = 0; r < replicates; ++r)
  {
    indirect[r] += factor * ofCell[r];
    mean += share[r] * ofCell[r];
    halves[r % 2] += ofHalf[r] * ofCell[r];
  }
  this->Light->channels.x += factor * mean;
  this->AddFound(flight, flight.weight.x * glm::vec2(halves[0], halves[1]));
}

/// @param ofCell [replicate][channel]
void LightReader::Add(const GatherFlight& flight, const float* ofCell)
{
  if (this->Exitance.channels == 1)
  {
    this->AddOneChannel(flight, ofCell);
    return;
  }
  const double factor = this->Factors[flight.ray];
  glm::dvec2 halves(0.0);
  for (std::size_t r = 0; r < this->Light->indirect.size(); ++r)
  {
    const double share = this->Exitance.shareOf[r];
    for (int c = 0; c < static_cast<int>(this->Exitance.channels); ++c)
    {
      const double lux = double{ flight.weight[c] } * *ofCell++;
      this->Light->indirect[r] += factor * lux;
      this->Light->channels[c] += factor * share * lux;
      halves[static_cast<int>(r % 2)] += this->ShareOfHalf[r] * lux;
    }
  }
  this->AddFound(flight, glm::vec2(halves));
}

/// @param ofCell [channel][lamp]
void LightReader::AddByLamp(const GatherFlight& flight, const float* ofCell)
{
  const double factor = this->Factors[flight.ray];
  for (int c = 0; c < static_cast<int>(this->Exitance.channels); ++c)
  {
    for (double& ofLamp : this->Light->ofLamps)
    {
      ofLamp += factor * double{ flight.weight[c] } * *ofCell++;
    }
  }
}

} // namespace PhotonTransport
