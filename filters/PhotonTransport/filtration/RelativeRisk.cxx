// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/RelativeRisk.h"

#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Columns of the pooled terms after the risks of the candidates.
constexpr std::size_t NoiseColumn = Candidates;
constexpr std::size_t WeightColumn = Candidates + 1;
constexpr std::size_t LightColumn = Candidates + 2;
static_assert(LightColumn < std::tuple_size_v<CandidateColumns::value_type>);

/// Risks are means over this neighbourhood: a row of vertices beside an edge must not vanish in it.
constexpr double RiskPool = 2.0;
/// Share of the map's own noise by which a candidate's risk may exceed the least.
constexpr double Tolerance = 0.6;

/// Mean of the groups but one.
double MeanOfOthers(const Group& x, std::size_t but)
{
  return (MeanOf(x) * static_cast<double>(Groups) - double{ x[but] }) /
    static_cast<double>(Groups - 1);
}

/// One photon (lx) at the mean area of a vertex and its neighbours. By its own area a small vertex
/// in a dark crease, where a single photon is much light, would hardly count beside its neighbours,
/// and what they leak into it would not be seen.
double PhotonOfRing(const SmoothingGraph& graph, const PhotonNoise& photons, std::size_t v)
{
  double areas = 0.0;
  double vertices = 0.0;
  const auto add = [&](std::size_t vertex)
  {
    if (photons.OnePhoton(vertex) > 0.0)
    {
      areas += 1.0 / photons.OnePhoton(vertex);
      vertices += 1.0;
    }
  };
  add(v);
  for (const SmoothingGraph::Edge& edge : graph.At(v))
  {
    if (edge.conductance > 0.0f)
    {
      add(edge.neighbour);
    }
  }
  return vertices > 0.0 ? vertices / areas : 0.0;
}

/// 1 / lx^2, falling as E^(-3/2) in the light E: between the inverse variance of photon noise, 1 /
/// E, by which dim places count little, and the relative error's 1 / E^2, by which single photons
/// in the dark decide. @param photon One photon, lx, > 0.
double RiskWeight(double light, double photon)
{
  return 2.0 / std::sqrt(photon) / std::pow(std::max(light, 0.0) + photon, 1.5);
}

/// Cross-validated risks of the candidates at a vertex. Each group is compared with a candidate
/// made from the others, and weighed by them: a value that is low by chance must not weigh itself
/// up. E (C - X_g)^2 is the candidate's bias^2 + 4/3 var C + 4 var X, of which bias^2 + var C is
/// wanted.
CandidateColumns::value_type RisksAt(const CandidateMaps& candidates, std::size_t v, double photon)
{
  const Group& map = candidates.At(0, v);
  Group weights;
  for (std::size_t g = 0; g < Groups; ++g)
  {
    weights[g] = static_cast<float>(RiskWeight(MeanOfOthers(map, g), photon));
  }
  const double weight = MeanOf(weights);
  const double noise = Variance(map);
  CandidateColumns::value_type risks{};
  for (std::size_t k = 0; k < Candidates; ++k)
  {
    const Group& candidate = candidates.At(k, v);
    double distance = 0.0;
    for (std::size_t g = 0; g < Groups; ++g)
    {
      distance += double{ weights[g] } * Square(MeanOfOthers(candidate, g) - double{ map[g] }) /
        static_cast<double>(Groups);
    }
    risks[k] = static_cast<float>(distance -
      weight *
        (Variance(candidate) / static_cast<double>(Groups - 1) +
          static_cast<double>(Groups) * noise));
  }
  risks[NoiseColumn] = static_cast<float>(weight * noise);
  risks[WeightColumn] = static_cast<float>(weight);
  risks[LightColumn] = static_cast<float>(weight * (std::max(MeanOf(map), 0.0) + photon));
  return risks;
}

/// How much brighter than its dim surroundings a vertex is, >= 1. One that outshines them has more
/// noise than the mean over its neighbourhood says.
double Prominence(const CandidateColumns::value_type& pooled, double light, double photon)
{
  const double around = double{ pooled[LightColumn] };
  const double own = (std::max(light, 0.0) + photon) * double{ pooled[WeightColumn] };
  return around > 0.0 && own > around ? own / around : 1.0;
}

/// Candidates whose risk is at most so much above the least; the map itself if there is none.
std::uint16_t AdmittedAt(const CandidateColumns::value_type& pooled, double excess)
{
  const double least = *std::min_element(pooled.begin(), pooled.begin() + Candidates);
  unsigned bits = 0;
  for (std::size_t k = 0; k < Candidates; ++k)
  {
    bits |= (double{ pooled[k] } <= least + excess ? 1u : 0u) << k;
  }
  return static_cast<std::uint16_t>(bits != 0 ? bits : 1u);
}

} // namespace

Admission AdmitByRelativeRisk(const SmoothingGraph& graph, const CandidateMaps& candidates,
  const PhotonNoise& photons, double strength, const FiltrationMonitor& monitor)
{
  std::vector<double> photonOfRing(candidates.Vertices());
  CandidateColumns risks(candidates.Vertices());
  ForEach(risks.size(),
    [&](std::size_t v)
    {
      photonOfRing[v] = PhotonOfRing(graph, photons, v);
      risks[v] = photonOfRing[v] > 0.0 ? RisksAt(candidates, v, photonOfRing[v])
                                       : CandidateColumns::value_type{};
    });
  risks = Pool(graph, RiskPool, std::move(risks), monitor);
  Admission admission(risks.size());
  ForEach(risks.size(),
    [&](std::size_t v)
    {
      const double prominence = Prominence(risks[v], MeanOf(candidates.At(0, v)), photonOfRing[v]);
      const double noise = double{ risks[v][NoiseColumn] } * Square(prominence);
      admission[v] = AdmittedAt(risks[v], strength * Tolerance * noise);
    });
  return admission;
}

} // namespace PhotonTransport
