// SPDX-License-Identifier: BSD-3-Clause
#include "PointReference.h"

#include "ReferenceNumbers.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace PhotonTransport;

namespace
{

constexpr double Pi = 3.14159265358979323846;
/// From so many reflections on, a path of a smaller gain goes on by chance.
constexpr unsigned FirstRoulette = 3;
constexpr double RouletteGain = 0.2;

/// Where the light of a path arrives.
struct Path
{
  LitPlace at;
  double gain = 1.0; ///< lx at the receiver for each lx here.
  std::size_t number = 0;
};

/// A ray of next-event estimation.
struct ShadowTarget
{
  double light; ///< lx at the receiver.
  double distance;
  std::uint32_t facet;
};

} // namespace

PointReference::PointReference(
  const Scene& scene, const Lighting& lighting, const std::vector<Guide>& guides)
  : Lit(scene)
  , Lamps(scene, lighting)
  , Directions(guides, scene.GetPlacement())
{
}

glm::dvec3 PointReference::PlaceOf(const Hit& hit) const
{
  const glm::uvec3& ids = this->Lit.Facets()[hit.facet].vertices;
  glm::dvec3 place(0.0);
  for (int k = 0; k < 3; ++k)
  {
    place += double{ hit.barycentric[k] } * glm::dvec3(this->Lit.Vertices()[ids[k]].position);
  }
  return place;
}

/// Paths from one point that are followed together, so that their rays fill Embree's packets.
class PointReference::Wave
{
public:
  Wave(const PointReference& reference, const ReferencePoint& point, std::uint64_t seed)
    : Reference(reference)
    , Point(point)
    , Numbers(WavePaths, seed)
  {
  }

  /// The mean of the paths, lx.
  double Illuminance()
  {
    const LitPlace at{ this->Point.starts.front().origin, this->Point.normal };
    this->Paths.assign(WavePaths, Path{ at });
    for (std::size_t p = 0; p < WavePaths; ++p)
    {
      this->Paths[p].number = p;
    }
    for (this->Depth = 0; !this->Paths.empty(); ++this->Depth)
    {
      this->Numbers.StartVertex(this->Depth);
      this->SeeLampsAndDrawRays();
      this->AddLampsThatAreSeen();
      this->FollowRays();
    }
    return this->Sum / static_cast<double>(WavePaths);
  }

private:
  /// Where a ray in a direction starts: at the facet that faces it most, so that coarse convex
  /// surfaces do not shade themselves. False if nothing faces it.
  bool FindStart(const Path& path, const glm::dvec3& direction, glm::dvec3& origin) const
  {
    if (glm::dot(direction, path.at.normal) <= 0.0)
    {
      return false;
    }
    origin = path.at.position;
    double most = this->Depth > 0 ? 1.0 : 0.0;
    for (const ReferenceStart& start : this->Point.starts)
    {
      const double cosine = this->Depth == 0 ? glm::dot(direction, start.normal) : 0.0;
      if (cosine > most)
      {
        most = cosine;
        origin = start.origin;
      }
    }
    return most > 0.0;
  }

  void SeeLampsAndDrawRays()
  {
    this->Shadows.clear();
    this->Targets.clear();
    this->Rays.clear();
    this->Flying.clear();
    for (const Path& path : this->Paths)
    {
      const PathNumbers numbers = this->Numbers.Of(path.number);
      this->Reference.Lamps.Sample(
        path.at, numbers.place, numbers.choices.x, this->Shares, this->Samples);
      for (const LampSample& sample : this->Samples)
      {
        this->AddShadowRay(path, sample);
      }
      this->AddRay(path, numbers, this->Shares.empty() ? 0.0 : double{ this->Shares.back() });
    }
  }

  void AddShadowRay(const Path& path, const LampSample& sample)
  {
    glm::dvec3 origin;
    if (!this->FindStart(path, glm::normalize(sample.place - path.at.position), origin))
    {
      return;
    }
    const double distance = glm::length(sample.place - origin);
    const glm::dvec3 direction = (sample.place - origin) / distance;
    const double cosine = std::max(0.0, glm::dot(direction, path.at.normal));
    double share = 1.0;
    if (sample.density > 0.0) // a ray of the path may meet the lamp, too
    {
      const double other = this->Reference.Directions.Density(path.at, direction);
      share = sample.density / (sample.density + other);
    }
    this->Shadows.push_back({ glm::vec3(origin), glm::vec3(direction) });
    this->Targets.push_back(
      { path.gain * sample.illuminance * cosine * share, distance, sample.facet });
  }

