// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/registration/Registration.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace PhotonTransport
{

/// Area that the ring of `v` shows to light arriving from `towards`, over its whole area:
/// sum (towards . a_f)^+ / sum |a_f|. Only grazing light needs this sum over the ring; otherwise
/// Vertex::shownArea gives the same.
inline float ShownArea(const Scene& scene, std::uint32_t v, const glm::vec3& towards)
{
  float sums[4] = {}; // side by side, since an addition waits for the one before
  unsigned next = 0;
  scene.ForEachAreaAround(v,
    [&](const glm::vec3& area)
    {
      const float shown = glm::dot(towards, area);
      sums[next] += shown > 0.0f ? shown : 0.0f;
      next = (next + 1) % 4;
    });
  return (sums[0] + sums[1] + sums[2] + sums[3]) * scene.Vertices()[v].inverseThreeAreas;
}

/// The weights of HitWeights for Registration::FacetRatio.
inline glm::vec3 FacetRatioWeights(const Scene& scene, const RegisteredPlace& place,
  const glm::vec3& facetNormal, const glm::vec3& towards)
{
  glm::vec3 smooth(0.0f);
  int flatCorners = 0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vertex& vertex = scene.Vertices()[place.vertices[corner]];
    smooth += place.barycentric[corner] * vertex.normal;
    flatCorners += vertex.IsFlat();
  }
  if (flatCorners == 3)
  {
    return place.barycentric;
  }
  const float length = glm::length(smooth);
  const float cosSmooth = glm::dot(towards, smooth);
  if (!(cosSmooth > 0.0f && length > 0.0f))
  {
    return glm::vec3(0.0f);
  }
  const float cosFlat = std::max(0.0f, glm::dot(towards, facetNormal));
  // Formula (2) as its text means it: the first s_norm is the smooth normal, the second the flat.
  return std::min(cosSmooth / (length * cosFlat), LargestFactor) * place.barycentric;
}

/// The weights of HitWeights for Registration::VertexNormalised.
inline glm::vec3 VertexNormalisedWeights(
  const Scene& scene, const RegisteredPlace& place, const glm::vec3& towards)
{
  glm::vec3 weights(0.0f);
  for (int corner = 0; corner < 3; ++corner)
  {
    const std::uint32_t v = place.vertices[corner];
    const Vertex& vertex = scene.Vertices()[v];
    if (vertex.IsFlat())
    {
      weights[corner] = place.barycentric[corner];
      continue;
    }
    const float cosine = glm::dot(towards, vertex.normal);
    if (!(cosine > 0.0f))
    {
      continue;
    }
    const float shown =
      cosine >= vertex.sinTilt ? glm::dot(towards, vertex.shownArea) : ShownArea(scene, v, towards);
    // The hit facet is in the ring, so only rounding at grazing incidence can bring this to 0.
    weights[corner] =
      place.barycentric[corner] * std::min(cosine / std::max(0.0f, shown), LargestFactor);
  }
  return weights;
}

/// Weights of one hit for the three vertices of its facet, before the bound. Each is within
/// [0, LargestFactor] times its barycentric coordinate. @param facetNormal Of the facet that was
/// hit. @param towards Unit, on the front of the facet: back along the ray for a hit on the front,
/// along it for a hit on the back.
template <Registration RegistrationKind>
glm::vec3 HitWeights(const Scene& scene, const RegisteredPlace& place, const glm::vec3& facetNormal,
  const glm::vec3& towards)
{
  if constexpr (RegistrationKind == Registration::Flat)
  {
    return place.barycentric;
  }
  else if constexpr (RegistrationKind == Registration::FacetRatio)
  {
    return FacetRatioWeights(scene, place, facetNormal, towards);
  }
  else
  {
    return VertexNormalisedWeights(scene, place, towards);
  }
}

/// Where a photon comes from, as far as registration needs it.
struct PhotonOrigin
{
  std::uint32_t source = 0; ///< See Emitter.
  bool direct = true;       ///< Straight from the lamp, or through thin panes.
  bool undiffused = true;   ///< No facet has scattered it diffusely.
  /// Whether Arrivals has counted it. Only walks keep this in which facets let light through.
  bool arrived = false;

  /// Of red, green and blue in the photon's luminous flux, together 1, where photons have colours.
  Colour shares{ 1.0f, 0.0f, 0.0f };

  /// Whether nothing but mirrors, gloss and glass have sent it here.
  bool IsCaustic() const { return this->undiffused && !this->direct; }
};

