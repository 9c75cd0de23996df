// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/MemoryNeed.h"

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/geometry/Placement.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/refinement/FacetParts.h"
#include "PhotonTransport/refinement/Subdivision.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/SceneRecords.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/GatheringMemory.h"
#include "PhotonTransport/transport/SideSums.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace PhotonTransport
{
namespace
{

// Bytes for each facet and vertex. Test: Testing/Stability/FilterMemoryTest measures.

/// What Embree takes while it builds and what it keeps: up to 127 and 95 measured, from 300
/// thousand to 4 million facets (3.13) on 1 to 8 threads, with what the heap keeps of the scene's
/// lists. While it builds no light is summed yet, so only the larger of both counts. Lists with
/// which facets in one place are found take less, and are gone by then.
constexpr std::uint64_t EmbreeBuildsPerFacet = 136;
constexpr std::uint64_t EmbreeKeepsPerFacet = 96;

/// What the heap keeps besides of lists that are freed, as pieces too small for what comes later:
/// up to 42 bytes for each of 100 thousand facets measured. Lists of more than 32 MiB go back to
/// the system as a whole.
std::uint64_t HeapKeeps(std::uint64_t facets)
{
  constexpr std::uint64_t PerFacet = 42;
  constexpr std::uint64_t Most = std::uint64_t{ 1 } << 25;
  return std::min(facets * PerFacet, Most);
}

/// The Surface itself, and for each facet and vertex the cell and point it comes from.
constexpr std::uint64_t InputPerFacet = sizeof(glm::uvec3) + sizeof(std::int64_t);
constexpr std::uint64_t InputPerVertex = 2 * sizeof(glm::dvec3) + sizeof(std::int64_t);

/// A part of a facet that is traced in parts: the list, doubled as it grows, and Embree's points,
/// indices and tree.
constexpr std::uint64_t PerPart =
  2 * sizeof(FacetPart) + 2 * (3 * sizeof(glm::vec3) + sizeof(glm::uvec3)) + EmbreeBuildsPerFacet;

/// Records, area vectors, rings, marks of sheets and shared places.
constexpr std::uint64_t ScenePerFacet = sizeof(Facet) + sizeof(glm::vec3) +
  3 * sizeof(std::uint32_t) + 2 * sizeof(std::uint8_t) + sizeof(float);
/// Records, areas, offsets of rings.
constexpr std::uint64_t ScenePerVertex = sizeof(Vertex) + sizeof(double) + sizeof(std::uint64_t);
/// Embree's copies, where facets are traced in parts.
constexpr std::uint64_t CopiesPerFacet = 2 * sizeof(glm::uvec3);
constexpr std::uint64_t CopiesPerVertex = 2 * sizeof(glm::vec3);

/// A part of a facet of a refined surface: what it is a part of, for the surface and for the scene.
/// A point of it that is none of the given ones: the surface's, the record and positions.
constexpr std::uint64_t RefinedPerFacet =
  sizeof(FacetOrigin) + sizeof(GivenFacet) + 3 * sizeof(glm::vec3);
constexpr std::uint64_t RefinedPerPoint =
  2 * sizeof(glm::dvec3) + sizeof(Vertex) + 2 * sizeof(glm::vec3) + sizeof(glm::dvec2);

/// A facet that shines.
constexpr std::uint64_t LampPerFacet = 2 * sizeof(std::uint32_t) + sizeof(double);

/// Of one side: the map (four numbers).
constexpr std::uint64_t MapPerVertex = 4 * sizeof(double);

/// What a filter makes of the maps: areas by point, eight arrays and five on the way to them; two
/// more of the back.
constexpr std::uint64_t OutputPerVertex = (1 + 8 + 5) * sizeof(double);
constexpr std::uint64_t BackOutputPerVertex = 2 * sizeof(double);

/// While the error of facet size is worked out, before there are outputs: areas, and lists of
/// numbers in use at a time; areas and rings of its own where facets have parts.
constexpr std::uint64_t FacetErrorPerVertex = (1 + 4) * sizeof(double);
constexpr std::uint64_t OwnRingsPerFacet =
  sizeof(glm::uvec3) + sizeof(double) + 3 * sizeof(std::uint32_t);
constexpr std::uint64_t OwnRingsPerVertex = 2 * sizeof(std::uint64_t);

bool AnyFacetIsColoured(const Surface& surface)
{
  std::size_t facet = 0;
  while (facet < surface.facets.size() && !IsColoured(surface, facet))
  {
    ++facet;
  }
  return facet < surface.facets.size();
}

/// Of how many parts facets are at most that are traced in parts: large ones next to the scene's
/// origin, of which most scenes have a few. See PartsOfLargeFacets.
std::uint64_t MostParts(const Surface& surface)
{
  constexpr double Lengths = 1.5 * 1.75; // with a wide reserve
  constexpr std::uint64_t PartsOfOne = 512;
  const glm::dvec3 centre = FitPlacement(surface.points, surface.facets).centre;
  std::uint64_t large = 0;
  for (const glm::uvec3& facet : surface.facets)
  {
    const glm::dvec3 &a = surface.points[facet.x], &b = surface.points[facet.y],
                     &c = surface.points[facet.z];
    const double longest =
      std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
    large += !(Lengths * longest < glm::distance(a, centre));
  }
  return std::min<std::uint64_t>(surface.facets.size() / 8, PartsOfOne * large);
}

std::uint64_t Slots(const Lighting& lighting, const TraceSettings& settings)
{
  return settings.lampsApart ? lighting.luminaires.size() : 1;
}

/// Sums of replicates, and layers with what a filter makes of them.
std::uint64_t SumsPerVertex(const Lighting& lighting, const TraceSettings& settings, bool colour)
{
  const std::uint64_t layers = colour ? LightLayers::ColourLayers : 0;
  const std::uint64_t colours =
    colour ? settings.replicates * LightLayers::Channels * sizeof(FixedPoint) : 0;
  const std::uint64_t arrays =
    layers + (settings.lampsApart ? 2 * std::uint64_t{ lighting.luminaires.size() } : 0);
  const std::uint64_t ofSlot = colours + SideSums::BytesPerSlot(settings.replicates, Groups) +
    (settings.registerBackSide ? SideSums::BytesPerSlot(settings.replicates, 1) : 0) +
    layers * sizeof(FixedPoint);
  return Slots(lighting, settings) * ofSlot + arrays * 3 * sizeof(double);
}

/// Sums of threads, while light is traced.
std::uint64_t ThreadSumsPerVertex(
  const Lighting& lighting, const TraceSettings& settings, bool colour)
{
  const std::uint64_t sides = settings.registerBackSide ? 2 : 1;
  const std::uint64_t layers = colour ? LightLayers::ColourLayers : 0;
  return Slots(lighting, settings) * static_cast<std::uint64_t>(ThreadCount(settings.threads)) *
    (sides * sizeof(VertexSums) + layers * sizeof(FixedPoint));
}

/// The maps, and what is made of them: first the error of facet size, then the outputs.
std::uint64_t NeedOfMaps(const Surface& surface, std::uint64_t onMap, const TraceSettings& settings)
{
  const std::uint64_t sides = settings.registerBackSide ? 2 : 1;
  const std::uint64_t facets = surface.facets.size();
  std::uint64_t facetError = 0;
  if (settings.method == Method::PhotonTracing)
  {
    facetError = onMap * FacetErrorPerVertex;
    facetError += surface.IsRefined() ? facets * OwnRingsPerFacet + onMap * OwnRingsPerVertex : 0;
  }
  const std::uint64_t outputs = onMap * (OutputPerVertex + (sides - 1) * BackOutputPerVertex);
  return onMap * sides * MapPerVertex + std::max(facetError, outputs);
}

double GiB(std::uint64_t bytes)
{
  return static_cast<double>(bytes) * 0x1p-30;
}

/// The number after `key` in a file of the system; nothing if there is none.
std::optional<std::uint64_t> NumberIn(const char* file, const char* key)
{
  std::ifstream in(file);
  std::string word;
  while (*key != '\0' && in >> word && word != key)
  {
  }
  std::uint64_t number = 0;
  return in >> number ? std::optional(number) : std::nullopt;
}

/// Where Linux says what a control group (a container, say) may take: version 2, version 1.
struct ControlGroup
{
  const char *limit, *used, *statistics, *activeFiles, *inactiveFiles;
};
constexpr ControlGroup ControlGroups[] = {
  { "/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current", "/sys/fs/cgroup/memory.stat",
    "active_file", "inactive_file" },
  { "/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes",
    "/sys/fs/cgroup/memory/memory.stat", "total_active_file", "total_inactive_file" }
};

} // namespace

std::uint64_t MemoryNeed(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings)
{
  const std::uint64_t facets = surface.facets.size();
  const std::uint64_t onMap =
    surface.IsRefined() ? surface.given.points : std::uint64_t{ surface.points.size() };
  const std::uint64_t light = surface.materials.size() * (2 * sizeof(Material) + sizeof(Roulette)) +
    surface.materialOfFacet.size() * 3 * sizeof(std::uint32_t) +
    surface.exitance.size() * (2 * sizeof(Colour) + LampPerFacet);
  const std::uint64_t parts = MostParts(surface);
  const std::uint64_t copies =
    parts > 0 ? facets * CopiesPerFacet + surface.points.size() * CopiesPerVertex : 0;
  const std::uint64_t stays = onMap * (InputPerVertex + ScenePerVertex) +
    (surface.points.size() - onMap) * RefinedPerPoint + facets * (InputPerFacet + ScenePerFacet) +
    HeapKeeps(facets) + surface.given.origins.size() * RefinedPerFacet + light + parts * PerPart +
    copies;
  const bool colour = SimulatesColour(AnyFacetIsColoured(surface), lighting, settings);
  const GatheringNeed gathering = GatheringMemory(surface, lighting, settings, colour);
  // Threads give up their sums before maps are made.
  const std::uint64_t tracing =
    onMap * ThreadSumsPerVertex(lighting, settings, colour) + gathering.whileTracing;
  const std::uint64_t running = facets * EmbreeKeepsPerFacet +
    onMap * SumsPerVertex(lighting, settings, colour) + gathering.stays +
    std::max(tracing, NeedOfMaps(surface, onMap, settings));
  return stays + std::max(facets * EmbreeBuildsPerFacet, running);
}

std::optional<std::uint64_t> AvailableMemory()
{
  std::optional<std::uint64_t> available = NumberIn("/proc/meminfo", "MemAvailable:");
  if (!available)
  {
    return std::nullopt;
  }
  *available *= 1024; // given in KiB
  for (const ControlGroup& group : ControlGroups)
  {
    const auto limit = NumberIn(group.limit, ""); // "max" is no number and no limit
    const auto used = NumberIn(group.used, "");
    if (limit && used)
    {
      // What caches files is given up when memory is wanted.
      const std::uint64_t files = NumberIn(group.statistics, group.activeFiles).value_or(0) +
        NumberIn(group.statistics, group.inactiveFiles).value_or(0);
      const std::uint64_t held = *used - std::min(files, *used);
      available = std::min(*available, *limit - std::min(*limit, held));
    }
  }
  return available;
}

std::uint64_t MostRefinedFacets(std::uint64_t limit)
{
  constexpr std::uint64_t Most = 0x7fffffff;
  constexpr std::uint64_t PerFacet = 2 *
    (InputPerFacet + ScenePerFacet + EmbreeBuildsPerFacet + PerPart / 8 + LampPerFacet +
      RefinedPerFacet + RefinedPerPoint);
  const std::uint64_t memory = limit > 0 ? limit : AvailableMemory().value_or(Most * PerFacet);
  return std::min(Most, memory / PerFacet);
}

std::uint64_t MostAdaptiveFacets(std::uint64_t limit, std::uint64_t need)
{
  // The facet before and after it is divided, its edges, the light at their middles, the maps and
  // arrays at the points: half a point and one and a half edges a facet.
  constexpr std::uint64_t PerFacet = 1024;
  constexpr std::uint64_t Most = 0x7fffffff;
  const std::uint64_t left =
    limit > 0 ? limit - std::min(limit, need) : AvailableMemory().value_or(Most * PerFacet);
  return std::clamp<std::uint64_t>(left / PerFacet, 1, Most);
}

void RequireMemory(std::uint64_t need, std::uint64_t limit)
{
  const std::optional<std::uint64_t> most = limit > 0 ? std::optional(limit) : AvailableMemory();
  if (most && need > *most)
  {
    std::ostringstream message;
    message.precision(3);
    message << "the run needs up to " << GiB(need) << " GiB of memory, and "
            << (limit > 0 ? "its limit is " : "the machine has ") << GiB(*most) << " GiB"
            << (limit > 0 ? "" : " available");
    throw InvalidInput(InvalidInput::Where::TraceSettings, 0, message.str());
  }
}

} // namespace PhotonTransport
