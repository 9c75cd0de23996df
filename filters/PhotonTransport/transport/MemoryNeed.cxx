// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/MemoryNeed.h"

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/refinement/FacetParts.h"
#include "PhotonTransport/refinement/Subdivision.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/SceneRecords.h"
#include "PhotonTransport/threads/Threads.h"

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

/// What Embree takes while it builds: up to 103 measured from 1000 to 2 million facets (3.13).
constexpr std::uint64_t EmbreePerFacet = 128;

/// The Surface itself, and for each facet and vertex the cell and point it comes from.
constexpr std::uint64_t InputPerFacet = sizeof(glm::uvec3) + sizeof(std::int64_t);
constexpr std::uint64_t InputPerVertex = 2 * sizeof(glm::dvec3) + sizeof(std::int64_t);

/// Facets that are traced in parts, of which there are an eighth as many at most: the list, doubled
/// as it grows, and Embree's points, indices and tree.
constexpr std::uint64_t PartsPerFacet =
  (2 * sizeof(FacetPart) + 2 * (3 * sizeof(glm::vec3) + sizeof(glm::uvec3)) + EmbreePerFacet) / 8;

/// Records, area vectors, rings and three lists of indices (one is Embree's); the areas
/// of a ring fill groups of four.
constexpr std::uint64_t ScenePerFacet = sizeof(Facet) + 2 * sizeof(std::uint8_t) +
  sizeof(glm::vec3) + 3 * sizeof(std::uint32_t) + 3 * sizeof(glm::uvec3) +
  3 * sizeof(RingAreas) / 4 + 2 * sizeof(glm::vec3) + 2 * sizeof(std::uint64_t);
/// Records, areas, three lists of offsets, two lists of positions (one is Embree's).
constexpr std::uint64_t ScenePerVertex = sizeof(Vertex) + sizeof(double) +
  3 * sizeof(std::uint64_t) + 2 * sizeof(glm::vec3) + 3 * sizeof(RingAreas) / 4;

/// A part of a facet of a refined surface: what it is a part of, for the surface and for the scene.
/// A point of it that is none of the given ones: the surface's, the record and positions.
constexpr std::uint64_t RefinedPerFacet = sizeof(FacetOrigin) + sizeof(GivenFacet);
constexpr std::uint64_t RefinedPerPoint =
  2 * sizeof(glm::dvec3) + sizeof(Vertex) + 2 * sizeof(glm::vec3) + sizeof(glm::dvec2);

/// A facet that shines, or the shadow of a vertex under parallel light.
constexpr std::uint64_t LampPerFacet = 2 * sizeof(std::uint32_t) + sizeof(double);
constexpr std::uint64_t LampPerVertex = sizeof(glm::dvec2);

/// Of one side: the map (four numbers), the errors that are sorted, and what a filter makes of it
/// (six point arrays and as many on the way to them).
constexpr std::uint64_t MapPerVertex = (4 + 1 + 2 * 6) * sizeof(double);

bool AnyFacetIsColoured(const Surface& surface)
{
  std::size_t facet = 0;
  while (facet < surface.facets.size() && !IsColoured(surface, facet))
  {
    ++facet;
  }
  return facet < surface.facets.size();
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
  const std::uint64_t sides = settings.registerBackSide ? 2 : 1;
  const auto threads = static_cast<std::uint64_t>(ThreadCount(settings.threads));
  const std::uint64_t sumsPerVertex = (settings.replicates + threads) * sides * sizeof(VertexSums);
  const bool colour = SimulatesColour(AnyFacetIsColoured(surface), lighting, settings);
  const std::uint64_t lamps = settings.lampsApart ? lighting.luminaires.size() : 0;
  const std::uint64_t layers = (colour ? LightLayers::Channels : 0) + lamps;
  // Each thread's sums and the whole's, and what a filter makes of them.
  const std::uint64_t layersPerVertex =
    layers * ((threads + 1) * sizeof(FixedPoint) + 3 * sizeof(double));
  const std::uint64_t perVertex = layersPerVertex + InputPerVertex + ScenePerVertex +
    LampPerVertex + sides * MapPerVertex + sumsPerVertex;
  const std::uint64_t perFacet =
    InputPerFacet + ScenePerFacet + EmbreePerFacet + PartsPerFacet + LampPerFacet;
  const std::uint64_t light = surface.materials.size() * (2 * sizeof(Material) + sizeof(Roulette)) +
    surface.materialOfFacet.size() * 3 * sizeof(std::uint32_t) +
    surface.exitance.size() * 2 * sizeof(Colour);
  const std::uint64_t onMap =
    surface.IsRefined() ? surface.given.points : std::uint64_t{ surface.points.size() };
  return onMap * perVertex + (surface.points.size() - onMap) * RefinedPerPoint +
    surface.facets.size() * perFacet + surface.given.origins.size() * RefinedPerFacet + light;
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
    (InputPerFacet + ScenePerFacet + EmbreePerFacet + PartsPerFacet + LampPerFacet +
      RefinedPerFacet + RefinedPerPoint);
  const std::uint64_t memory = limit > 0 ? limit : AvailableMemory().value_or(Most * PerFacet);
  return std::min(Most, memory / PerFacet);
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