/// Adds hits to one thread's sums.
template <Registration RegistrationKind, bool BackSide>
class Registrar
{
public:
  /// @param weightBound Largest factor by which compensation may raise a hit; >= 1.
  /// @param startWeights [source] By which each photon counts; must outlive it.
  Registrar(
    const Scene& scene, float weightBound, IlluminationSums& sums, const float* startWeights)
    : LitScene(scene)
    , WeightBound(weightBound)
    , Sums(sums)
    , Layers(sums.layers)
    , StartWeights(startWeights)
    , Lamps(sums.lamps)
    , Vertices(sums.front.size() / sums.lamps)
  {
  }

  /// @param corners The corners of the facet that count, as bits: 1 << i for corner i.
  void operator()(const Ray& ray, const Hit& hit, bool front, const PhotonOrigin& photon,
    unsigned corners = AllCorners) const
  {
    if (front)
    {
      this->Register(
        hit, -ray.direction, photon, this->Sums.front, this->Layers.HasColour(), corners);
    }
    else if constexpr (BackSide)
    {
      this->Register(hit, ray.direction, photon, this->Sums.back, false, corners);
    }
  }

  /// Called once for each hit after which a photon may go on, with the facet that decides of it.
  void Arrived(const Hit&, bool, const PhotonOrigin&) const {}

  /// Brings what operator() will need of a hit into the cache; inlined for the reason in Scene.h.
  [[gnu::always_inline]] inline void Prefetch(const Hit& hit) const
  {
    if (hit)
    {
      const glm::uvec3& vertices = this->LitScene.GivenVertices(hit.facet);
      for (int corner = 0; corner < 3; ++corner)
      {
        this->LitScene.PrefetchVertex(vertices[corner]);
        __builtin_prefetch(&this->Sums.front[vertices[corner]], 1);
      }
    }
  }

private:
  void Register(const Hit& hit, const glm::vec3& towards, const PhotonOrigin& photon,
    std::vector<VertexSums>& sums, bool layers, unsigned corners) const
  {
    // One comparison is all that lamps cost where they are not kept apart.
    const std::size_t first = this->Lamps > 1 ? this->FirstSlotOf(photon) : 0;
    VertexSums* const map = sums.data() + first;
    const RegisteredPlace place = this->LitScene.PlaceOnGiven(hit);
    const glm::vec3 weights = HitWeights<RegistrationKind>(
      this->LitScene, place, this->LitScene.Facets()[hit.facet].normal, towards);
    const float startWeight = this->StartWeights[photon.source];
    FixedPoint rounded[3] = {};
    for (int corner = 0; corner < 3; ++corner)
    {
      if (((corners >> corner) & 1u) == 0)
      {
        continue;
      }
      float weight = weights[corner];
      if constexpr (RegistrationKind != Registration::Flat)
      {
        const float most = this->WeightBound * place.barycentric[corner];
        if (weight > most)
        {
          this->Sums.cutByWeightBound[photon.source] += ToCoarseFixedPoint(weight - most);
          weight = most;
        }
      }
      VertexSums& vertex = map[place.vertices[corner]];
      rounded[corner] = ToFixedPoint(weight, startWeight);
      (photon.direct ? vertex.direct : vertex.indirect) += rounded[corner];
      ++vertex.hits;
    }
    if (layers)
    {
      this->AddToLayers(first, place.vertices, photon, rounded);
    }
  }

  /// Of the photon's lamp; see Emitter.
  std::size_t FirstSlotOf(const PhotonOrigin& photon) const
  {
    const std::size_t lamp =
      photon.source < this->Lamps ? photon.source : photon.source % this->Lamps;
    return lamp * this->Vertices;
  }

  void AddToLayers(std::size_t first, const glm::uvec3& vertices, const PhotonOrigin& photon,
    const FixedPoint (&weights)[3]) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      FixedPoint* own = &this->Layers.sums[(first + vertices[corner]) * this->Layers.perSlot];
      const std::array<FixedPoint, 3> parts = PartsByChannel(weights[corner], photon.shares);
      for (std::size_t c = 0; c < LightLayers::Channels; ++c)
      {
        const float share = photon.shares[static_cast<int>(c)];
        own[c] += parts[c];
        own[LightLayers::Channels + c] += ShareOf(weights[corner], share * share);
      }
    }
  }

  const Scene& LitScene;
  float WeightBound;
  IlluminationSums& Sums;
  LightLayers& Layers;
  const float* StartWeights;
  std::size_t Lamps;
  std::size_t Vertices; ///< Slots of a lamp.
};

} // namespace PhotonTransport