  void AddRay(const Path& path, const PathNumbers& numbers, double shares)
  {
    const glm::dvec3 direction =
      this->Reference.Directions.Draw(path.at, numbers.direction, numbers.choices.y);
    glm::dvec3 origin;
    if (this->FindStart(path, direction, origin))
    {
      const double density = this->Reference.Directions.Density(path.at, direction);
      const double gain = path.gain * glm::dot(direction, path.at.normal) / Pi / density;
      this->Rays.push_back({ glm::vec3(origin), glm::vec3(direction) });
      this->Flying.push_back({ path, gain, density, shares });
    }
  }

  void AddLampsThatAreSeen()
  {
    const std::vector<Hit>& hits = this->Trace(this->Shadows);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
      const ShadowTarget& target = this->Targets[i];
      const auto metAt = [&] {
        return glm::length(this->Reference.PlaceOf(hits[i]) - glm::dvec3(this->Shadows[i].origin));
      };
      if (!hits[i] || hits[i].facet == target.facet ||
        metAt() > target.distance - 4.0 * ReferenceLift)
      {
        this->Sum += target.light;
      }
    }
  }

  void FollowRays()
  {
    const std::vector<Hit>& hits = this->Trace(this->Rays);
    this->Paths.clear();
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
      const glm::dvec3 direction(this->Rays[i].direction);
      if (hits[i])
      {
        this->Arrive(this->Flying[i], direction, hits[i]);
      }
      else
      {
        this->Sum += this->Flying[i].gain * Pi * this->Reference.Lamps.SkyLuminance(direction);
      }
    }
  }

  /// A path on its way.
  struct Flight
  {
    Path from;
    double gain;    ///< lx at the receiver for each lx of pi L along the ray.
    double density; ///< Of the direction, 1/sr.
    double shares;  ///< Of all emitting facets.
  };

  void Arrive(const Flight& flight, const glm::dvec3& direction, const Hit& hit)
  {
    const Scene& scene = this->Reference.Lit;
    glm::dvec3 normal = glm::dvec3(scene.Facets()[hit.facet].normal);
    const bool front = glm::dot(direction, normal) < 0.0;
    const glm::dvec3 place = this->Reference.PlaceOf(hit);
    const double luminance = this->Reference.Lamps.Luminance(hit.facet);
    if (front && luminance > 0.0)
    {
      const double other =
        this->Reference.Lamps.Density(hit.facet, flight.from.at, place, flight.shares);
      this->Sum += flight.gain * Pi * luminance * flight.density / (flight.density + other);
    }
    double gain = flight.gain * double{ scene.Facets()[hit.facet].reflectance };
    if (this->Depth + 1 >= FirstRoulette && gain < RouletteGain)
    {
      gain = this->Numbers.Single() * RouletteGain < gain ? RouletteGain : 0.0;
    }
    if (gain > 0.0)
    {
      normal = front ? normal : -normal;
      this->Paths.push_back(
        { { place + ReferenceLift * normal, normal }, gain, flight.from.number });
    }
  }

  const std::vector<Hit>& Trace(const std::vector<Ray>& rays)
  {
    this->Hits.assign(rays.size(), Hit{});
    this->Reference.Lit.Intersect(rays.data(), this->Hits.data(), rays.size());
    return this->Hits;
  }

  const PointReference& Reference;
  const ReferencePoint& Point;
  WaveNumbers Numbers;
  unsigned Depth = 0;
  double Sum = 0.0;
  std::vector<Path> Paths;
  std::vector<float> Shares;
  std::vector<LampSample> Samples;
  std::vector<Ray> Shadows, Rays;
  std::vector<ShadowTarget> Targets;
  std::vector<Flight> Flying;
  std::vector<Hit> Hits;
};

PointEstimate PointReference::At(
  const ReferencePoint& point, unsigned waves, std::uint64_t seed) const
{
  if (point.starts.empty())
  {
    return {};
  }
  double mean = 0.0, squares = 0.0;
  ReferenceNumbers seeds(seed);
  for (unsigned w = 0; w < waves; ++w)
  {
    const double value = Wave(*this, point, seeds.Bits()).Illuminance();
    const double off = value - mean; // Welford
    mean += off / (w + 1.0);
    squares += off * (value - mean);
  }
  return { mean, std::sqrt(squares / (static_cast<double>(waves) * (waves - 1.0))) };
}
