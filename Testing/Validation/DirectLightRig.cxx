// SPDX-License-Identifier: BSD-3-Clause
#include "DirectLightRig.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace PhotonTransport;

DirectLightRig::DirectLightRig(
  const Surface& surface, const Lighting& lighting, bool colour, ScatteringSet switchedOn)
  : scene(surface)
  , emitter(lighting, this->scene, colour)
  , materials(MakeRoulettes(this->scene.Materials(), this->scene.MaterialOfFacet(), colour))
  , light(this->scene, this->emitter, this->materials, switchedOn)
{
}

Receiver DirectLightRig::ReceiverAt(const glm::dvec3& point, const glm::dvec3& normal) const
{
  const glm::vec3 unit(glm::normalize(normal));
  const glm::vec3 place(this->scene.GetPlacement().PointToScene(point));
  return { unit, { { place, unit } }, place };
}

DirectResult DirectLightRig::At(const glm::dvec3& point, const glm::dvec3& normal, unsigned samples,
  std::uint32_t seed, std::uint64_t index) const
{
  DirectResult result;
  this->light.At(this->ReceiverAt(point, normal), samples, seed, index, result);
  return result;
}

double Total(const DirectResult& result)
{
  double sum = 0.0;
  for (const Colour& light : result.ofLamp)
  {
    sum += double{ light.x } + light.y + light.z;
  }
  return sum;
}

MeanOfSeeds Repeat(
  const std::function<DirectResult(std::uint32_t seed)>& estimate, std::uint32_t seeds)
{
  MeanOfSeeds all;
  double squares = 0.0;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed)
  {
    const DirectResult result = estimate(seed);
    const double total = Total(result);
    // Differences from the running mean (Welford 1962), as squares would lose small variances.
    const double before = total - all.mean;
    all.mean += before / seed;
    squares += before * (total - all.mean);
    all.toldVariance += result.variance / seeds;
    all.largest = std::max(all.largest, total);
  }
  all.spread = squares / (seeds - 1);
  all.standardError = std::sqrt(all.spread / seeds);
  return all;
}

MeanOfSeeds RepeatSamples(const DirectLightRig& rig, const glm::dvec3& point,
  const glm::dvec3& normal, std::uint32_t samples)
{
  const Receiver receiver = rig.ReceiverAt(point, normal);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  return Repeat(
    [&](std::uint32_t seed)
    {
      std::uint32_t lamp = 0;
      const double number = std::min(1.0 - 0x1p-53, (seed - 1 + uniform(random)) / samples);
      return DirectResult{ { rig.light.Sample(receiver, number, lamp) }, 0.0, {} };
    },
    samples);
}

std::vector<glm::dvec3> Clipped(
  const std::vector<glm::dvec3>& polygon, const glm::dvec3& point, const glm::dvec3& normal)
{
  std::vector<glm::dvec3> left;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double heightA = glm::dot(a - point, normal), heightB = glm::dot(b - point, normal);
    if (heightA >= 0.0)
    {
      left.push_back(a);
    }
    if ((heightA > 0.0 && heightB < 0.0) || (heightA < 0.0 && heightB > 0.0))
    {
      left.push_back(a + (b - a) * (heightA / (heightA - heightB)));
    }
  }
  return left;
}

double UnitExitance(
  const glm::dvec3& point, const glm::dvec3& normal, const std::vector<glm::dvec3>& polygon)
{
  const std::vector<glm::dvec3> seen = Clipped(polygon, point, normal);
  return seen.size() < 3 ? 0.0 : References::ConfigurationFactor(point, normal, seen);
}
