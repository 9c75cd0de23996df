// SPDX-License-Identifier: BSD-3-Clause
// Rays that are followed against the light bring what photons bring.
#include "PhotonTransport/materials/BackwardScattering.h"

#include "LayeredPaths.h"
#include "RandomNumbers.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace PhotonTransport;
using namespace LayeredPaths;

namespace
{

const glm::vec3 Up(0.0f, 0.0f, 1.0f);

enum class Which
{
  AllButDiffuse,
  All
};

glm::vec3 NormalTowards(const glm::vec3& direction)
{
  return direction.z < 0.0f ? Up : -Up;
}

bool MeetsFront(const Plane& plane, const glm::vec3& direction)
{
  return (direction.z < 0.0f) == plane.frontUp;
}

/// What the receiver gets of the source's light, of 1: photons of one channel.
Estimate Forward(const Layers& layers, Which which, std::uint32_t channel, RandomNumbers& random)
{
  return { layers, layers.source, layers.receiver, 1.0, random,
    [&](const Plane& plane, const Path& path, const ScatteringSample& sample)
    {
      const Departure departure =
        Scatter<AllScatterings>(plane.material, plane.material.channels[channel], sample,
          path.direction, NormalTowards(path.direction), MeetsFront(plane, path.direction));
      FollowedRay ray;
      ray.goesOn = !departure.absorbed && (which == Which::All || !IsDiffuse(departure.how));
      ray.sameSide = departure.sameSide;
      ray.direction = departure.direction;
      return ray;
    } };
}

/// The same by rays: a receiver of area A in radiance L gets pi A L, and the source's radiance is
/// 1 / (pi its area).
Estimate Backward(const Layers& layers, Which which, RandomNumbers& random)
{
  return { layers, layers.receiver, layers.source, layers.receiver.Area() / layers.source.Area(),
    random,
    [&](const Plane& plane, const Path& path, const ScatteringSample& sample)
    {
      FollowedRay ray = FollowBack(plane.material, sample, path.direction,
        NormalTowards(path.direction), MeetsFront(plane, path.direction));
      ray.goesOn = ray.goesOn && (which == Which::All || !IsDiffuse(ray.how));
      return ray;
    } };
}

/// Differences between forwards and backwards in standard errors.
class Comparison
{
public:
  explicit Comparison(std::uint32_t seed)
    : Random(seed)
  {
  }

  void Add(const std::string& name, const Layers& layers, Which which)
  {
    const Estimate backward = Backward(layers, which, this->Random);
    double luminous = 0.0, variance = 0.0;
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      const Estimate forward = Forward(layers, which, c, this->Random);
      const double both = forward.variance[c] + backward.variance[c];
      EXPECT_GT(forward.mean[c], 20.0 * std::sqrt(forward.variance[c])) << name << ' ' << c;
      EXPECT_NEAR(backward.mean[c], forward.mean[c], 4.5 * std::sqrt(both)) << name << ' ' << c;
      const double part = double{ LuminousWeights[static_cast<int>(c)] };
      luminous += part * forward.mean[c];
      variance += part * part * forward.variance[c];
    }
    this->Chi2 += std::pow(luminous - backward.mean[3], 2) / (variance + backward.variance[3]);
    ++this->Cases;
  }

  /// chi^2 of k cases has mean k and variance 2 k; 4 of its deviations.
  void ExpectAgreement() const
  {
    EXPECT_LE(this->Chi2, this->Cases + 4.0 * std::sqrt(2.0 * this->Cases));
    testing::Test::RecordProperty("chi2", std::to_string(this->Chi2));
    testing::Test::RecordProperty("cases", this->Cases);
  }

private:
  RandomNumbers Random;
  double Chi2 = 0.0;
  int Cases = 0;
};

const Patch Above{ { 0.0f, 0.0f, 1.0f }, 0.5f, -1.0f };
const Patch Beside{ { 0.8f, 0.3f, 1.2f }, 0.6f, -1.0f };
const Patch Below{ { 0.3f, 0.2f, -1.0f }, 0.6f, 1.0f };

/// Light gets to it at grazing angles.
const Patch Low{ { 0.9f, 0.3f, 0.1f }, 0.5f, -1.0f };

