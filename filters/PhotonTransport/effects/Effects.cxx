// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/effects/Effects.h"

#include "PhotonTransport/transport/TraceSettings.h"

#include <sstream>

namespace PhotonTransport
{
namespace
{

template <typename... Parts>
std::string Line(const Parts&... parts)
{
  std::ostringstream line;
  (line << ... << parts);
  return line.str();
}

std::string CompensationReason(const Scene& scene, Registration registration)
{
  if (registration == Registration::Flat)
  {
    return "compensation: off, flat registration was chosen";
  }
  return Line("compensation: on, ", scene.Notes().tiltedVertices, " of ", scene.Vertices().size(),
    " points have a normal that differs from a facet's around them");
}

std::string InterreflectionReason(const Scene& scene, const TraceSettings& settings)
{
  const std::size_t reflecting = scene.Notes().reflectingFacets;
  if (reflecting == 0)
  {
    return "interreflection: off, no triangle reflects";
  }
  const std::string share = Line(reflecting, " of ", scene.Facets().size(), " triangles reflect");
  return settings.interreflection ? "interreflection: on, " + share
                                  : "interreflection: off, switched off though " + share +
      "; the photons it would have carried on are counted as cut off";
}

} // namespace

Effects AnalyseEffects(const Scene& scene, const TraceSettings& settings)
{
  Effects effects;
  effects.registration = settings.registration;
  effects.interreflection = scene.Notes().reflectingFacets > 0;
  effects.backSide = settings.registerBackSide;
  effects.reasons = { CompensationReason(scene, settings.registration),
    InterreflectionReason(scene, settings),
    settings.registerBackSide ? "back side: on, its registration was asked for"
                              : "back side: off, its registration was not asked for" };
  return effects;
}

} // namespace PhotonTransport
