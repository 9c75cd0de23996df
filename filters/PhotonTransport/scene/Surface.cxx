// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/Surface.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace PhotonTransport
{
namespace
{

using Where = InvalidInput::Where;

template <typename... Parts>
[[noreturn]] void Refuse(Where where, std::size_t index, const Parts&... parts)
{
  std::ostringstream message;
  message.precision(std::numeric_limits<float>::max_digits10);
  (message << ... << parts);
  throw InvalidInput(where, index, message.str());
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
  if (surface.reflectance.size() != facets)
  {
    Refuse(Where::Surface, 0, "there are ", surface.reflectance.size(), " reflectances for ",
      facets, " triangles");
  }
  if (!surface.exitance.empty() && surface.exitance.size() != facets)
  {
    Refuse(Where::Surface, 0, "there are ", surface.exitance.size(), " exitances for ", facets,
      " triangles");
  }
  if (!(surface.metresPerUnit > 0.0) || !std::isfinite(surface.metresPerUnit))
  {
    Refuse(Where::TraceSettings, 0, "metres per unit is ", surface.metresPerUnit,
      "; it must be a finite number above 0");
  }
}

} // namespace

void Validate(const Surface& surface)
{
  ValidateSizes(surface);
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
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
    // Negated comparisons refuse NaN too.
    if (!(surface.reflectance[f] >= 0.0f && surface.reflectance[f] <= 1.0f))
    {
      Refuse(Where::Facet, f, "reflectance ", surface.reflectance[f], " is outside [0, 1]");
    }
    if (!surface.exitance.empty() &&
      !(surface.exitance[f] >= 0.0f && std::isfinite(surface.exitance[f])))
    {
      Refuse(
        Where::Facet, f, "exitance ", surface.exitance[f], " lm/m^2 is not a finite number >= 0");
    }
  }
}

} // namespace PhotonTransport
