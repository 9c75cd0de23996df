// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace PhotonTransport;

double Comparison::Bias() const
{
  return std::sqrt(std::max(0.0, this->squaredError - this->squaredNoise));
}

Comparison Compare(const Scene& scene, const std::vector<double>& map,
  const std::vector<double>& standardError, const std::vector<double>& exact,
  const std::vector<bool>& counts)
{
  const double scale = *std::max_element(exact.begin(), exact.end());
  Comparison result;
  double areas = 0.0;
  for (std::size_t v = 0; v < map.size(); ++v)
  {
    if (!counts.empty() && !counts[v])
    {
      continue;
    }
    const double area = scene.VertexAreas()[v];
    const double error = (map[v] - exact[v]) / scale;
    const double noise = standardError[v] / scale;
    areas += area;
    result.squaredError += area * error * error;
    result.squaredNoise += area * noise * noise;
    result.largestError = std::max(result.largestError, std::fabs(error));
  }
  result.squaredError /= areas;
  result.squaredNoise /= areas;
  return result;
}

std::vector<double> RingMeans(const Surface& surface, const Illuminance& illuminance)
{
  constexpr int N = 16;
  std::vector<double> sums(surface.points.size(), 0.0), areas(surface.points.size(), 0.0);
  for (const glm::uvec3& facet : surface.facets)
  {
    const glm::dvec3 a = surface.points[facet.x];
    const glm::dvec3 b = surface.points[facet.y];
    const glm::dvec3 c = surface.points[facet.z];
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double area = 0.5 * glm::length(cross);
    glm::dvec3 normal = glm::normalize(cross);
    normal = glm::dot(normal, surface.normals[facet.x]) < 0.0 ? -normal : normal;
    // Centroids of N^2 equal triangles.
    for (int i = 0; i < N; ++i)
    {
      for (int j = 0; i + j < N; ++j)
      {
        for (int upper = 0; upper < (i + j < N - 1 ? 2 : 1); ++upper)
        {
          const double u = (i + (1.0 + upper) / 3.0) / N;
          const double v = (j + (1.0 + upper) / 3.0) / N;
          const glm::dvec3 weights(1.0 - u - v, u, v);
          const double e = illuminance(weights.x * a + weights.y * b + weights.z * c, normal);
          for (int corner = 0; corner < 3; ++corner)
          {
            sums[facet[corner]] += weights[corner] * e * area / (N * N);
          }
        }
      }
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      areas[facet[corner]] += area / 3.0;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
  {
    sums[v] = areas[v] > 0.0 ? sums[v] / areas[v] : 0.0;
  }
  return sums;
}

std::vector<double> Total(const IlluminationMap& map)
{
  std::vector<double> total(map.direct);
  for (std::size_t v = 0; v < total.size(); ++v)
  {
    total[v] += map.indirect[v];
  }
  return total;
}

double AreaMean(const Scene& scene, const std::vector<double>& map)
{
  double sum = 0.0;
  double areas = 0.0;
  for (std::size_t v = 0; v < map.size(); ++v)
  {
    sum += scene.VertexAreas()[v] * map[v];
    areas += scene.VertexAreas()[v];
  }
  return sum / areas;
}
