// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/Surface.h"

#include "PhotonTransport/materials/MaterialProperties.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/materials/ValueText.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/threads/Threads.h"

#include <cmath>
#include <limits>

namespace PhotonTransport
{
namespace
{

using Where = InvalidInput::Where;

template <typename... Parts>
[[noreturn]] void Refuse(Where where, std::size_t index, const Parts&... parts)
{
  throw InvalidInput(where, index, ValueText(parts...));
}

void ValidateSizes(const Surface& surface)
{
  const std::size_t facets = surface.facets.size();
  if (facets == 0)
  {
    Refuse(Where::Surface, 0, "the surface has no triangles");
  }
  constexpr std::size_t Most = std::numeric_limits<unsigned>::max() - 1u;
  if (facets > Most || surface.points.size() > Most)
  {
    Refuse(Where::Surface, 0, "the surface has ", facets, " triangles and ", surface.points.size(),
      " points; at most ", Most, " of each can be traced");
  }
  if (surface.normals.size() != surface.points.size())
  {
    Refuse(Where::Surface, 0, "there are ", surface.normals.size(), " normals for ",
      surface.points.size(), " points");
  }
  const auto requireOneEach = [&](std::size_t count, const char* what)
  {
    if (count != facets)
    {
      Refuse(Where::Surface, 0, "there are ", count, " ", what, " for ", facets, " triangles");
    }
  };
  requireOneEach(surface.materialOfFacet.size(), "indices of materials");
  requireOneEach(surface.exitance.empty() ? facets : surface.exitance.size(), "exitances");
  requireOneEach(
    surface.openingOfFacet.empty() ? facets : surface.openingOfFacet.size(), "marks of openings");
  if (!(surface.metresPerUnit > 0.0) || !std::isfinite(surface.metresPerUnit))
  {
    Refuse(Where::TraceSettings, 0, "metres per unit is ", surface.metresPerUnit,
      "; it must be a finite number above 0");
  }
  if (!(surface.rounding >= 0.0) || !std::isfinite(surface.rounding))
  {
    Refuse(Where::Surface, 0, "the rounding of its points is ", surface.rounding,
      "; it must be a finite number >= 0");
  }
}

/// @param problems Of each material.
void ValidateMaterial(
  const Surface& surface, std::size_t f, const std::vector<std::string>& problems)
{
  const std::uint32_t material = surface.materialOfFacet[f];
  if (material >= surface.materials.size())
  {
    Refuse(Where::Facet, f, "it has material ", material, " of ", surface.materials.size());
  }
  if (!problems[material].empty())
  {
    Refuse(Where::Facet, f, problems[material]);
  }
}

void ValidateExitance(const Surface& surface, std::size_t f)
{
  for (int c = 0; c < 3 && !surface.exitance.empty(); ++c)
  {
    const float value = surface.exitance[f][c];
    if (!(value >= 0.0f && std::isfinite(value)))
    {
      Refuse(Where::Facet, f, "exitance ", value, " lm/m^2 is not a finite number >= 0");
    }
  }
}

void ValidateFacet(const Surface& surface, std::size_t f, const std::vector<std::string>& problems)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const unsigned p = surface.facets[f][corner];
    if (p >= surface.points.size())
    {
      Refuse(Where::Facet, f, "it uses point ", p, " of ", surface.points.size());
    }
    const glm::dvec3& x = surface.points[p];
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z))
    {
      Refuse(Where::Point, p, "its coordinates (", x.x, ", ", x.y, ", ", x.z, ") are not finite");
    }
  }
  ValidateMaterial(surface, f, problems);
  ValidateExitance(surface, f);
}

} // namespace

void Validate(const Surface& surface)
{
  ValidateSizes(surface);
  std::vector<std::string> problems;
  problems.reserve(surface.materials.size());
  for (const Material& material : surface.materials)
  {
    problems.push_back(ProblemOf(material));
  }
  const auto validate = [&](std::size_t f) { ValidateFacet(surface, f, problems); };
  try
  {
    ForEach(surface.facets.size(), validate);
  }
  catch (const InvalidInput&)
  {
    for (std::size_t f = 0; f < surface.facets.size(); ++f)
    {
      validate(f); // throws for the first one in the list, whatever the threads
    }
  }
  // Triangles' materials have been named by now.
  for (std::size_t m = 0; m < problems.size(); ++m)
  {
    if (!problems[m].empty())
    {
      Refuse(Where::Surface, 0, "material ", m, ", which no triangle has: ", problems[m]);
    }
  }
}

bool IsColoured(const Surface& surface, std::size_t facet)
{
  return IsColoured(surface.materials[surface.materialOfFacet[facet]]) ||
    (!surface.exitance.empty() && !IsGrey(surface.exitance[facet]));
}

} // namespace PhotonTransport