const Colour Tint(0.9f, 0.5f, 0.25f);

Material Gloss(float roughness)
{
  Material material;
  material.glossyReflectance = Tint;
  material.roughness = roughness;
  return material;
}

Material Clear(const Colour& transmittance, float index, bool solid)
{
  Material material;
  material.clearTransmittance = transmittance;
  material.refractiveIndex = index;
  material.solid = solid;
  return material;
}

/// Everything at once, and coloured unequally.
Material Mixed(bool solid)
{
  Material material = Clear({ 0.5f, 0.3f, 0.2f }, 1.5f, solid);
  material.diffuseReflectance = { 0.05f, 0.1f, 0.2f };
  material.specularReflectance = { 0.1f, 0.15f, 0.2f };
  material.glossyReflectance = { 0.2f, 0.15f, 0.1f };
  material.diffuseTransmittance = { 0.1f, 0.2f, 0.15f };
  material.roughness = 0.6f;
  return material;
}

} // namespace

class FollowedBack : public testing::TestWithParam<bool>
{
protected:
  static Roulette Of(const Material& material) { return MakeRoulette(material, GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(BackwardScattering, FollowedBack, testing::Bool(),
  [](const auto& instance) { return instance.param ? "Colour" : "Luminous"; });

TEST_P(FollowedBack, BringsWhatReflectedPhotonsBring)
{
  Comparison comparison(1);
  Material mirror;
  mirror.specularReflectance = Tint;
  comparison.Add("mirror", { { { 0.0f, Of(mirror) } }, Above, Beside }, Which::AllButDiffuse);
  for (const float roughness : { 0.15f, 0.3f, 0.6f, 1.0f })
  {
    const std::vector<Plane> plane{ { 0.0f, Of(Gloss(roughness)) } };
    const std::string name = "gloss " + std::to_string(roughness);
    comparison.Add(name, { plane, Above, Beside }, Which::AllButDiffuse);
    comparison.Add(name + ", low", { plane, Above, Low }, Which::AllButDiffuse);
  }
  comparison.ExpectAgreement();
}

TEST_P(FollowedBack, BringsWhatPhotonsBringThroughClearMaterials)
{
  Comparison comparison(2);
  const Roulette pane = Of(Clear(Tint, 1.52f, false));
  comparison.Add("pane", { { { 0.0f, pane } }, Above, Below }, Which::AllButDiffuse);
  comparison.Add("two panes", { { { 0.0f, pane }, { -0.4f, pane, false } }, Above, Below },
    Which::AllButDiffuse);
  // A pane of unequal colour also mirrors unequally.
  comparison.Add("pane as a mirror", { { { 0.0f, Of(Clear(Tint, 2.5f, false)) } }, Above, Beside },
    Which::AllButDiffuse);
  const Roulette glass = Of(Clear(Tint, 1.52f, true));
  const std::vector<Plane> slab{ { 0.0f, glass }, { -0.4f, glass, false } };
  comparison.Add("slab", { slab, Above, Below }, Which::AllButDiffuse);
  const Roulette heavy = Of(Clear(Tint, 2.5f, true));
  comparison.Add("slab as a mirror",
    { { { 0.0f, heavy }, { -0.4f, heavy, false } }, Above, Beside }, Which::AllButDiffuse);
  comparison.Add("receiver in glass", { { { 0.0f, glass } }, Above, Below }, Which::AllButDiffuse);
  comparison.Add("source in glass", { { { 0.0f, glass } }, Below, Above }, Which::AllButDiffuse);
  comparison.ExpectAgreement();
}

TEST_P(FollowedBack, BringsWhatPhotonsBringByManyWays)
{
  Comparison comparison(3);
  for (const Which which : { Which::AllButDiffuse, Which::All })
  {
    for (const bool solid : { false, true })
    {
      const Roulette mixed = Of(Mixed(solid));
      comparison.Add("mixed, through", { { { 0.0f, mixed } }, Above, Below }, which);
      comparison.Add(
        "mixed, back", { { { 0.0f, mixed }, { -0.4f, mixed, false } }, Above, Beside }, which);
    }
  }
  comparison.ExpectAgreement();
}
