// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/PhotonShares.h"

#include "PhotonTransport/materials/Scattering.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace PhotonTransport
{
namespace
{

constexpr std::uint64_t Pilots = 2048; ///< Photons of each source.
constexpr double MostOutdoors = 1.0 / 2.0;
constexpr double LeastOutdoors = 1.0 / 16.0;
constexpr double LeastOfPart = 1.0 / 256.0;
constexpr double LeastWeight = 0x1p-22;

/// What became of pilots, each up to its first hit.
struct Fates
{
  double met = 0.0;        ///< Share of them that met a facet.
  double registered = 0.0; ///< On a side where light registers, or that lets it through.
};

bool Registers(const Scene& scene, const Ray& ray, Hit& hit, bool backSide)
{
  return backSide || glm::dot(ray.direction, scene.Facets()[hit.facet].normal) < 0.0f ||
    scene.PreferFront(ray, hit) ||
    (ScatteringsOf(scene.Materials()[scene.MaterialOfFacet()[hit.facet]]) & Transmissions) != 0;
}

Fates FatesOf(const Scene& scene, const Emitter& emitter, const OpeningPhotons& openings,
  bool backSide, std::uint32_t source)
{
  std::array<Flight, PhotonsTogether> photons;
  std::array<Ray, PhotonsTogether> rays;
  std::array<Hit, PhotonsTogether> hits;
  std::vector<PhotonBalance> balances(emitter.Sources());
  std::vector<Arrivals> arrivals(emitter.Sources());
  PhotonSequence sample({ 0x53686172u, 0, Sampling::Random }, 0);
  Fates fates;
  for (std::uint64_t done = 0; done < Pilots; done += PhotonsTogether)
  {
    for (std::size_t i = 0; i < PhotonsTogether; ++i, sample.Advance())
    {
      const Emission emission = emitter.EmitOf(sample, source);
      rays[i] = emission.ray;
      photons[i] = { sample.Scatterings(), 0, OriginOf(emission) };
    }
    std::size_t count = openings.Start(
      photons.data(), rays.data(), 0, PhotonsTogether, balances.data(), arrivals.data());
    scene.Intersect(rays.data(), hits.data(), count);
    count = openings.HandOver(
      photons.data(), rays.data(), hits.data(), count, balances.data(), arrivals.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      if (hits[i])
      {
        fates.met += 1.0 / Pilots;
        fates.registered += Registers(scene, rays[i], hits[i], backSide) ? 1.0 / Pilots : 0.0;
      }
    }
  }
  return fates;
}

} // namespace

std::vector<double> PhotonShares(
  const Scene& scene, const Emitter& source, const OpeningPhotons& openings, bool backSideRegisters)
{
  std::vector<double> outdoors(source.Sources(), 0.0), others(source.Sources(), 0.0);
  double ofOutdoors = 0.0, ofOthers = 0.0, fluxOutdoors = 0.0, metUsefully = 0.0, unlit = 0.0;
  const auto handsOver = [&](std::uint32_t s)
  { return source.PartOf(s) == LightPart::Whole && source.HandsOver(s, true); };
  for (std::uint32_t s = 0; s < source.Sources(); ++s)
  {
    const double flux = source.FluxOfSource(s);
    if (!(flux > 0.0))
    {
      continue;
    }
    const bool isLamp = source.PartOf(s) == LightPart::Whole && !handsOver(s);
    const Fates fates =
      isLamp ? Fates{ 1.0, 1.0 } : FatesOf(scene, source, openings, backSideRegisters, s);
    if (handsOver(s))
    {
      outdoors[s] = flux;
      fluxOutdoors += flux;
      metUsefully += fates.met > 0.0 ? flux * fates.registered / fates.met : 0.0;
    }
    else
    {
      others[s] = flux * std::sqrt(fates.registered);
      ofOthers += others[s];
      unlit += others[s] > 0.0 ? 0.0 : 1.0;
    }
  }
  ofOutdoors = std::min(fluxOutdoors / source.Flux(),
    std::clamp(
      MostOutdoors * metUsefully / std::max(fluxOutdoors, 1e-300), LeastOutdoors, MostOutdoors));
  std::vector<double> shares(source.Sources(), 0.0);
  const double rest = 1.0 - ofOutdoors - unlit * LeastOfPart;
  for (std::size_t s = 0; s < shares.size(); ++s)
  {
    const double flux = source.FluxOfSource(s);
    const double most = flux / source.Flux() / LeastWeight;
    const double own = others[s] > 0.0 ? rest * others[s] / ofOthers : LeastOfPart;
    shares[s] = outdoors[s] > 0.0 ? ofOutdoors * flux / fluxOutdoors
                                  : (flux > 0.0 ? std::min(most, own) : 0.0);
  }
  return shares;
}

std::vector<double> SharesForLampsApart(const Emitter& source, std::vector<double> shares)
{
  constexpr double Evenly = 1.0 / 20.0;
  if (shares.empty())
  {
    for (std::size_t s = 0; s < source.Sources(); ++s)
    {
      shares.push_back(source.FluxOfSource(s));
    }
  }
  std::vector<double> ofLamp(source.Lamps(), 0.0);
  double all = 0.0;
  for (std::size_t s = 0; s < shares.size(); ++s)
  {
    ofLamp[s % ofLamp.size()] += shares[s];
    all += shares[s];
  }
  const auto shining = static_cast<double>(
    std::count_if(ofLamp.begin(), ofLamp.end(), [](double share) { return share > 0.0; }));
  for (std::size_t s = 0; s < shares.size() && all > 0.0; ++s)
  {
    const double own = ofLamp[s % ofLamp.size()];
    const double most = source.FluxOfSource(s) / source.Flux() / LeastWeight;
    const double even = own > 0.0 ? shares[s] / own / shining : 0.0;
    shares[s] = std::min(most, (1.0 - Evenly) * shares[s] / all + Evenly * even);
  }
  return all > 0.0 ? shares : std::vector<double>();
}

} // namespace PhotonTransport
