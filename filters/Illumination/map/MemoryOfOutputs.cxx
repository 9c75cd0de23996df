// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/MemoryOfOutputs.h"

#include "PhotonTransport/registration/PhotonHit.h"
#include "PhotonTransport/statistics/GroupMeans.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <algorithm>

namespace Illumination
{
namespace
{

using namespace PhotonTransport;

constexpr std::uint64_t Number = sizeof(double); // of an array

/// Point arrays that stay: see AddPointArrays.
std::uint64_t ArraysPerPoint(const Lighting& lighting, const TraceSettings& settings, bool colours)
{
  const bool byPhotons = settings.method == Method::PhotonTracing; // then colours have errors
  const std::uint64_t front = byPhotons ? 7 : 6;
  const std::uint64_t back = settings.registerBackSide ? 2 : 0;
  const std::uint64_t colour = !colours ? 0 : byPhotons ? 6 : 3;
  const std::uint64_t lamps =
    settings.lampsApart ? lighting.luminaires.size() * (byPhotons ? 2 : 1) : 0;
  return (front + back + colour + lamps) * Number;
}

/// Lists on the way to them: what is there at a time, beside the map of the front.
std::uint64_t ListsPerPoint(
  const TraceSettings& settings, std::uint64_t map, bool colours, bool groupMeans)
{
  const std::uint64_t sides = 6 * Number + (settings.registerBackSide ? map : 0);
  constexpr std::uint64_t OfColours = 8 * Number;
  constexpr std::uint64_t OfLamp = 6 * Number;
  constexpr std::uint64_t OfGroups = 5 * sizeof(GroupValues); // both arrays, too
  return std::max({ sides, colours ? OfColours : 0, settings.lampsApart ? OfLamp : 0,
    groupMeans && settings.method == Method::PhotonTracing ? OfGroups : 0 });
}

/// A hit in the list and in the output: place, vertex, and arrays.
std::uint64_t PerHit(bool colours)
{
  return sizeof(PhotonHit) + sizeof(glm::dvec3) + 2 * sizeof(vtkIdType) + sizeof(double) +
    sizeof(glm::vec3) + 3 * sizeof(int) + sizeof(signed char) + sizeof(vtkIdType) +
    (colours ? sizeof(glm::dvec3) : 0);
}

} // namespace

MemoryBeside MemoryOfOutputs(const PhotonTransport::Surface& surface, const Lighting& lighting,
  const TraceSettings& settings, bool colours, const WantedOutputs& wanted)
{
  const bool isOther = surface.IsRefined();
  const std::uint64_t points = isOther ? surface.given.points : surface.points.size();
  const std::uint64_t facets = isOther ? surface.given.facets.size() : surface.facets.size();
  MemoryBeside beside;
  beside.always = (points + facets) * sizeof(vtkIdType);
  if (isOther)
  {
    beside.always +=
      points * 2 * sizeof(glm::dvec3) + facets * (sizeof(glm::uvec3) + sizeof(std::uint32_t));
  }
  const std::uint64_t map = (settings.method == Method::PhotonTracing ? 4 : 5) * Number;
  const std::uint64_t arrays = points * ArraysPerPoint(lighting, settings, colours);
  const std::uint64_t lists =
    points * (Number + map + ListsPerPoint(settings, map, colours, wanted.groupMeans));
  // While photons are followed once more there are materials by facet.
  const std::uint64_t photons = wanted.photons == 0
    ? 0
    : wanted.photons * PerHit(colours) + surface.facets.size() * sizeof(std::uint32_t);
  constexpr std::uint64_t HeapKeeps = 4; // a fourth of freed lists
  beside.maps = arrays + std::max(lists, lists / HeapKeeps + photons);
  return beside;
}

} // namespace Illumination
