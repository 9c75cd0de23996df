// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/registration/HitWeights.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/registration/Registration.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace PhotonTransport
{

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

  /// Registers a hit, or puts it off until Finish().
  /// @param corners The corners of the facet that count, as bits: 1 << i for corner i.
  void operator()(const Ray& ray, const Hit& hit, bool front, const PhotonOrigin& photon,
    unsigned corners = AllCorners) const
  {
    if (!front && !BackSide)
    {
      return;
    }
    const glm::vec3 towards = front ? -ray.direction : ray.direction;
    const RegisteredPlace place = this->LitScene.PlaceOnGiven(hit);
    if (RegistrationKind == Registration::Flat || this->LitScene.Facets()[hit.facet].IsFlat())
    {
      this->Register<Registration::Flat>(hit, place, towards, front, photon, corners);
    }
    else if (NeedsRings<RegistrationKind>(this->LitScene, place, towards))
    {
      this->Grazing.push_back({ hit, towards, front, photon, corners });
      for (int corner = 0; corner < 3; ++corner)
      {
        this->LitScene.PrefetchRing(place.vertices[corner]);
      }
    }
    else
    {
      this->Register<RegistrationKind>(hit, place, towards, front, photon, corners);
    }
  }

  /// Registers what has been put off: light so grazing that it takes sums over rings. Their memory
  /// is far apart, and arrives for many hits at once.
  void Finish() const
  {
    for (const GrazingHit& grazing : this->Grazing)
    {
      const glm::uvec3& vertices = this->LitScene.GivenVertices(grazing.hit.facet);
      for (int corner = 0; corner < 3; ++corner)
      {
        this->LitScene.PrefetchAreasOfRing(vertices[corner]);
      }
    }
    for (const auto& [hit, towards, front, photon, corners] : this->Grazing)
    {
      this->Register<RegistrationKind>(
        hit, this->LitScene.PlaceOnGiven(hit), towards, front, photon, corners);
    }
    this->Grazing.clear();
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
  /// The arguments of Register.
  struct GrazingHit
  {
    Hit hit;
    glm::vec3 towards; ///< See HitWeights.
    bool front;
    PhotonOrigin photon;
    unsigned corners;
  };

  template <Registration WithWeightsOf>
  void Register(const Hit& hit, const RegisteredPlace& place, const glm::vec3& towards, bool front,
    const PhotonOrigin& photon, unsigned corners) const
  {
    std::vector<VertexSums>& sums = front ? this->Sums.front : this->Sums.back;
    // One comparison is all that lamps cost where they are not kept apart.
    const std::size_t first = this->Lamps > 1 ? this->FirstSlotOf(photon) : 0;
    VertexSums* const map = sums.data() + first;
    Four weights = HitWeights<WithWeightsOf>(
      this->LitScene, place, this->LitScene.Facets()[hit.facet].normal, towards);
    if constexpr (WithWeightsOf != Registration::Flat)
    {
      const Four most = this->WeightBound * OfCorners(place.barycentric);
      const auto exceeds = weights > most;
      if ((exceeds[0] | exceeds[1] | exceeds[2]) != 0)
      {
        weights = this->CutAtBound(weights, most, photon.source, corners);
      }
    }
    const Four inFixedPoint = weights * (this->StartWeights[photon.source] * FixedPointOne) + 0.5f;
    FixedPoint rounded[3] = {};
    for (int corner = 0; corner < 3; ++corner)
    {
      if (((corners >> corner) & 1u) == 0)
      {
        continue;
      }
      VertexSums& vertex = map[place.vertices[corner]];
      rounded[corner] = static_cast<FixedPoint>(inFixedPoint[corner]);
      (photon.direct ? vertex.direct : vertex.indirect) += rounded[corner];
      ++vertex.hits;
    }
    if (front && this->Layers.HasColour())
    {
      this->AddToLayers(first, place.vertices, photon, rounded);
    }
  }

  /// The weights within the bound; counts what is cut off. It is not inlined, since it is rare and
  /// the hot code must stay small.
  [[gnu::noinline]] Four CutAtBound(
    Four weights, Four most, std::uint32_t source, unsigned corners) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (weights[corner] > most[corner])
      {
        if (((corners >> corner) & 1u) != 0)
        {
          this->Sums.cutByWeightBound[source] += ToCoarseFixedPoint(weights[corner] - most[corner]);
        }
        weights[corner] = most[corner];
      }
    }
    return weights;
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
  std::size_t Vertices;                    ///< Slots of a lamp.
  mutable std::vector<GrazingHit> Grazing; ///< See Finish.
};

} // namespace PhotonTransport
