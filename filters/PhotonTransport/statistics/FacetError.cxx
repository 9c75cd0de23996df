// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/statistics/FacetError.h"

#include "PhotonTransport/statistics/HatMeans.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

// Measured against the light at vertices, see Testing/Validation/FacetErrorTest.cxx.

/// Error over what undoing the mean changes. In the midst of facets a hat function has half the
/// second moment that its product with linear light has. At borders the light is linear to first
/// order, and grows steeper towards an edge.
constexpr double InTheMidst = 0.5;
constexpr double AtBorders = 0.8; ///< In addition.
/// Where tilts are compensated part of the change is that of a light vector that the fit has
/// missed.
constexpr double OfCompensated = 0.5;
/// Weight of the spread of changes around a vertex: beside steps of the light changes have both
/// signs, and the vertex's own may be small by chance.
constexpr double OfSpread = 1.5;
/// Noise of a change over the standard error of the map.
constexpr double NoiseOfChange = 1.15;
/// So many times the squares that noise would give are subtracted: with fewer, noise counts as
/// error where a neighbourhood happens to have more; with more, error is lost that exceeds it.
constexpr double Reserve = 1.25;

/// Steps by which the mean is undone. The highest frequency, of which the mean leaves 1/4, then
/// comes back to 76 %, others more.
constexpr int Steps = 4;
/// Hat means over which the share of noise is found, some twenty vertices.
constexpr int Pooling = 4;

double Square(double x)
{
  return x * x;
}

/// How one-sided the facets around each vertex are: 0 where the hat function has its centroid at
/// the vertex, 1 at a straight border.
double OneSidedness(const Scene& scene, const HatMeans& means, std::uint32_t v)
{
  constexpr double AtStraightBorder = 6.0;
  const Vertex& vertex = scene.Vertices()[v];
  glm::dvec3 offset(0.0);
  double moment = 0.0;
  means.ForEachNeighbour(v,
    [&](std::uint32_t u, double weight)
    {
      const glm::dvec3 edge =
        glm::dvec3(scene.Vertices()[u].position) - glm::dvec3(vertex.position);
      offset += weight * edge;
      moment += weight * glm::dot(edge, edge);
    });
  const glm::dvec3 normal(vertex.normal);
  offset -= glm::dot(normal, offset) * normal;
  return moment > 0.0
    ? std::min(1.0, std::sqrt(AtStraightBorder * glm::dot(offset, offset) / moment))
    : 0.0;
}

/// The light of a neighbourhood by the vertex normal: constant + vector . normal, but not below 0.
/// For the sun, or a lamp that is far for the size of facets, this is exact.
struct LightVector
{
  double constant = 0.0;
  glm::dvec3 vector{ 0.0 };

  double At(const glm::vec3& normal) const
  {
    return std::max(0.0, this->constant + glm::dot(this->vector, glm::dvec3(normal)));
  }
};

/// Least squares over the neighbours of a vertex, through its own light.
LightVector FitLight(
  const Scene& scene, const HatMeans& means, const std::vector<double>& light, std::uint32_t v)
{
  constexpr double Ridge = 1e-3;
  constexpr double LeastTurn = 1e-9;
  const glm::dvec3 normal(scene.Vertices()[v].normal);
  glm::dmat3 matrix(0.0);
  glm::dvec3 side(0.0);
  double turn = 0.0;
  means.ForEachNeighbour(v,
    [&](std::uint32_t u, double weight)
    {
      const glm::dvec3 change = glm::dvec3(scene.Vertices()[u].normal) - normal;
      matrix += weight * glm::outerProduct(change, change);
      side += weight * (light[u] - light[v]) * change;
      turn += weight * glm::dot(change, change);
    });
  if (!(turn > LeastTurn))
  {
    return { light[v], glm::dvec3(0.0) };
  }
  const glm::dvec3 vector = glm::inverse(matrix + glm::dmat3(Ridge * turn)) * side;
  return { light[v] - glm::dot(vector, normal), vector };
}

