// SPDX-License-Identifier: BSD-3-Clause
// What a kind of lamp is made of. Each kind stands with its relatives in a pair of files of this
// folder: a struct of the values that describe it, and the way in which its photons start. Lamp.h
// lists both. Code for lamps of all kinds calls these members of the struct, so that it does not
// compile if one is missing:
//  - Name: the LuminaireType in field data; nullptr for surfaces, which describe themselves
//  - Class: see LampClass
//  - Describe(fields): calls fields(name, value) with the name of the field array of each value, in
//    the array's unit; `fields` writes the value or replaces it by the one that it reads
//  - Place(): the position or centre, in the data's length unit; nothing for light from afar
//  - Move(motion): moves place, axes and size, and leaves fluxes, illuminances and intensities
//  - Notes(name): what the user is to know of the luminaire of that name, one sentence each
//  - Prepare(scene): checks the values, and gives what emits its photons; throws InvalidInput that
//    names the value
// What emits has these:
//  - Emit(sample, share): one photon's ray, in the scene's coordinates
//  - OwnColour(sample, share): the colour of the place where that photon starts, or nullptr where
//    photons have the colour of the luminaire (derive from LuminaireColoured)
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/geometry/Similarity.h"
#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace PhotonTransport
{

enum class LampClass
{
  Parallel,    ///< Light from afar, in one direction.
  Sky,         ///< Light from afar, from many directions.
  Point,       ///< Light from one point, by a formula.
  Photometric, ///< Light from one point, by measured intensities.
  Area         ///< Light from an area or a line.
};

using LampNotes = std::vector<std::string>;

/// The slice of [0, 1) that selects this lamp; the position inside it is reused as a fresh uniform
/// number.
struct Share
{
  double begin = 0.0;
  double width = 1.0;

  double PlaceOf(const PhotonSample& sample) const
  {
    const double choice = sample.EmissionBits(PhotonSample::ChoiceDimension) * 0x1p-32;
    constexpr double Last = 1.0 - 0x1p-53;
    return std::clamp((choice - this->begin) / this->width, 0.0, Last);
  }
};

/// The base of what emits photons that all have the colour of their luminaire.
struct LuminaireColoured
{
  const Colour* OwnColour(const PhotonSample&, const Share&) const { return nullptr; }
};

/// A lamp made ready: what emits its photons, and its luminous flux, lm. For light from outside the
/// flux is what enters the disk or ball from which photons start.
template <typename Emitter>
struct Prepared
{
  Emitter emitter;
  double flux;
};

/// Describes an angle, which fields hold in degrees.
template <typename Fields>
void DescribeAngle(const Fields& fields, const char* name, double& radians)
{
  double degrees = radians * 57.29577951308232;
  fields(name, degrees);
  radians = degrees * 0.017453292519943295;
}

inline Frame FrameOf(const glm::dvec3& unitDirection)
{
  return Frame(glm::vec3(unitDirection));
}

/// Starts a photon of a far lamp just outside the scene: in float, the last digits of a far origin
/// would displace the hit.
inline Ray RayFrom(glm::dvec3 origin, const glm::vec3& direction)
{
  constexpr double Far = 2.0;
  if (glm::dot(origin, origin) > Far * Far)
  {
    const glm::dvec3 along(direction);
    origin += std::max(0.0, -glm::dot(origin, along) - Far) * along;
  }
  return { glm::vec3(origin), direction };
}

} // namespace PhotonTransport
