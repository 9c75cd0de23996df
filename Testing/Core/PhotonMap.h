// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Shapes.h"

#include "PhotonTransport/filtration/Filtration.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

/// A map of the unit square from so many photons of one lumen each, on facets of one size: each
/// counts for the corners of the facet it hits by its place there. @param light Share of photons
/// that a place gets, [0, 1].
struct PhotonMap
{
  PhotonTransport::NoisyMap map{ "map", {}, {}, {} };
  std::vector<double> hits;

  PhotonMap(const Shapes::Surface& surface, const std::function<double(const glm::dvec3&)>& light,
    int photons, unsigned seed)
    : hits(surface.points.size(), 0.0)
  {
    const std::vector<double> areas =
      PhotonTransport::SmoothingGraph(surface.points, surface.facets, 0.7).VertexAreas();
    map.values.assign(hits.size(), 0.0);
    map.groups.assign(hits.size(), PhotonTransport::GroupValues{});
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::uniform_int_distribution<std::size_t> anyFacet(0, surface.facets.size() - 1);
    for (int photon = 0; photon < photons; ++photon)
    {
      const glm::uvec3& facet = surface.facets[anyFacet(random)];
      const double root = std::sqrt(uniform(random));
      const double side = uniform(random);
      const glm::dvec3 share(1.0 - root, root * (1.0 - side), root * side);
      const glm::dvec3 place = share.x * surface.points[facet.x] +
        share.y * surface.points[facet.y] + share.z * surface.points[facet.z];
      if (uniform(random) >= light(place))
      {
        continue;
      }
      for (int corner = 0; corner < 3; ++corner)
      {
        const unsigned v = facet[corner];
        map.values[v] += share[corner] / areas[v];
        map.groups[v][static_cast<std::size_t>(photon) % PhotonTransport::Groups] +=
          double{ PhotonTransport::Groups } * share[corner] / areas[v];
        hits[v] += 1.0;
      }
    }
  }
};