/// A tilted facet's light is registered as its vertex would see it, so the mean is not of the light
/// at its neighbours, which face elsewhere. This returns what the map would be if it were. The
/// light vector is that of the brightest vertex around: towards a terminator those in the dark
/// don't know it.
std::vector<double> WithoutCompensation(
  const Scene& scene, const HatMeans& means, const std::vector<double>& light)
{
  std::vector<double> result = light;
  ForEach(light.size(),
    [&](std::size_t i)
    {
      const auto v = static_cast<std::uint32_t>(i);
      const glm::vec3& normal = scene.Vertices()[v].normal;
      std::uint32_t brightest = v;
      if (scene.Vertices()[v].IsFlat())
      {
        return;
      }
      means.ForEachNeighbour(v,
        [&](std::uint32_t u, double) { brightest = light[u] > light[brightest] ? u : brightest; });
      const LightVector fit = FitLight(scene, means, light, brightest);
      means.ForEachNeighbour(v,
        [&](std::uint32_t u, double weight)
        { result[v] += weight * (fit.At(scene.Vertices()[u].normal) - fit.At(normal)); });
    });
  return result;
}

/// What undoing the mean changes, by Richardson's iteration e += x - M e from e = light.
/// @param x The map as it would be without compensation.
std::vector<double> Changes(
  const HatMeans& means, const std::vector<double>& light, const std::vector<double>& x)
{
  std::vector<double> undone = light;
  for (int step = 0; step < Steps; ++step)
  {
    const std::vector<double> mean = means.Of(undone);
    ForEach(undone.size(), [&](std::size_t v) { undone[v] += x[v] - mean[v]; });
  }
  ForEach(undone.size(), [&](std::size_t v) { undone[v] = light[v] - undone[v]; });
  return undone;
}

/// Squares of the error, noise included, and what noise alone would give.
struct Squares
{
  std::vector<double> all, noise;
};

/// @param changes Of the light. @param noise Of the light, times `unit`.
Squares SquaresOf(const Scene& scene, const HatMeans& means, const std::vector<double>& changes,
  const std::vector<double>& noise, double unit, bool compensated)
{
  // The own change, its square, and the square that noise gives.
  const auto ofVertex = [&](std::size_t v)
  {
    const double factor =
      compensated && !scene.Vertices()[v].IsFlat() ? OfCompensated * InTheMidst : InTheMidst;
    const double own = factor * changes[v];
    return glm::dvec3(own, Square(own), Square(factor * NoiseOfChange * (noise[v] / unit)));
  };
  Squares squares{ std::vector<double>(changes.size()), std::vector<double>(changes.size()) };
  ForEach(changes.size(),
    [&](std::size_t v)
    {
      const double border =
        1.0 + AtBorders / InTheMidst * OneSidedness(scene, means, static_cast<std::uint32_t>(v));
      const glm::dvec3 own = ofVertex(v), mean = means.At(v, ofVertex);
      const double spread = std::max(0.0, mean.y - Square(mean.x));
      squares.all[v] = Square(border) * own.y + OfSpread * spread;
      squares.noise[v] = Square(border) * own.z + OfSpread * mean.z;
    });
  return squares;
}

/// Keeps the share of the squares that noise does not explain, over a neighbourhood: at a single
/// vertex noise and error can't be told apart. @return Errors.
std::vector<double> WithoutNoise(const HatMeans& means, Squares squares)
{
  std::vector<double> all = means.Of(squares.all);
  std::vector<double> noise = means.Of(squares.noise);
  squares.noise = std::vector<double>();
  for (int i = 1; i < Pooling; ++i)
  {
    all = means.Of(all);
    noise = means.Of(noise);
  }
  ForEach(all.size(),
    [&](std::size_t v)
    {
      const double subtracted = Reserve * noise[v];
      const double share = all[v] > subtracted ? 1.0 - subtracted / all[v] : 0.0;
      squares.all[v] = std::sqrt(share * squares.all[v]);
    });
  return std::move(squares.all);
}

} // namespace

std::vector<double> FacetError(const Scene& scene, std::vector<double> illuminance,
  const std::vector<double>& standardError, bool compensated)
{
  double largest = 0.0; // by which squares neither vanish nor overflow
  for (std::size_t v = 0; v < illuminance.size(); ++v)
  {
    largest = std::max({ largest, illuminance[v], standardError[v] });
  }
  if (!(largest > 0.0))
  {
    return std::vector<double>(illuminance.size(), 0.0);
  }
  const HatMeans means(scene);
  ForEach(illuminance.size(), [&](std::size_t v) { illuminance[v] /= largest; });
  std::vector<double> changes = Changes(
    means, illuminance, compensated ? WithoutCompensation(scene, means, illuminance) : illuminance);
  illuminance = std::vector<double>();
  Squares squares = SquaresOf(scene, means, changes, standardError, largest, compensated);
  changes = std::vector<double>();
  std::vector<double> errors = WithoutNoise(means, std::move(squares));
  ForEach(errors.size(), [&](std::size_t v) { errors[v] *= largest; });
  return errors;
}

} // namespace PhotonTransport
