// SPDX-License-Identifier: BSD-3-Clause
// What random scenes are drawn from. To be called by rapidcheck, as DrawScene().
#pragma once

#include "RandomScene.h"

#include <glm/vec3.hpp>

#include <initializer_list>
#include <limits>

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

/// In [0, end).
int Below(int end);

bool OneIn(int many);

template <typename Value>
Value OneOf(std::initializer_list<Value> values)
{
  return values.begin()[Below(static_cast<int>(values.size()))];
}

/// Within [-1, 1].
double Anywhere();

/// Few values in a lattice: coincident points, coplanar and overlapping facets are frequent.
double LatticePlace();

/// Within [-1, 1] or a little outside, often on or almost on the lattice.
glm::dvec3 Place();

/// Any length but 0.
glm::dvec3 Direction();

/// Where a scene stands and how large it is.
struct Site
{
  double size;
  glm::dvec3 origin;
};

PhotonTransport::Surface DrawSurface(const Site& site);
PhotonTransport::Lighting DrawLighting(const PhotonTransport::Surface& surface, const Site& site);

/// Put one value in that makes no sense.
void SpoilSurface(RandomScene& scene);
void SpoilLighting(RandomScene& scene);
