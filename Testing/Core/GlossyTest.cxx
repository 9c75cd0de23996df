// SPDX-License-Identifier: BSD-3-Clause
// The glossy lobe against quadrature of D G2 / (4 cos), Walter et al. 2007 and Heitz 2014.
#include "PhotonTransport/materials/Scattering.h"

#include "RandomNumbers.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

using namespace PhotonTransport;

namespace
{

constexpr double Pi = 3.14159265358979323846;

double Lambda(double cosine, double alpha)
{
  const double tangent2 = (1.0 - cosine * cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}

/// Density by solid angle of light that arrives from `in` and leaves to `out`, about +z.
double Density(const glm::dvec3& in, const glm::dvec3& out, double alpha)
{
  const glm::dvec3 half = glm::normalize(in + out);
  const double a2 = alpha * alpha;
  const double base = half.z * half.z * (a2 - 1.0) + 1.0;
  const double d = a2 / (Pi * base * base);
  return d / (4.0 * in.z * (1.0 + Lambda(in.z, alpha) + Lambda(out.z, alpha)));
}

/// Cells of equal solid angle, by the cosine and azimuth of the direction out.
struct Cells
{
  static constexpr int Bands = 8;
  static constexpr int Sectors = 12;

  std::vector<double> values = std::vector<double>(Bands * Sectors, 0.0);

  double& Of(const glm::dvec3& out)
  {
    const int band = std::min(Bands - 1, static_cast<int>(out.z * Bands));
    const double turn = std::atan2(out.y, out.x) / (2.0 * Pi) + 0.5;
    const int sector = std::min(Sectors - 1, static_cast<int>(turn * Sectors));
    return this->values[static_cast<std::size_t>(band * Sectors + sector)];
  }
  double Sum() const
  {
    double sum = 0.0;
    for (const double value : this->values)
    {
      sum += value;
    }
    return sum;
  }
};

/// By the midpoint rule with `fine`^2 points a cell.
Cells Quadrature(const glm::dvec3& in, double alpha, int fine)
{
  Cells cells;
  const int bands = fine * Cells::Bands;
  const int sectors = fine * Cells::Sectors;
  for (int band = 0; band < bands; ++band)
  {
    for (int sector = 0; sector < sectors; ++sector)
    {
      const double z = (band + 0.5) / bands;
      const double azimuth = 2.0 * Pi * (sector + 0.5) / sectors;
      const double radius = std::sqrt(1.0 - z * z);
      const glm::dvec3 out(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
      cells.Of(out) += Density(in, out, alpha) * 2.0 * Pi / (bands * sectors);
    }
  }
  return cells;
}

glm::dvec3 Towards(double degrees)
{
  const double angle = degrees * Pi / 180.0;
  return { std::sin(angle) * 0.8, std::sin(angle) * 0.6, std::cos(angle) };
}

/// By bands of the cosine out, the share of light by Lambert's law that microfacets pass on.
std::vector<double> PassedOnByBand(double alpha)
{
  constexpr int Fine = 8;
  std::vector<double> bands(Cells::Bands, 0.0);
  for (int i = 0; i < Fine * Cells::Bands; ++i)
  {
    const double cosine = (i + 0.5) / (Fine * Cells::Bands);
    const double albedo =
      Quadrature({ std::sqrt(1.0 - cosine * cosine), 0.0, cosine }, alpha, 40).Sum();
    bands[static_cast<std::size_t>(i / Fine)] +=
      (1.0 - albedo) * 2.0 * cosine / (Fine * Cells::Bands);
  }
  return bands;
}

/// Mean probability over many photons, and its standard error.
struct Albedo
{
  double mean = 0.0, error = 0.0;

  Albedo(const glm::dvec3& in, double alpha, int photons)
  {
    RandomNumbers random(11);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < photons; ++i)
    {
      const float u = random.Unit();
      const double p = ReflectGlossily(
        glm::vec3(in), { 0.0f, 0.0f, 1.0f }, static_cast<float>(alpha), u, random.Unit())
                         .probability;
      sum += p;
      squares += p * p;
    }
    this->mean = sum / photons;
    this->error = std::sqrt((squares / photons - this->mean * this->mean) / photons);
  }
};

} // namespace

TEST(Glossy, IsSoundAtTheEdges)
{
  const glm::vec3 normal = glm::normalize(glm::vec3(-0.2f, 0.9f, -0.4f));
  const Frame frame(normal);
  for (const float alpha : { 1e-38f, 1e-12f, 1e-6f, 1e-3f, 0.09f, 0.5f, 1.0f })
  {
    for (const float cosine : { 0.0f, 1e-30f, 1e-7f, 1e-3f, 0.5f, 1.0f })
    {
      const glm::vec3 towards =
        frame.ToWorld({ std::sqrt((1.0f - cosine) * (1.0f + cosine)), 0.0f, cosine });
      for (const float u : { 0.0f, 0x1p-24f, 0.25f, 0.5f, 1.0f - 0x1p-24f })
      {
        for (const float v : { 0.0f, 0.5f, 1.0f - 0x1p-24f })
        {
          const GlossyDirection lobe = ReflectGlossily(towards, normal, alpha, u, v);
          EXPECT_GE(lobe.probability, 0.0f); // negated comparisons: NaN fails
          EXPECT_LE(lobe.probability, 1.0f);
          EXPECT_NEAR(glm::length(lobe.direction), 1.0f, 1e-6f);
          EXPECT_GT(glm::dot(lobe.direction, normal), -1e-6f);
        }
      }
    }
  }
}

// Counts of photons against the density, by Pearson's chi^2.
TEST(Glossy, DirectionsFollowTheDensity)
{
  constexpr int Photons = 400'000;
  for (const double alpha : { 0.3, 0.6, 1.0 })
  {
    for (const double degrees : { 0.0, 45.0, 75.0 })
    {
      const glm::dvec3 in = Towards(degrees);
      const Cells expected = Quadrature(in, alpha, 32);
      Cells counts;
      RandomNumbers random(5);
      for (int i = 0; i < Photons; ++i)
      {
        const float u = random.Unit();
        const GlossyDirection lobe = ReflectGlossily(
          glm::vec3(in), { 0.0f, 0.0f, 1.0f }, static_cast<float>(alpha), u, random.Unit());
        if (random.Unit() < lobe.probability)
        {
          ++counts.Of(glm::dvec3(lobe.direction));
        }
      }
      double chi2 = 0.0;
      int used = 0;
      for (std::size_t c = 0; c < counts.values.size(); ++c)
      {
        const double mean = Photons * expected.values[c];
        if (mean >= 10.0)
        {
          chi2 += std::pow(counts.values[c] - mean, 2) / mean;
          ++used;
        }
      }
      // chi^2 of k cells has mean k and variance 2 k; 4 of its deviations.
      EXPECT_GT(used, 30);
      EXPECT_LE(chi2, used + 4.0 * std::sqrt(2.0 * used)) << alpha << ' ' << degrees;
    }
  }
}

TEST(Glossy, AlbedoIsThatOfTheDensity)
{
  for (const double alpha : { 0.1, 0.3, 0.6, 1.0 })
  {
    for (const double degrees : { 0.0, 45.0, 75.0, 85.0 })
    {
      const glm::dvec3 in = Towards(degrees);
      const double coarse = Quadrature(in, alpha, 40).Sum();
      const double fine = Quadrature(in, alpha, 80).Sum();
      const Albedo albedo(in, alpha, 400'000);
      // The midpoint rule's error falls by 4 or more: what is left is below the difference.
      EXPECT_NEAR(albedo.mean, fine, 4.0 * albedo.error + std::fabs(fine - coarse) + 1e-6)
        << alpha << ' ' << degrees;
    }
  }
}

// At alpha 1 and normal incidence D is constant: the albedo of one reflection is that of
// mu / (mu + 1), mu from 0 to 1, which is 1 - ln 2.
TEST(Glossy, ReflectsLessAtTheFirstMicrofacetTheRougher)
{
  const Albedo roughest({ 0.0, 0.0, 1.0 }, 1.0, 1'000'000);
  EXPECT_NEAR(roughest.mean, 1.0 - std::log(2.0), 4.0 * roughest.error);
  double last = 1.0;
  for (const double roughness : { 0.1, 0.3, 0.5, 0.7, 1.0 })
  {
    const Albedo albedo({ 0.0, 0.0, 1.0 }, roughness * roughness, 200'000);
    EXPECT_LE(albedo.mean, last + 4.0 * albedo.error) << roughness;
    last = albedo.mean;
    RecordProperty("albedo_roughness_" + std::to_string(static_cast<int>(10.0 * roughness + 0.5)),
      std::to_string(albedo.mean));
  }
}

// Nothing is lost: what the lobe leaves goes out by the lobe of Kulla and Conty, whose albedos come
// from quadrature here, but for what the draws do not reach, which is mirrored.
TEST(Glossy, WhatMicrofacetsPassOnLeavesByTheReciprocalLobe)
{
  constexpr int Photons = 400'000;
  for (const double alpha : { 0.3, 1.0 })
  {
    const glm::dvec3 in = Towards(60.0);
    Cells expected = Quadrature(in, alpha, 64);
    const double rest = 1.0 - expected.Sum();
    const std::vector<double> bands = PassedOnByBand(alpha);
    const double average = std::accumulate(bands.begin(), bands.end(), 0.0);
    const double left = std::pow(1.0 - average, MostDirectionDraws);
    expected.Of({ -in.x, -in.y, in.z }) += rest * left;
    for (std::size_t c = 0; c < expected.values.size(); ++c)
    {
      expected.values[c] +=
        rest * (1.0 - left) * bands[c / Cells::Sectors] / average / Cells::Sectors;
    }
    Cells counts;
    RandomNumbers random(3);
    for (int i = 0; i < Photons; ++i)
    {
      ScatteringSample sample{ random.Bits(), random.Unit(), 0.0f };
      sample.v = random.Unit();
      counts.Of(glm::dvec3(ReflectFromMicrofacets(glm::vec3(in), { 0.0f, 0.0f, 1.0f },
        static_cast<float>(alpha), sample, sample.survival * 0x1p-32))) += 1.0;
    }
    double chi2 = 0.0;
    for (std::size_t c = 0; c < counts.values.size(); ++c)
    {
      const double mean = Photons * expected.values[c];
      EXPECT_GE(mean, 10.0);
      chi2 += std::pow(counts.values[c] - mean, 2) / mean;
    }
    const auto cells = static_cast<double>(counts.values.size());
    EXPECT_LE(chi2, cells + 4.0 * std::sqrt(2.0 * cells)) << alpha;
  }
}

// tan of a microfacet's angle is alpha r / sqrt(1 - r^2): of 2^-24 steps in r^2 the last is 4096
// alpha; a number below 0.99 stays within 10 alpha.
TEST(Glossy, IsAMirrorWhereSmooth)
{
  const glm::vec3 in = glm::vec3(Towards(60.0));
  const glm::vec3 mirrored(-in.x, -in.y, in.z);
  for (const float alpha : { 1e-30f, 1e-6f, 1e-4f })
  {
    for (const float u : { 0.01f, 0.3f, 0.5f, 0.99f })
    {
      for (const float v : { 0.01f, 0.6f, 0.99f })
      {
        const GlossyDirection lobe = ReflectGlossily(in, { 0.0f, 0.0f, 1.0f }, alpha, u, v);
        // A turned microfacet turns the ray by twice its angle; 8 roundings.
        EXPECT_LE(glm::length(lobe.direction - mirrored), 20.0f * alpha + 8.0f * 0x1p-24f);
        EXPECT_GE(lobe.probability, 1.0f - 20.0f * alpha);
      }
    }
  }
}
