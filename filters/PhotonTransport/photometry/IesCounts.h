// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/IesHeader.h"
#include "PhotonTransport/photometry/PhotometricSolid.h"

namespace PhotonTransport
{

/// The numbers between the header and the angles.
struct IesCounts
{
  std::size_t vertical = 0;
  std::size_t horizontal = 0;
  double factor = 1.0; ///< By which all intensities are multiplied.
};

/// Deviations from the standard that can be told from the numbers.
struct IesReading
{
  Commas commas = Commas::Separate;
  bool hasWatts = true; ///< False: the line ends before the input watts.
};

/// Reads the numbers; the solid gets its type, rated flux, opening and input power. Throws
/// PhotometricFileError.
IesCounts ReadIesCounts(
  TextReader& reader, IesEdition edition, const IesReading& reading, PhotometricSolid& solid);

} // namespace PhotonTransport
