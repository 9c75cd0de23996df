// SPDX-License-Identifier: BSD-3-Clause
#include "RandomChoices.h"

#include "PhotonTransport/materials/MaterialProperties.h"

#include <algorithm>
#include <cmath>

using namespace PhotonTransport;

namespace
{

glm::dvec3 AnyNormal()
{
  const glm::dvec3 direction(Anywhere(), Anywhere(), Anywhere());
  switch (Below(12))
  {
    case 0:
      return glm::dvec3(0.0);
    case 1:
      return { NoNumber, 0.0, 1.0 };
    case 2:
      return { Infinity, direction.y, direction.z };
    case 3:
      return OneOf({ 1e-310, 1e-200, 1e-20, 1e20, 1e200 }) * direction;
    case 4:
    case 5:
      return { 0.0, 0.0, OneIn(2) ? -1.0 : 1.0 };
    default:
      return direction;
  }
}

/// A share of what the others have left, often none or all of it.
float ShareOf(double& rest)
{
  const auto share =
    static_cast<float>(rest * OneOf({ 0.0, 0.0, 0.5, 1.0, 1e-30, std::fabs(Anywhere()) }));
  rest = std::max(0.0, rest - double{ share });
  return share;
}

Material DrawMaterial()
{
  Material material;
  std::vector<Colour*> shares;
  for (const MaterialProperty& property : MaterialProperties)
  {
    if (const auto* share = std::get_if<Colour Material::*>(&property.member))
    {
      shares.push_back(&(material.**share));
    }
  }
  const bool grey = OneIn(2);
  // The first takes what it wants; the others have the rest.
  const auto first = static_cast<std::size_t>(Below(static_cast<int>(shares.size())));
  for (int channel = 0; channel < (grey ? 1 : 3); ++channel)
  {
    double rest = 1.0;
    for (std::size_t s = 0; s < shares.size(); ++s)
    {
      (*shares[(first + s) % shares.size()])[channel] = ShareOf(rest);
    }
  }
  for (Colour* share : shares)
  {
    *share = grey ? Colour(share->x) : *share;
  }
  material.roughness = OneOf({ 0.3f, 1.0f, 1e-3f, 1e-20f, 1e-45f });
  material.refractiveIndex = OneOf({ 1.52f, 1.0f, 1.0000001f, 4.0f });
  material.solid = OneIn(2);
  return material;
}

void DrawLightOfFacets(Surface& surface, bool emits)
{
  const bool plain = OneIn(3); // no more than a reflectance
  const int materials = 1 + Below(4);
  for (int m = 0; m < materials; ++m)
  {
    surface.materials.push_back(plain ? Material() : DrawMaterial());
    if (plain)
    {
      surface.materials.back().diffuseReflectance = Colour(
        OneOf({ 0.0f, 0.5f, 0.95f, 0.999f, 1.0f, static_cast<float>(std::fabs(Anywhere())) }));
    }
  }
  const bool coloured = emits && OneIn(2);
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
  {
    surface.materialOfFacet.push_back(static_cast<std::uint32_t>(Below(materials)));
    if (coloured)
    {
      surface.exitance[f] *= Colour(
        OneOf({ 1.0f, 0.0f, 1e-40f, 1e20f }), OneOf({ 1.0f, 0.0f, 0.3f }), OneOf({ 1.0f, 0.0f }));
    }
  }
}

void SpoilMaterial(RandomScene& scene, std::size_t facet)
{
  Surface& surface = scene.surface;
  // The wrong one may be one that no facet has.
  const bool used = OneIn(2);
  surface.materials.resize(3);
  surface.materialOfFacet.assign(surface.facets.size(), 0);
  surface.materialOfFacet[facet] = used ? 2 : 1;
  Material& material = surface.materials[2];
  const auto bad = static_cast<float>(OneOf({ NoNumber, Infinity, -1e-9, 4.5 }));
  switch (Below(5))
  {
    case 0:
      material.glossyReflectance.y = bad;
      scene.mistake = "GlossyReflectance";
      break;
    case 1:
      material.roughness = OneIn(2) ? 0.0f : bad;
      scene.mistake = "Roughness";
      break;
    case 2:
      material.refractiveIndex = OneIn(2) ? 0.999f : bad;
      scene.mistake = "RefractiveIndex";
      break;
    case 3:
      material.diffuseReflectance = Colour(0.0f, 0.6f, 0.0f);
      material.clearTransmittance = Colour(0.0f, 0.4001f, 0.0f);
      scene.mistake = "must not exceed 1";
      break;
    default:
      surface.materialOfFacet[facet] = OneIn(2) ? 3 : 0xffffffffu;
      scene.mistake = "it has material";
  }
}

} // namespace

Surface DrawSurface(const Site& site)
{
  Surface surface;
  const int points = 3 + Below(14);
  for (int p = 0; p < points; ++p)
  {
    surface.points.push_back(site.origin + site.size * Place());
    surface.normals.push_back(AnyNormal());
  }
  const int facets = 1 + Below(20);
  const bool emits = OneIn(4);
  for (int f = 0; f < facets; ++f)
  {
    const int a = Below(points);
    // Mostly three different corners; a facet that uses a point twice has no area.
    const int b = (a + (OneIn(16) ? 0 : 1 + Below(points - 1))) % points;
    const int c = Below(points);
    surface.facets.emplace_back(a, b, c);
    if (emits)
    {
      surface.exitance.emplace_back(OneOf({ 0.0f, 1e-12f, 100.0f, 1e12f }));
    }
  }
  DrawLightOfFacets(surface, emits);
  surface.metresPerUnit = OneOf({ 1.0, 1.0, 1e-3, 0.0254, 1e3 });
  return surface;
}

void SpoilSurface(RandomScene& scene)
{
  Surface& surface = scene.surface;
  const auto f = static_cast<std::size_t>(Below(static_cast<int>(surface.facets.size())));
  switch (Below(8))
  {
    case 0:
      surface.facets[f].y = OneIn(2) ? static_cast<unsigned>(surface.points.size()) : 0xffffffffu;
      scene.mistake = "uses point";
      break;
    case 1:
      surface.points[surface.facets[f].z].y = OneOf({ NoNumber, Infinity, -Infinity });
      scene.mistake = "are not finite";
      break;
    case 2:
      surface.materialOfFacet[f] = static_cast<std::uint32_t>(surface.materials.size());
      surface.materials.emplace_back().diffuseReflectance =
        Colour(static_cast<float>(OneOf({ NoNumber, Infinity, -1e-9, 1.0000001, 2.0 })));
      scene.mistake = "it must be within [0, 1]";
      break;
    case 3:
      surface.exitance.assign(surface.facets.size(), Colour(1.0f));
      surface.exitance[f][Below(3)] = static_cast<float>(OneOf({ NoNumber, Infinity, -1.0 }));
      scene.mistake = "is not a finite number >= 0";
      break;
    case 4:
      surface.metresPerUnit = OneOf({ 0.0, -1.0, NoNumber, Infinity });
      scene.mistake = "metres per unit";
      break;
    case 5:
      SpoilMaterial(scene, f);
      break;
    case 6:
      surface.materials.resize(1);
      surface.materialOfFacet.resize(surface.facets.size() - 1);
      scene.mistake = "indices of materials for";
      break;
    default:
      surface.normals.pop_back();
      scene.mistake = "normals for";
  }
}
