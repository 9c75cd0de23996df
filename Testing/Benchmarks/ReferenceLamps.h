// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

/// A point with its normal.
struct LitPlace
{
  glm::dvec3 position, normal;
};

/// A place of a lamp that a point may see. Lengths are the scene's.
struct LampSample
{
  glm::dvec3 place;
  double illuminance; ///< lx at the point, times the cosine there, if it is seen.
  /// Of the direction to the place among directions that might have been drawn; 1/sr. 0 if no other
  /// ray can meet the lamp, so that this sample stands for all of its light.
  double density;
  std::uint32_t facet; ///< Of the lamp, or NoFacet.
};

/// The lamps of a scene as the reference sees them: point lamps, rectangles, emitting facets and
/// the traditional overcast sky (CIE type 16). Written without the product's lamps.
class ReferenceLamps
{
public:
  /// Throws std::runtime_error for another lamp.
  ReferenceLamps(const PhotonTransport::Scene& scene, const PhotonTransport::Lighting& lighting);

  /// A place of each lamp, and one of one emitting facet, chosen by the light that would come from
  /// its centre.
  /// @param sums Of the shares of all emitting facets up to each, made here.
  void Sample(const LitPlace& at, const glm::dvec2& place, double choice, std::vector<float>& sums,
    std::vector<LampSample>& samples) const;

  /// The density, in 1/sr, with which Sample draws a direction to an emitting facet.
  /// @param place On the facet. @param sum Over all facets, the last of `sums`.
  double Density(
    std::uint32_t facet, const LitPlace& at, const glm::dvec3& place, double sum) const;

  /// cd/m^2 of the front of a facet.
  double Luminance(std::uint32_t facet) const
  {
    return this->FacetLuminance.empty() ? 0.0 : this->FacetLuminance[facet];
  }
  /// cd/m^2 of the sky in a direction.
  double SkyLuminance(const glm::dvec3& direction) const;

private:
  struct PointLight
  {
    glm::dvec3 position;
    double intensity; ///< lx at the distance 1.
  };
  struct Panel
  {
    glm::dvec3 centre, halfWidth, halfHeight, normal;
    double luminance; ///< cd/m^2
    double area;      ///< Scene units.
  };
  struct Triangle
  {
    glm::dvec3 a, b, c, normal;
    double area, luminance;
    std::uint32_t facet;
  };
  /// What the choice among triangles needs of them, in the scene's coordinates.
  struct Centres
  {
    std::vector<float> x, y, z, normalX, normalY, normalZ, area, intensity;
  };
  void Add(const PhotonTransport::Lamp& lamp, const PhotonTransport::Scene& scene);
  void AddFacets(const PhotonTransport::Scene& scene);
  void Shares(std::size_t first, std::size_t last, const LitPlace& at, float* shares) const;
  void SampleFacets(const LitPlace& at, const glm::dvec2& place, double choice,
    const std::vector<float>& sums, std::vector<LampSample>& samples) const;

  std::vector<PointLight> Points;
  std::vector<Panel> Panels;
  std::vector<Triangle> Triangles;
  Centres CentreOf;                           ///< [triangle]
  std::vector<double> FacetLuminance;         ///< By facet; empty if none emits.
  std::vector<std::uint32_t> TriangleOfFacet; ///< By facet.
  glm::dvec3 Up{ 0.0, 0.0, 1.0 };
  double Zenith = 0.0; ///< cd/m^2
};
