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
// and what tells how the same light arrives at a point:
//  - Numbers: how many numbers choose a place on the lamp
//  - Arriving(point, u, v): the light of such a place at a point, in the scene's coordinates; u and
//    v are in [0, 1). What shines from triangles takes one of them as a further argument
//  - Unobstructed(point, normal), for lamps whose places take numbers: the illuminance of a surface
//    with that normal at the point by all of the lamp, in a closed form; nothing where there is
//    none
//  - RadiancePerLumen(towards), in place of these, for skies: luminance for 1 lm of flux, times
//    what makes the integral of luminance and cosine an illuminance per scene unit squared; 0 where
//    there is no sky
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/geometry/Similarity.h"
#include "PhotonTransport/lights/Incidence.h"
#include "PhotonTransport/materials/Colour.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace PhotonTransport
{

class PhotonSample;
class Scene;
struct Ray;
struct Share;

enum class LampClass
{
  Parallel,    ///< Light from afar, in one direction.
  Sky,         ///< Light from afar, from many directions.
  Point,       ///< Light from one point, by a formula.
  Photometric, ///< Light from one point, by measured intensities.
  Area         ///< Light from an area or a line.
};

using LampNotes = std::vector<std::string>;

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

} // namespace PhotonTransport
