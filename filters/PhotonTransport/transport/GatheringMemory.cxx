// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/GatheringMemory.h"

#include "PhotonTransport/gathering/CellLinks.h"
#include "PhotonTransport/gathering/LightPieces.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/registration/FacetCells.h"
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

/// The ends of rings while they are made, and whether it is done.
constexpr std::uint64_t PerVertex = 2 * sizeof(std::uint64_t) + sizeof(std::uint8_t);

/// The map of caustics. What a filter makes of it takes the place of hits.
constexpr std::uint64_t CausticPerVertex = sizeof(double);

/// A triangle that shines: its piece while the list grows, and two nodes of the hierarchy.
constexpr std::uint64_t PerPiece = 2 * sizeof(LightPiece) +
  2 * (sizeof(LightBounds) + 2 * sizeof(std::uint32_t)) + sizeof(std::uint32_t);

/// The scene is not made yet: materials count that no facet may have.
bool MayHaveCaustics(const Surface& surface, const TraceSettings& settings)
{
  return std::any_of(surface.materials.begin(), surface.materials.end(),
    [&](const Material& material)
    { return (ScatteringsOf(material) & settings.scatterings & ~DiffuseScatterings) != 0; });
}

/// Both sides of a cell.
std::uint64_t PerCell(const Kinds& kinds)
{
  const std::uint64_t values = kinds.channels * kinds.parts;
  const std::uint64_t counts = sizeof(std::uint32_t) * values * (kinds.replicates + kinds.lamps);
  const std::uint64_t exitance = sizeof(std::uint8_t) + sizeof(float) +
    sizeof(float) * values * (kinds.replicates + kinds.lamps);
  return 2 * (counts + exitance);
}

/// Both sides of a cell, while light is traced.
std::uint64_t PerCellOfThreads(const Kinds& kinds)
{
  return 2 * sizeof(std::uint32_t) * kinds.channels * kinds.parts * kinds.threads *
    (kinds.lamps + 1);
}

/// A map of one side. While the next one is made there are two, but no outputs yet, which take
/// more.
std::uint64_t MapPerVertex(const Kinds& kinds)
{
  const std::uint64_t colour = kinds.channels > 1 ? kinds.channels : 0;
  return sizeof(double) * (3 + colour + kinds.lamps);
}

std::uint64_t PiecesOf(const Lamp& lamp, const Surface& surface)
{
  const auto* mesh = std::get_if<EmittingMesh>(&lamp);
  return std::holds_alternative<EmittingFacets>(lamp) ? surface.exitance.size()
    : mesh                                            ? mesh->facets.size()
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
  const std::uint64_t cells = FacetCells::MostFor(surface.facets.size());
  const std::uint64_t sides = settings.registerBackSide ? 2 : 1;
  const std::uint64_t onMap =
    surface.IsRefined() ? surface.given.points : std::uint64_t{ surface.points.size() };
  std::uint64_t need = cells * PerCell(kinds) + surface.facets.size() * PerFacet +
    surface.points.size() * PerVertex + onMap * sides * (MapPerVertex(kinds) + CausticPerVertex);
  bool sky = false;
  for (const Luminaire& luminaire : lighting.luminaires)
  {
    need += PiecesOf(luminaire.lamp, surface) * PerPiece;
    sky = sky || ClassOf(luminaire.lamp) == LampClass::Sky;
  }
  if (sky)
  {
    // What mirrors, gloss and glass send on meets a further facet.
    need +=
      kinds.parts * CellLinks::MemoryNeed(cells, kinds.replicates, kinds.channels, kinds.lamps);
  }
  return { need, cells * PerCellOfThreads(kinds) };
}

} // namespace PhotonTransport
