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
  /// 0: none. 1: about the axis. 2: to the plane of C0 and C180. 3: to that of C90 and C270. 4:
  /// both.
  std::size_t symmetry = 0;
  std::size_t planes = 0;     ///< Of the full circle.
  std::size_t angles = 0;     ///< In each plane.
  std::size_t planesLine = 1; ///< Where the number of planes stands.

  /// Number of the first plane that the standard gives intensities of, from 0.
  std::size_t FirstGiven() const { return this->symmetry == 3 ? 3 * this->planes / 4 : 0; }
  /// How many planes the standard gives intensities of.
  std::size_t Given() const;
  /// What the number of planes must be a multiple of.
  std::size_t Divisor() const;
};

/// How many C-angles a file lists, and of how many planes it gives intensities. The standard lists
/// all angles and gives the planes that the symmetry does not repeat. Some programs write another
/// number of them, which the count of all numbers tells.
enum class EulumdatPlanes
{
  Standard,
  AllGiven,  ///< All planes are listed and given, whatever the symmetry.
  ListGiven, ///< Only the planes that are given are listed.
  Closed     ///< As Standard, with 360 degrees listed in addition to 0.
};

constexpr EulumdatPlanes AllEulumdatPlanes[] = { EulumdatPlanes::Standard, EulumdatPlanes::AllGiven,
  EulumdatPlanes::ListGiven, EulumdatPlanes::Closed };

/// Reads lines 3 to 7. Throws PhotometricFileError for counts that are missing or out of range.
EulumdatGrid ReadEulumdatGrid(TextReader& reader);

/// How many numbers there are from the first C-angle to the last intensity; 0 where the grid can't
/// be of this kind.
std::size_t NumbersOf(const EulumdatGrid& grid, EulumdatPlanes planes);

/// Reads C-angles, gamma angles and intensities (cd), and adds the planes that the symmetry leaves
/// out. Throws PhotometricFileError. @param factor By which the file's intensities are multiplied.
void ReadEulumdatSolid(TextReader& reader, const EulumdatGrid& grid, EulumdatPlanes planes,
  double factor, PhotometricSolid& solid);

} // namespace PhotonTransport
