// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/ScaleSelection.h"

#include "PhotonTransport/filtration/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace PhotonTransport
{
namespace
{

using Group = std::array<float, Groups>;

/// Times of the heat kernels; each smooths sqrt(2) times as wide as the one before.
constexpr std::array<double, 8> Times{ 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0 };
constexpr std::size_t Candidates = Times.size() + 1; ///< Number 0 is the map itself.

/// A value for each candidate, and some to spare, at each vertex.
using CandidateColumns = Columns<12>;
static_assert(Candidates < 12);
constexpr std::size_t NoiseColumn = Candidates; ///< Variance of the map itself.

/// Risks are means over a neighbourhood. The first choice, which has only the noisy map to compare
/// with, needs a wide one, and takes the word of a near one only where the difference is plain.
constexpr double FirstPool = 16.0;
constexpr double NearPool = 4.0;
constexpr float PlainDifference = 0.2f; ///< Of the noise's variance.
/// The second choice compares with the first, and can look closer.
constexpr double SecondPool = 2.0;
constexpr double ErrorPool = 64.0;
/// Weights of candidates change no faster than this from vertex to vertex.
constexpr double BlendPool = 2.0;
/// The second choice may not raise the first one's risk by more than this share of the noise.
constexpr float Veto = 0.1f;

std::vector<SpectralFilter> Ladder()
{
  std::vector<SpectralFilter> filters;
  for (const double time : Times)
  {
    filters.push_back(SpectralFilter::TwicedHeat(time));
  }
  return filters;
}

template <std::size_t N>
Columns<N> Pool(const SmoothingGraph& graph, double time, const Columns<N>& values,
  const FiltrationMonitor& monitor)
{
  return std::move(Apply<N>(graph, { SpectralFilter::Heat(time) }, values, monitor).front());
}

/// The map and its smoothed versions.
class CandidateMaps
{
public:
  CandidateMaps(
    const SmoothingGraph& graph, const GroupColumns& map, const FiltrationMonitor& monitor)
    : Map(map)
    , Smoothed(Apply<Groups>(graph, Ladder(), map, monitor))
  {
  }
  const Group& At(std::size_t candidate, std::size_t v) const
  {
    return candidate == 0 ? this->Map[v] : this->Smoothed[candidate - 1][v];
  }

private:
  const GroupColumns& Map;
  std::vector<GroupColumns> Smoothed;
};

Group Difference(const Group& x, const Group& y)
{
  Group difference;
  for (std::size_t g = 0; g < Groups; ++g)
  {
    difference[g] = x[g] - y[g];
  }
  return difference;
}

double Square(double x)
{
  return x * x;
}

/// Estimated squared errors of the candidates from the map alone.
CandidateColumns RisksAgainstMap(const CandidateMaps& candidates, const SelectionSettings& settings)
{
  CandidateColumns risks(settings.importance.size(), CandidateColumns::value_type{});
  ForEach(risks.size(),
    [&](std::size_t v)
    {
      const Group& map = candidates.At(0, v);
      const double noise = Covariance(map, map);
      const double importance = settings.importance[v];
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
  CandidateColumns risks(settings.importance.size(), CandidateColumns::value_type{});
  ForEach(risks.size(),
    [&](std::size_t v)
    {
      for (std::size_t k = 0; k < Candidates; ++k)
      {
        const Group& candidate = candidates.At(k, v);
        const Group difference = Difference(candidate, first[v]);
        const double noise = Covariance(candidate, candidate) - Covariance(difference, difference);
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
CandidateColumns FirstRisks(
  const SmoothingGraph& graph, const CandidateColumns& risks, const FiltrationMonitor& monitor)
{
  const std::vector<CandidateColumns> pooled = Apply<12>(
    graph, { SpectralFilter::Heat(FirstPool), SpectralFilter::Heat(NearPool) }, risks, monitor);
  const CandidateColumns& wide = pooled[0];
  const CandidateColumns& near = pooled[1];
  const auto all = [](std::size_t, std::size_t) { return true; };
  const Choice choiceOfWide = LeastRisk(wide, all);
  const Choice choiceOfNear = LeastRisk(near, all);
  CandidateColumns first(risks.size());
  ForEach(risks.size(),
    [&](std::size_t v)
    {
      const float loss = near[v][choiceOfWide[v]] - near[v][choiceOfNear[v]];
      first[v] = loss > PlainDifference * near[v][NoiseColumn] ? near[v] : wide[v];
    });
  return first;
}

/// The chosen candidates with soft seams between them.
Selection Blend(const SmoothingGraph& graph, const CandidateMaps& candidates, const Choice& choice,
  const FiltrationMonitor& monitor)
{
  CandidateColumns weights(choice.size(), CandidateColumns::value_type{});
  for (std::size_t v = 0; v < choice.size(); ++v)
  {
    weights[v][choice[v]] = 1.0f;
  }
  weights = Pool(graph, BlendPool, weights, monitor);
  Selection selection{ GroupColumns(choice.size()), std::vector<double>(choice.size(), 0.0),
    std::vector<float>(choice.size(), 0.0f) };
  ForEach(choice.size(),
    [&](std::size_t v)
    {
      const Group& map = candidates.At(0, v);
      selection.groups[v] = map;
      float sum = 0.0f;
      for (std::size_t k = 0; k < Candidates; ++k)
      {
        weights[v][k] = std::max(0.0f, weights[v][k]); // the pool is a polynomial
        sum += weights[v][k];
      }
      for (std::size_t k = 1; k < Candidates; ++k)
      {
        const Group change = Difference(candidates.At(k, v), map);
        const float weight = weights[v][k] / sum;
        for (std::size_t g = 0; g < Groups; ++g)
        {
          selection.groups[v][g] += weight * change[g];
        }
        selection.change[v] += double{ weight } * MeanOf(change);
        selection.width[v] += weight * static_cast<float>(std::sqrt(2.0 * Times[k - 1]));
      }
    });
  return selection;
}

} // namespace

double MeanOf(const Group& x)
{
  double sum = 0.0;
  for (const float value : x)
  {
    sum += double{ value };
  }
  return sum / static_cast<double>(Groups);
}

double Covariance(const Group& x, const Group& y)
{
  const double meanX = MeanOf(x);
  const double meanY = MeanOf(y);
  double sum = 0.0;
  for (std::size_t g = 0; g < Groups; ++g)
  {
    sum += (double{ x[g] } - meanX) * (double{ y[g] } - meanY);
  }
  return sum / static_cast<double>(Groups * (Groups - 1));
}

Selection SelectWidths(const SmoothingGraph& graph, const GroupColumns& map,
  const SelectionSettings& settings, const FiltrationMonitor& monitor)
{
  const CandidateMaps candidates(graph, map, monitor);
  const CandidateColumns risks = FirstRisks(graph, RisksAgainstMap(candidates, settings), monitor);
  const Choice firstChoice = LeastRisk(risks, [](std::size_t, std::size_t) { return true; });
  const Selection first = Blend(graph, candidates, firstChoice, monitor);

  const CandidateColumns closer =
    Pool(graph, SecondPool, RisksAgainstFirst(candidates, first.groups, settings), monitor);
  const auto admits = [&](std::size_t k, std::size_t v)
  { return risks[v][k] <= risks[v][firstChoice[v]] + Veto * risks[v][NoiseColumn]; };
  return Blend(graph, candidates, LeastRisk(closer, admits), monitor);
}

std::vector<double> SquaredError(const SmoothingGraph& graph, const GroupColumns& map,
  const GroupColumns& smoothed, const std::vector<float>& importance,
  const FiltrationMonitor& monitor)
{
  Columns<4> terms(map.size(), Columns<4>::value_type{}); // two are used
  ForEach(map.size(),
    [&](std::size_t v)
    {
      const double distance = Square(MeanOf(smoothed[v]) - MeanOf(map[v]));
      const double correction = 2.0 * Covariance(smoothed[v], map[v]) - Covariance(map[v], map[v]);
      terms[v][0] = static_cast<float>(double{ importance[v] } * (distance + correction));
      terms[v][1] =
        static_cast<float>(double{ importance[v] } * Covariance(smoothed[v], smoothed[v]));
    });
  terms = Pool(graph, ErrorPool, terms, monitor);
  std::vector<double> errors(map.size());
  ForEach(map.size(),
    [&](std::size_t v) {
      errors[v] = double{ std::max({ terms[v][0], terms[v][1], 0.0f }) } / double{ importance[v] };
    });
  return errors;
}

} // namespace PhotonTransport
