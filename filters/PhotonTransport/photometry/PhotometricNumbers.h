// SPDX-License-Identifier: BSD-3-Clause
// What files of all kinds have in common, and what their light depends on: angles and intensities.
#pragma once

#include "PhotonTransport/photometry/PhotometricSolid.h"
#include "PhotonTransport/photometry/TextReader.h"

#include <functional>
#include <vector>

namespace PhotonTransport
{

/// More planes or angles than this is no photometry, but a broken count.
constexpr std::size_t MostAngles = 10000;
constexpr std::size_t MostIntensities = 10000000;

/// Refuses more than MostIntensities.
void RequireManageable(const TextReader& reader, std::size_t planes, std::size_t angles);

/// Degrees, rising, as many as `count`. @param requireFirst Refuses a first angle that is not
/// allowed; none: all are.
std::vector<double> ReadAngles(TextReader& reader, const char* name, std::size_t count,
  double smallest, double largest, const std::function<void(double)>& requireFirst = {});

/// Intensities, cd, to the last one of the file: finite, >= 0, and one above 0. @param factor On
/// the file's numbers.
std::vector<double> ReadIntensities(
  TextReader& reader, const char* name, std::size_t count, double factor);

/// Notes where the intensities of relative photometry do not make the flux that they should.
/// @param stated The luminaire's share of the lamps' flux by the file, %; 0: not stated, at most
/// 100.
void NoteOnOutputRatio(PhotometricSolid& solid, double stated);

} // namespace PhotonTransport
