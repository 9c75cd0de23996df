// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/FluxTable.h"
#include "PhotonTransport/lights/LampKind.h"
#include "PhotonTransport/lights/ShiningTriangle.h"

namespace PhotonTransport
{

/// Lambertian photons from the scene's own facets, each chosen by its share of the flux.
struct FacetEmitter
{
  const Scene* scene;
  std::vector<std::uint32_t> facets; ///< Those that shine.
  FluxTable table;                   ///< Chooses one of them.
  std::uint32_t FacetOf(const PhotonSample& sample, const Share& share) const;
  Ray Emit(const PhotonSample& sample, const Share& share) const;
  const Colour* OwnColour(const PhotonSample& sample, const Share& share) const;
  static constexpr PlaceNumbers Numbers = PlaceNumbers::Two;
  /// Of one of `facets`, for 1 lm of its own flux. The place is where photons start: clear of the
  /// facet, on its front.
  Incidence Arriving(const glm::dvec3& point, float u, float v, std::size_t chosen) const;
  ShiningTriangle Shape(std::size_t chosen) const;
};

/// Lambertian photons from triangles that are not part of the scene.
struct MeshEmitter : LuminaireColoured
{
  struct Triangle
  {
    glm::dvec3 corner, u, v;
    glm::vec3 normal; ///< On the side that shines.
  };
  std::vector<Triangle> triangles;
  FluxTable table;
  Ray Emit(const PhotonSample& sample, const Share& share) const;
  static constexpr PlaceNumbers Numbers = PlaceNumbers::Two;
  /// Of one of `triangles`, for 1 lm of its own flux.
  Incidence Arriving(const glm::dvec3& point, float u, float v, std::size_t chosen) const;
  ShiningTriangle Shape(std::size_t chosen) const;
};

/// The surface's own facets shine from their fronts, each with its Surface::exitance.
struct EmittingFacets
{
  static constexpr const char* Name = nullptr;
  static constexpr LampClass Class = LampClass::Area;
  template <typename Fields>
  void Describe(const Fields&)
  {
  }
  std::optional<glm::dvec3> Place() const { return std::nullopt; }
  void Move(const Similarity&) {} // it is where its points are
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<FacetEmitter> Prepare(const Scene& scene) const;
};

/// Triangles that shine diffusely to the side round which their corners run counter-clockwise.
/// They stop no photons. Of exact copies of a triangle the brightest one shines.
struct EmittingMesh
{
  std::vector<glm::dvec3> points;
  std::vector<glm::uvec3> facets;
  std::vector<float> exitance; ///< lm/m^2, one a facet, >= 0.

  static constexpr const char* Name = nullptr;
  static constexpr LampClass Class = LampClass::Area;
  template <typename Fields>
  void Describe(const Fields&)
  {
  }
  /// The mean of the points.
  std::optional<glm::dvec3> Place() const;
  void Move(const Similarity&) {} // it is where its points are
  LampNotes Notes(const std::string& name) const;
  Prepared<MeshEmitter> Prepare(const Scene& scene) const;
};

/// [facet] Whether it has the same corners in the same turn as another facet, which shines in its
/// place: the one of the largest exitance, or the first of those.
/// @param mesh One exitance a facet; its facets use no points but its own.
std::vector<bool> CopiesIn(const EmittingMesh& mesh);

} // namespace PhotonTransport
