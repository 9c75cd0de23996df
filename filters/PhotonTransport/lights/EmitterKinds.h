// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/lights/DirectionTable.h"
#include "PhotonTransport/lights/FluxTable.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/scene/Scene.h"

#include <algorithm>
#include <memory>
#include <variant>
#include <vector>

namespace PhotonTransport
{

// The ways in which photons start, in the scene's coordinates. Each Emit() gives one photon's ray.

/// The slice of [0, 1) that selects this lamp; the position inside it is reused as a fresh uniform
/// number.
struct Share
{
  double begin = 0.0;
  double width = 1.0;

  double PlaceOf(const PhotonSample& sample) const
  {
    const double choice = sample.EmissionBits(PhotonSample::ChoiceDimension) * 0x1p-32;
    constexpr double Last = 1.0 - 0x1p-53;
    return std::clamp((choice - this->begin) / this->width, 0.0, Last);
  }
};

/// Photons in one direction, from a disk that just covers the scene.
struct ParallelEmitter
{
  glm::vec3 centre;
  glm::vec3 acrossU, acrossV; ///< The disk's half-axes.
  glm::vec3 direction;
  Ray Emit(const PhotonSample& sample, const Share&) const;
};

/// Photons from a point, intensity I_0 cos^n within a cone.
struct ConeEmitter
{
  glm::dvec3 position;
  Frame axis;
  float exponent;
  float cosMax;
  Ray Emit(const PhotonSample& sample, const Share&) const;
};

/// Photons from a point by a table of intensities.
struct TableEmitter
{
  glm::dvec3 position;
  glm::dvec3 azimuth0, azimuth90, pole; ///< Orthonormal.
  std::shared_ptr<const DirectionTable> table;
  Ray Emit(const PhotonSample& sample, const Share&) const;
};

/// Lambertian photons from a flat lamp.
struct PanelEmitter
{
  glm::dvec3 centre;
  Frame frame;
  glm::dvec3 acrossU, acrossV; ///< Half-axes.
  bool round;
  Ray Emit(const PhotonSample& sample, const Share&) const;
};

/// Lambertian photons from the outside of a sphere.
struct SphereEmitter
{
  glm::dvec3 centre;
  double radius;
  Ray Emit(const PhotonSample& sample, const Share&) const;
};

/// Lambertian photons from a tube too thin to have a radius.
struct LineEmitter
{
  glm::dvec3 centre;
  glm::dvec3 halfAxis;
  Frame frame; ///< About the axis.
  Ray Emit(const PhotonSample& sample, const Share&) const;
};

/// Lambertian photons from the scene's own facets, each chosen by its share of the flux.
struct FacetEmitter
{
  const Scene* scene;
  std::vector<std::uint32_t> facets; ///< Those that shine.
  FluxTable table;                   ///< Chooses one of them.
  std::uint32_t FacetOf(const PhotonSample& sample, const Share& share) const
  {
    return this->facets[this->table.At(share.PlaceOf(sample))];
  }
  Ray Emit(const PhotonSample& sample, const Share& share) const;
};

/// Lambertian photons from triangles that are not part of the scene.
struct MeshEmitter
{
  struct Triangle
  {
    glm::dvec3 corner, u, v;
    glm::vec3 normal; ///< On the side that shines.
  };
  std::vector<Triangle> triangles;
  FluxTable table;
  Ray Emit(const PhotonSample& sample, const Share& share) const;
};

/// Photons of uniform luminance from a hemisphere or sphere of directions onto the bounding ball.
struct SkyEmitter
{
  Frame up;
  bool wholeSphere;
  float radius; ///< Of the ball about the scene's origin that holds all facets.
  Ray Emit(const PhotonSample& sample, const Share&) const;
};

/// Photons from a sky whose luminance a table gives, onto the bounding ball.
struct TableSkyEmitter
{
  glm::dvec3 azimuth0, azimuth90, up; ///< Orthonormal.
  float radius;                       ///< As SkyEmitter's.
  std::shared_ptr<const DirectionTable> table;
  Ray Emit(const PhotonSample& sample, const Share&) const;
};

using EmitterKind = std::variant<ParallelEmitter, ConeEmitter, TableEmitter, PanelEmitter,
  SphereEmitter, LineEmitter, FacetEmitter, MeshEmitter, SkyEmitter, TableSkyEmitter>;

} // namespace PhotonTransport
