// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/PhotometricSolid.h"
#include "PhotonTransport/photometry/TextReader.h"

#include <vector>

namespace PhotonTransport
{

/// What lines 3 to 7 of an EULUMDAT file say of the angles and intensities to come.
struct EulumdatGrid
{
  std::size_t symmetry = 0;   ///< 0 none, 1 revolution, 2 plane of 0, 3 plane of 90, 4 both.
  std::size_t planes = 0;     ///< Of the full circle.
  std::size_t angles = 0;     ///< In each plane.
  std::size_t planesLine = 1; ///< Where the number of planes stands.

  std::size_t FirstGiven() const { return this->symmetry == 3 ? 3 * this->planes / 4 : 0; }
  std::size_t Given() const;
  /// What the number of planes must be a multiple of.
  std::size_t Divisor() const;
};

/// How many planes a file lists and gives. The standard lists all and gives those that the
/// symmetry does not repeat; some programs do otherwise, which shows in how many numbers there are.
enum class EulumdatPlanes
{
  Standard,
  AllGiven,  ///< Intensities of all that are listed, whatever the symmetry.
  ListGiven, ///< Only those are listed that are given.
  Closed     ///< 360 degrees are listed beside 0.
};

constexpr EulumdatPlanes AllEulumdatPlanes[] = { EulumdatPlanes::Standard, EulumdatPlanes::AllGiven,
  EulumdatPlanes::ListGiven, EulumdatPlanes::Closed };

EulumdatGrid ReadEulumdatGrid(TextReader& reader);

/// Numbers from the first C-angle to the last intensity; 0 where the grid can't be of this kind.
std::size_t NumbersOf(const EulumdatGrid& grid, EulumdatPlanes planes);

/// Reads C-angles, gamma angles and intensities, cd, and adds what the symmetry leaves out.
/// @param factor On the file's numbers.
void ReadEulumdatSolid(TextReader& reader, const EulumdatGrid& grid, EulumdatPlanes planes,
  double factor, PhotometricSolid& solid);

} // namespace PhotonTransport
