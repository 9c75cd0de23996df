// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/ScaleSelection.h"

#include "PhotonTransport/filtration/CandidateMaps.h"
#include "PhotonTransport/filtration/RelativeRisk.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace PhotonTransport
{
namespace
{

constexpr std::size_t NoiseColumn = Candidates; ///< Variance of the map itself.

/// Risks are means over a neighbourhood. The first choice, which has only the noisy map to compare
/// with, needs a wide one, and takes the word of a near one only where the difference is plain.
constexpr double FirstPool = 16.0;
constexpr double NearPool = 4.0;
constexpr float PlainDifference = 0.2f; ///< Of the noise's variance.
/// The second choice compares with the first, and can look closer.
constexpr double SecondPool = 2.0;
/// Weights of candidates change no faster than this from vertex to vertex.
constexpr double BlendPool = 2.0;
/// The second choice may not raise the first one's risk by more than this share of the noise.
constexpr float Veto = 0.1f;

/// Estimated squared errors of the candidates from the map alone.
CandidateColumns RisksAgainstMap(const CandidateMaps& candidates, const SelectionSettings& settings)
{
  CandidateColumns risks(settings.importance.size());
  ForEach(risks.size(),
    [&](std::size_t v)
    {
      const Group& map = candidates.At(0, v);
      const double noise = Variance(map);
      const double importance = settings.importance[v];
      risks[v] = {};
      risks[v][0] = static_cast<float>(importance * settings.strength * noise);
      risks[v][NoiseColumn] = static_cast<float>(importance * noise);
      for (std::size_t k = 1; k < Candidates; ++k)
      {
        const Group& candidate = candidates.At(k, v);
        const double distance = Square(MeanOf(candidate) - MeanOf(map));
        const double correction = 2.0 * Covariance(candidate, map) - noise;
        risks[v][k] = static_cast<float>(importance * (distance + settings.strength * correction));
      }
    });
  return risks;
}

/// The same from a map that is already smooth: E|C - F|^2 = |bias|^2 + var(C - F).
CandidateColumns RisksAgainstFirst(
  const CandidateMaps& candidates, const GroupColumns& first, const SelectionSettings& settings)
{
  CandidateColumns risks(settings.importance.size());
  ForEach(risks.size(),
    [&](std::size_t v)
    {
      risks[v] = {};
      for (std::size_t k = 0; k < Candidates; ++k)
      {
        const Group& candidate = candidates.At(k, v);
        const Group difference = Difference(candidate, first[v]);
        const double noise = Variance(candidate) - Variance(difference);
        risks[v][k] = static_cast<float>(
          settings.importance[v] * (Square(MeanOf(difference)) + settings.strength * noise));
      }
    });
  return risks;
}

using Choice = std::vector<std::uint8_t>;

/// The candidate of least risk at each vertex among those that `admits` admits.
template <typename Admits>
Choice LeastRisk(const CandidateColumns& risks, const Admits& admits)
{
  Choice choice(risks.size(), 0);
  ForEach(risks.size(),
    [&](std::size_t v)
    {
      std::size_t best = Candidates;
      for (std::size_t k = 0; k < Candidates; ++k)
      {
        if (admits(k, v) && (best == Candidates || risks[v][k] < risks[v][best]))
        {
          best = k;
        }
      }
      choice[v] = static_cast<std::uint8_t>(best == Candidates ? 0 : best);
    });
  return choice;
}

/// Risks over the wide neighbourhood, or over the near one where that rejects the wide one's
/// choice.
CandidateColumns FirstRisks(const SmoothingGraph& graph, CandidateColumns risks,
  const Admission& admission, const FiltrationMonitor& monitor)
{
  std::vector<CandidateColumns> pooled = Apply<12>(graph,
    { SpectralFilter::Heat(FirstPool), SpectralFilter::Heat(NearPool) }, std::move(risks), monitor);
  CandidateColumns& wide = pooled[0];
  const CandidateColumns& near = pooled[1];
  const auto admits = [&](std::size_t k, std::size_t v) { return Admits(admission, k, v); };
  const Choice choiceOfWide = LeastRisk(wide, admits);
  const Choice choiceOfNear = LeastRisk(near, admits);
  ForEach(wide.size(),
    [&](std::size_t v)
    {
      const float loss = near[v][choiceOfWide[v]] - near[v][choiceOfNear[v]];
      if (loss > PlainDifference * near[v][NoiseColumn])
      {
        wide[v] = near[v];
      }
    });
  return std::move(wide);
}

/// The share of each candidate at a vertex, from the pooled choices of its neighbourhood. It has no
/// share of a candidate that its neighbours may have and itself may not: its choice takes that.
CandidateColumns::value_type Shares(CandidateColumns::value_type pooled, std::size_t choice,
  const Admission& admission, std::size_t v)
{
  float sum = 0.0f;
  for (std::size_t k = 0; k < Candidates; ++k)
  {
    pooled[k] = std::max(0.0f, pooled[k]); // the pool is a polynomial
    sum += pooled[k];
  }
  for (std::size_t k = 0; k < Candidates; ++k)
  {
    if (k != choice && !Admits(admission, k, v))
    {
      pooled[choice] += std::exchange(pooled[k], 0.0f);
    }
  }
  for (std::size_t k = 0; k < Candidates; ++k)
  {
    pooled[k] /= sum;
  }
  return pooled;
}

/// The chosen candidates with soft seams between them.
Selection Blend(const SmoothingGraph& graph, const CandidateMaps& candidates, const Choice& choice,
  const Admission& admission, const FiltrationMonitor& monitor)
{
  CandidateColumns weights(choice.size());
  ForEach(choice.size(),
    [&](std::size_t v)
    {
      weights[v] = {};
      weights[v][choice[v]] = 1.0f;
    });
  weights = Pool(graph, BlendPool, std::move(weights), monitor);
  Selection selection{ GroupColumns(choice.size()), std::vector<double>(choice.size(), 0.0),
    std::vector<float>(choice.size(), 0.0f) };
  ForEach(choice.size(),
    [&](std::size_t v)
    {
      const Group& map = candidates.At(0, v);
      const auto shares = Shares(weights[v], choice[v], admission, v);
      selection.groups[v] = map;
      for (std::size_t k = 1; k < Candidates; ++k)
      {
        const Group change = Difference(candidates.At(k, v), map);
        for (std::size_t g = 0; g < Groups; ++g)
        {
          selection.groups[v][g] += shares[k] * change[g];
        }
        selection.change[v] += double{ shares[k] } * MeanOf(change);
        selection.width[v] += shares[k] * static_cast<float>(std::sqrt(2.0 * KernelTimes[k - 1]));
      }
    });
  return selection;
}

} // namespace

Selection SelectWidths(const SmoothingGraph& graph, const GroupColumns& map,
  const PhotonNoise& photons, const SelectionSettings& settings, const FiltrationMonitor& monitor)
{
  const CandidateMaps candidates(graph, map, monitor);
  const Admission admission =
    AdmitByRelativeRisk(graph, candidates, photons, settings.strength, monitor);
  const CandidateColumns risks =
    FirstRisks(graph, RisksAgainstMap(candidates, settings), admission, monitor);
  const Choice firstChoice =
    LeastRisk(risks, [&](std::size_t k, std::size_t v) { return Admits(admission, k, v); });
  const Selection first = Blend(graph, candidates, firstChoice, admission, monitor);

  const CandidateColumns closer =
    Pool(graph, SecondPool, RisksAgainstFirst(candidates, first.groups, settings), monitor);
  const auto admits = [&](std::size_t k, std::size_t v)
  {
    return Admits(admission, k, v) &&
      risks[v][k] <= risks[v][firstChoice[v]] + Veto * risks[v][NoiseColumn];
  };
  return Blend(graph, candidates, LeastRisk(closer, admits), admission, monitor);
}

} // namespace PhotonTransport
