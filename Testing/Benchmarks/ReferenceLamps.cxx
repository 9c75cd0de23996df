// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceLamps.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

using namespace PhotonTransport;

namespace
{
constexpr double Pi = 3.14159265358979323846;
}

ReferenceLamps::ReferenceLamps(const Scene& scene, const Lighting& lighting)
{
  for (const Luminaire& luminaire : lighting.luminaires)
  {
    this->Add(luminaire.lamp, scene);
  }
}

void ReferenceLamps::Add(const Lamp& lamp, const Scene& scene)
{
  const Placement& placement = scene.GetPlacement();
  const double squareMetres = scene.SquareMetresPerSceneArea();
  if (const auto* point = std::get_if<PointLamp>(&lamp))
  {
    this->Points.push_back(
      { placement.PointToScene(point->position), point->flux / (4.0 * Pi * squareMetres) });
  }
  else if (const auto* panel = std::get_if<RectangleLamp>(&lamp))
  {
    const glm::dvec3 normal = glm::normalize(panel->direction);
    const glm::dvec3 width = glm::normalize(panel->across);
    const glm::dvec3 height = glm::cross(normal, width);
    const double area =
      placement.LengthToScene(panel->width) * placement.LengthToScene(panel->height);
    this->Panels.push_back(
      { placement.PointToScene(panel->centre), 0.5 * placement.LengthToScene(panel->width) * width,
        0.5 * placement.LengthToScene(panel->height) * height, normal,
        panel->flux / (Pi * area * squareMetres), area });
  }
  else if (const auto* sky = std::get_if<CieSky>(&lamp); sky && sky->type == 16)
  {
    // The integral of (1 + 2 sin) / 3 times the sine over the hemisphere is 7 pi / 9.
    this->Up = glm::normalize(sky->up);
    this->Zenith = 9.0 * sky->horizontalIlluminance / (7.0 * Pi);
  }
  else if (std::holds_alternative<EmittingFacets>(lamp))
  {
    this->AddFacets(scene);
  }
  else
  {
    throw std::runtime_error("the reference does not know this kind of lamp");
  }
}

void ReferenceLamps::AddFacets(const Scene& scene)
{
  this->FacetLuminance.assign(scene.Facets().size(), 0.0);
  this->TriangleOfFacet.assign(scene.Facets().size(), NoFacet);
  for (std::uint32_t f = 0; f < scene.Facets().size(); ++f)
  {
    const double luminance = double{ Luminous(scene.Exitance()[f]) } / Pi;
    if (luminance > 0.0)
    {
      const Facet& facet = scene.Facets()[f];
      const auto corner = [&](int k)
      { return glm::dvec3(scene.Vertices()[facet.vertices[k]].position); };
      const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
      this->FacetLuminance[f] = luminance;
      this->TriangleOfFacet[f] = static_cast<std::uint32_t>(this->Triangles.size());
      const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
      this->Triangles.push_back({ a, b, c, glm::dvec3(facet.normal), area, luminance, f });
      const glm::vec3 centre((a + b + c) / 3.0);
      this->CentreOf.x.push_back(centre.x);
      this->CentreOf.y.push_back(centre.y);
      this->CentreOf.z.push_back(centre.z);
      this->CentreOf.normalX.push_back(facet.normal.x);
      this->CentreOf.normalY.push_back(facet.normal.y);
      this->CentreOf.normalZ.push_back(facet.normal.z);
      this->CentreOf.area.push_back(static_cast<float>(area));
      this->CentreOf.intensity.push_back(static_cast<float>(area * luminance));
    }
  }
}

