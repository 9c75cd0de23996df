// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/MemoryNeed.h"

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/refinement/FacetParts.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/scene/SceneRecords.h"
#include "PhotonTransport/statistics/GroupMeans.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/MemoryLimit.h"
#include "PhotonTransport/transport/SideSums.h"

#include <glm/vec2.hpp>

#include <algorithm>

namespace PhotonTransport
{
namespace
{

// Bytes for each facet and vertex. Test: Testing/Stability/FilterMemoryTest measures.

/// What Embree takes while it builds and what it keeps, up to 110 and 76 measured, from 300
/// thousand to 4 million facets (3.13) on 2 to 16 threads. While it builds no light is summed yet,
/// so only the larger of both counts. Lists with which facets in one place are found take less, and
/// are gone by then.
constexpr std::uint64_t EmbreeBuildsPerFacet = 124;
constexpr std::uint64_t EmbreeKeepsPerFacet = 84;

/// What the heap keeps besides of lists that are freed, as pieces too small for what comes later:
/// up to 30 bytes for each of 30 to 500 thousand facets measured, and 70 for each of 10 thousand.
/// Lists of more than 32 MiB go back to the system as a whole.
std::uint64_t HeapKeeps(std::uint64_t facets)
{
  constexpr std::uint64_t PerFacet = 30;
  constexpr std::uint64_t PerFacetOfFew = 40; // in addition
  constexpr std::uint64_t OfFew = std::uint64_t{ 1 } << 19;
  constexpr std::uint64_t Most = std::uint64_t{ 1 } << 25;
  return std::min(facets * PerFacet + std::min(facets * PerFacetOfFew, OfFew), Most);
}

/// While threads have sums it keeps a part, as large as a 16th of them, of lists from which the
/// sums of replicates were made.
constexpr std::uint64_t HeapKeepsOfSums = 16;
/// What it keeps of the sums that threads give up: up to 0.4 of them measured, with 100 thousand
/// points.
std::uint64_t HeapKeepsOfThreads(std::uint64_t sums)
{
  constexpr std::uint64_t Most = std::uint64_t{ 1 } << 25;
  return std::min(sums, Most) / 2;
}

/// The Surface itself.
constexpr std::uint64_t InputPerFacet = sizeof(glm::uvec3);
constexpr std::uint64_t InputPerVertex = 2 * sizeof(glm::dvec3);

/// A part of a facet that is traced in parts: the list, doubled as it grows, and Embree's points,
/// indices and tree.
constexpr std::uint64_t PerPart =
  2 * sizeof(FacetPart) + 2 * (3 * sizeof(glm::vec3) + sizeof(glm::uvec3)) + EmbreeBuildsPerFacet;

/// Records, area vectors, rings, marks of sheets and shared places.
constexpr std::uint64_t ScenePerFacet = sizeof(Facet) + sizeof(glm::vec3) +
  3 * sizeof(std::uint32_t) + 2 * sizeof(std::uint8_t) + sizeof(float);
/// Records, areas, offsets of rings.
constexpr std::uint64_t ScenePerVertex = sizeof(Vertex) + sizeof(double) + sizeof(std::uint64_t);
/// Embree's copies, where facets are traced in parts. The lists that they are copied from are gone
/// when light is summed.
constexpr std::uint64_t CopiesPerFacet = sizeof(glm::uvec3);
constexpr std::uint64_t CopiesPerVertex = sizeof(glm::vec3);

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

/// While the error of facet size is worked out: areas, and lists of numbers in use at a time; areas
/// and rings of its own where facets have parts.
constexpr std::uint64_t FacetErrorPerVertex = (1 + 4) * sizeof(double);
constexpr std::uint64_t OwnRingsPerFacet =
  sizeof(glm::uvec3) + sizeof(double) + 3 * sizeof(std::uint32_t);
constexpr std::uint64_t OwnRingsPerVertex = 2 * sizeof(std::uint64_t);

/// A facet of a mesh that is refined where the light varies: before and after it is divided, its
/// edges, the light at their middles, and what a filter makes of it. Up to 320 measured, with what
/// else light is known of, and 490 with what the heap keeps of lists that grow.
std::uint64_t PerAdaptedFacet(const Lighting& lighting, const TraceSettings& settings, bool colour)
{
  constexpr std::uint64_t Plain = 330, OfBack = 80, OfColour = 60, OfLamp = 20;
  return Plain + (settings.registerBackSide ? OfBack : 0) + (colour ? OfColour : 0) +
    (settings.lampsApart ? OfLamp * lighting.luminaires.size() : 0);
}
std::uint64_t HeapKeepsOfAdapted(std::uint64_t facets)
{
  constexpr std::uint64_t PerFacet = 200;
  constexpr std::uint64_t Most = std::uint64_t{ 1 } << 27;
  return std::min(facets * PerFacet, Most);
}

bool AnyFacetIsColoured(const Surface& surface)
{
  std::size_t facet = 0;
  while (facet < surface.facets.size() && !IsColoured(surface, facet))
  {
    ++facet;
  }
  return facet < surface.facets.size();
}

} // namespace

MemoryNeed::MemoryNeed(
  const Surface& surface, const Lighting& lighting, const TraceSettings& settings)
  : OnMap(surface.IsRefined() ? surface.given.points : surface.points.size())
  , Traced(surface.facets.size())
  , Cells(this->Traced)
  , ColouredFacets(AnyFacetIsColoured(surface))
  , Colour(SimulatesColour(this->ColouredFacets, lighting, settings))
  , PerAdapted(PerAdaptedFacet(lighting, settings, this->Colour))
  , Second(GatheringMemory(surface, lighting, settings, this->Colour))
{
  this->CountScene(surface);
  this->CountSums(lighting, settings);
  this->CountMaps(surface, settings);
}

void MemoryNeed::CountScene(const Surface& surface)
{
  const std::uint64_t light = surface.materials.size() * (2 * sizeof(Material) + sizeof(Roulette)) +
    surface.materialOfFacet.size() * 3 * sizeof(std::uint32_t) +
    surface.exitance.size() * (2 * sizeof(PhotonTransport::Colour) + LampPerFacet);
  this->Copies = this->Traced * CopiesPerFacet + surface.points.size() * CopiesPerVertex;
  this->OfScene = this->OnMap * (InputPerVertex + ScenePerVertex) +
    (surface.points.size() - this->OnMap) * RefinedPerPoint +
    this->Traced * (InputPerFacet + ScenePerFacet + EmbreeKeepsPerFacet) + HeapKeeps(this->Traced) +
    surface.given.origins.size() * RefinedPerFacet + light;
}

/// The sums of replicates, and in addition those of threads, which these give up before maps are
/// made.
void MemoryNeed::CountSums(const Lighting& lighting, const TraceSettings& settings)
{
  const std::uint64_t sides = settings.registerBackSide ? 2 : 1;
  const bool colour = this->Colour && !LampsTellColours(lighting, settings, this->ColouredFacets);
  const std::uint64_t layers = colour ? LightLayers::ColourLayers : 0;
  const std::uint64_t colours =
    colour ? settings.replicates * LightLayers::Channels * sizeof(FixedPoint) : 0;
  const std::uint64_t ofSlot = colours + SideSums::BytesPerSlot(settings.replicates, Groups) +
    (sides - 1) * SideSums::BytesPerSlot(settings.replicates, 1) + layers * sizeof(FixedPoint);
  const std::uint64_t ofThread = sides * sizeof(VertexSums) + layers * sizeof(FixedPoint);
  const std::uint64_t slots =
    this->OnMap * (settings.lampsApart ? lighting.luminaires.size() : std::uint64_t{ 1 });
  this->Run.always = slots * ofSlot;
  this->Run.tracing = slots * ofThread * static_cast<std::uint64_t>(ThreadCount(settings.threads));
}

void MemoryNeed::CountMaps(const Surface& surface, const TraceSettings& settings)
{
  this->Run.maps = this->OnMap * (settings.registerBackSide ? 2 : 1) * MapPerVertex;
  if (settings.method == Method::PhotonTracing)
  {
    this->Run.maps += this->OnMap * FacetErrorPerVertex;
    this->Run.maps +=
      surface.IsRefined() ? this->Traced * OwnRingsPerFacet + this->OnMap * OwnRingsPerVertex : 0;
  }
}

std::uint64_t MemoryNeed::Bytes(const MemoryBeside& beside) const
{
  const auto phase = [this](std::uint64_t PhaseBytes::*bytes)
  {
    return this->Run.*bytes + this->Second.whole.*bytes +
      this->Cells * (this->Second.perCell.*bytes);
  };
  const std::uint64_t tracing = phase(&PhaseBytes::tracing);
  const std::uint64_t adapted =
    this->Adapted * this->PerAdapted + HeapKeepsOfAdapted(this->Adapted);
  const std::uint64_t later =
    std::max({ phase(&PhaseBytes::gathering) + std::max(this->Links, adapted),
      phase(&PhaseBytes::maps), beside.maps });
  const std::uint64_t copies = this->Parts > 0 ? this->Copies : 0;
  const std::uint64_t parts = this->Parts * PerPart + copies;
  const std::uint64_t building =
    this->Traced * (EmbreeBuildsPerFacet - EmbreeKeepsPerFacet) + copies;
  return beside.always + this->OfScene + parts +
    std::max(building,
      phase(&PhaseBytes::always) +
        std::max(tracing + tracing / HeapKeepsOfSums, HeapKeepsOfThreads(tracing) + later));
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

} // namespace PhotonTransport
