// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/GatheringMemory.h"

#include "PhotonTransport/gathering/LightPieces.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// What each cell has values of.
struct Kinds
{
  std::uint64_t replicates, threads, channels, lamps;
  std::uint64_t parts; ///< 2 if caustics are counted apart.
};

/// How a facet is divided and how long its cells may be, the list of the rings of its vertices, and
/// its material.
constexpr std::uint64_t PerFacet =
  4 * sizeof(std::uint32_t) + sizeof(float) + 3 * sizeof(std::uint32_t) + sizeof(std::uint32_t);

/// The ends of rings while they are made.
constexpr std::uint64_t PerVertex = 2 * sizeof(std::uint64_t);

/// A triangle that shines: its piece, two nodes of the hierarchy, its place in their order and the
/// flux up to it. The list of pieces grows before there is a hierarchy, which takes more.
constexpr std::uint64_t PerPiece = sizeof(LightPiece) +
  2 * (sizeof(LightBounds) + 2 * sizeof(std::uint32_t)) + sizeof(std::uint32_t) + sizeof(double);

/// The scene is not made yet: materials count that no facet may have.
bool MayHaveCaustics(const Surface& surface, const TraceSettings& settings)
{
  return std::any_of(surface.materials.begin(), surface.materials.end(),
    [&](const Material& material)
    { return (ScatteringsOf(material) & settings.scatterings & ~DiffuseScatterings) != 0; });
}

/// What is counted stays. Threads have counts of their own, and lamps have them once more. The
/// exitance is there while light is gathered.
PhaseBytes PerCell(const Kinds& kinds)
{
  constexpr std::uint64_t Sides = 2;
  const std::uint64_t values = Sides * kinds.channels * kinds.parts;
  const std::uint64_t known = Sides * (sizeof(std::uint8_t) + sizeof(float));
  PhaseBytes bytes;
  bytes.always = sizeof(std::uint32_t) * values * (kinds.replicates + kinds.lamps);
  bytes.tracing = sizeof(std::uint32_t) * values * kinds.threads * (kinds.lamps + 1);
  bytes.gathering = sizeof(float) * values * (kinds.replicates + kinds.lamps) + known;
  return bytes;
}

/// The map of one side, beside which the next one is made.
PhaseBytes PerVertexOfMap(const Kinds& kinds)
{
  const std::uint64_t colour = kinds.channels > 1 ? kinds.channels : 0;
  PhaseBytes bytes;
  bytes.always = sizeof(double) * (3 + colour + kinds.lamps);
  bytes.gathering = bytes.always + sizeof(std::uint8_t);
  return bytes;
}

std::uint64_t PiecesOf(const Lamp& lamp, const Surface& surface)
{
  const auto* mesh = std::get_if<EmittingMesh>(&lamp);
  const auto shines = [](const Colour& exitance) { return exitance != Colour(0.0f); };
  return std::holds_alternative<EmittingFacets>(lamp)
    ? static_cast<std::uint64_t>(
        std::count_if(surface.exitance.begin(), surface.exitance.end(), shines))
    : mesh ? mesh->facets.size()
           : 1;
}

} // namespace

GatheringNeed GatheringMemory(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings, bool colour)
{
  if (settings.method != Method::FinalGathering)
  {
    return {};
  }
  const Kinds kinds{ settings.replicates, static_cast<std::uint64_t>(ThreadCount(settings.threads)),
    colour ? LightLayers::Channels : 1, settings.lampsApart ? lighting.luminaires.size() : 0,
    MayHaveCaustics(surface, settings) ? 2u : 1u };
  const std::uint64_t sides = settings.registerBackSide ? 2 : 1;
  const std::uint64_t onMap =
    surface.IsRefined() ? surface.given.points : std::uint64_t{ surface.points.size() };
  const PhaseBytes ofMap = PerVertexOfMap(kinds);
  PhaseBytes whole;
  whole.always = surface.facets.size() * PerFacet + surface.points.size() * PerVertex +
    onMap * sides * ofMap.always;
  whole.gathering = onMap * sides * ofMap.gathering;
  for (const Luminaire& luminaire : lighting.luminaires)
  {
    whole.always += PiecesOf(luminaire.lamp, surface) * PerPiece;
  }
  return { whole, PerCell(kinds) };
}

} // namespace PhotonTransport
