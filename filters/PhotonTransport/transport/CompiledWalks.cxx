// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/CompiledWalks.h"

#include "PhotonTransport/registration/CellRegistrar.h"

#include <array>
#include <cstddef>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// Flattened: with so many walks in one file, compilers stop inlining what is hot in each.
template <Walk WalkKind, Registration RegistrationKind, bool BackSide, bool Cells>
[[gnu::flatten]] void TraceBlock(const WalkSettings& settings, float weightBound,
  std::uint64_t first, std::uint64_t last, IlluminationSums& sums)
{
  const auto walk = [&](const auto& registrar)
  {
    WalkPhotons<WalkKind>(
      settings, first, last, registrar, sums.balances.data(), sums.arrivals.data());
  };
  const float* startWeights = settings.source.StartWeights().data();
  if constexpr (Cells)
  {
    walk(CellRegistrar<RegistrationKind, BackSide>(
      settings.scene, *settings.cells, weightBound, sums, startWeights));
  }
  else
  {
    walk(Registrar<RegistrationKind, BackSide>(settings.scene, weightBound, sums, startWeights));
  }
}

/// Place of a combination in the list of all.
constexpr std::size_t PlaceOf(Walk walk, const RegistrationChoice& choice)
{
  const std::size_t registration =
    static_cast<std::size_t>(walk) * Registrations + static_cast<std::size_t>(choice.registration);
  return registration * 4 + (choice.backSide ? 1 : 0) + (choice.cells ? 2 : 0);
}

template <std::size_t... Places>
constexpr std::array<BlockTracer, sizeof...(Places)> AllWalks(std::index_sequence<Places...>)
{
  return { TraceBlock<static_cast<Walk>(Places / 4 / Registrations),
    static_cast<Registration>(Places / 4 % Registrations), Places % 2 == 1,
    Places / 2 % 2 == 1>... };
}

constexpr auto Compiled = AllWalks(std::make_index_sequence<Walks * Registrations * 4>());

} // namespace

Walk WalkFor(const Effects& effects)
{
  if (effects.present == 0)
  {
    return Walk::Ends;
  }
  if ((effects.present & Transmissions) != 0)
  {
    return Walk::General;
  }
  const bool reflecting = (effects.present & Reflections) != 0 || effects.colouredFacets;
  return reflecting ? Walk::Reflecting : Walk::Diffuse;
}

BlockTracer CompiledWalk(Walk walk, const RegistrationChoice& choice)
{
  return Compiled[PlaceOf(walk, choice)];
}

} // namespace PhotonTransport
