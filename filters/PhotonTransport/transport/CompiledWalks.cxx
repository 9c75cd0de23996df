// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/CompiledWalks.h"

#include <array>
#include <cstddef>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// Flattened: with so many walks in one file, compilers stop inlining what is hot in each.
template <Walk WalkKind, Registration RegistrationKind, bool BackSide>
[[gnu::flatten]] void TraceBlock(const WalkSettings& settings, float weightBound,
  std::uint64_t first, std::uint64_t last, IlluminationSums& sums)
{
  const Registrar<RegistrationKind, BackSide> registrar(settings.scene, weightBound, sums);
  WalkPhotons<WalkKind>(settings, first, last, registrar, sums.balance, sums.arrivals.data());
}

/// Place of a combination in the list of all.
constexpr std::size_t PlaceOf(Walk walk, Registration registration, bool backSide)
{
  return (static_cast<std::size_t>(walk) * Registrations + static_cast<std::size_t>(registration)) *
    2 +
    (backSide ? 1 : 0);
}

template <std::size_t... Places>
constexpr std::array<BlockTracer, sizeof...(Places)> AllWalks(std::index_sequence<Places...>)
{
  return { TraceBlock<static_cast<Walk>(Places / 2 / Registrations),
    static_cast<Registration>(Places / 2 % Registrations), Places % 2 == 1>... };
}

constexpr auto Compiled = AllWalks(std::make_index_sequence<Walks * Registrations * 2>());

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

BlockTracer CompiledWalk(Walk walk, Registration registration, bool backSide)
{
  return Compiled[PlaceOf(walk, registration, backSide)];
}

} // namespace PhotonTransport