/// The light from the centres of triangles [first, last). The area keeps it finite next to a
/// triangle. The loop has no branches, so that compilers take four triangles at a time.
void ReferenceLamps::Shares(
  std::size_t first, std::size_t last, const LitPlace& at, float* shares) const
{
  const float *x = this->CentreOf.x.data(), *y = this->CentreOf.y.data(),
              *z = this->CentreOf.z.data();
  const float *nx = this->CentreOf.normalX.data(), *ny = this->CentreOf.normalY.data(),
              *nz = this->CentreOf.normalZ.data();
  const float *area = this->CentreOf.area.data(), *intensity = this->CentreOf.intensity.data();
  const glm::vec3 p(at.position), n(at.normal);
  for (std::size_t i = first; i < last; ++i)
  {
    const float dx = x[i] - p.x, dy = y[i] - p.y, dz = z[i] - p.z;
    const float leaves = -(dx * nx[i] + dy * ny[i] + dz * nz[i]);
    const float arrives = dx * n.x + dy * n.y + dz * n.z;
    const float spread = dx * dx + dy * dy + dz * dz + area[i];
    const float both = (leaves > 0.0f ? leaves : 0.0f) * (arrives > 0.0f ? arrives : 0.0f);
    shares[i - first] = both * intensity[i] / (spread * spread);
  }
}

void ReferenceLamps::Sample(const LitPlace& at, const glm::dvec2& place, double choice,
  std::vector<float>& sums, std::vector<LampSample>& samples) const
{
  samples.clear();
  for (const PointLight& lamp : this->Points)
  {
    const glm::dvec3 away = lamp.position - at.position;
    samples.push_back({ lamp.position, lamp.intensity / glm::dot(away, away), 0.0, NoFacet });
  }
  for (const Panel& panel : this->Panels)
  {
    const glm::dvec3 p = panel.centre + (2.0 * place.x - 1.0) * panel.halfWidth +
      (2.0 * place.y - 1.0) * panel.halfHeight;
    const glm::dvec3 away = at.position - p;
    const double d = glm::length(away);
    const double cosine = glm::dot(away, panel.normal) / d;
    if (cosine > 0.0)
    {
      samples.push_back({ p, panel.luminance * panel.area * cosine / (d * d), 0.0, NoFacet });
    }
  }
  sums.resize(this->Triangles.size());
  this->Shares(0, sums.size(), at, sums.data());
  std::partial_sum(sums.begin(), sums.end(), sums.begin());
  this->SampleFacets(at, place, choice, sums, samples);
}

void ReferenceLamps::SampleFacets(const LitPlace& at, const glm::dvec2& place, double choice,
  const std::vector<float>& sums, std::vector<LampSample>& samples) const
{
  if (sums.empty() || !(sums.back() > 0.0f))
  {
    return;
  }
  const auto chosen = std::upper_bound(sums.begin(), sums.end(), choice * double{ sums.back() });
  const auto last = static_cast<std::ptrdiff_t>(sums.size()) - 1;
  const Triangle& triangle =
    this->Triangles[static_cast<std::size_t>(std::min(chosen - sums.begin(), last))];
  const double root = std::sqrt(place.x);
  const glm::dvec3 p =
    (1.0 - root) * triangle.a + root * (1.0 - place.y) * triangle.b + root * place.y * triangle.c;
  const double density = this->Density(triangle.facet, at, p, double{ sums.back() });
  if (density > 0.0)
  {
    samples.push_back({ p, triangle.luminance / density, density, triangle.facet });
  }
}

double ReferenceLamps::Density(
  std::uint32_t facet, const LitPlace& at, const glm::dvec3& place, double sum) const
{
  const std::uint32_t index = this->TriangleOfFacet[facet];
  const Triangle& triangle = this->Triangles[index];
  const glm::dvec3 away = at.position - place;
  const double d2 = glm::dot(away, away);
  const double cosine = glm::dot(away, triangle.normal) / std::sqrt(d2);
  float share = 0.0f;
  this->Shares(index, index + 1, at, &share);
  return cosine > 0.0 && share > 0.0f ? double{ share } / sum * d2 / (triangle.area * cosine) : 0.0;
}

double ReferenceLamps::SkyLuminance(const glm::dvec3& direction) const
{
  const double sine = glm::dot(direction, this->Up);
  return sine > 0.0 ? this->Zenith * (1.0 + 2.0 * sine) / 3.0 : 0.0;
}
