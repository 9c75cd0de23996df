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
  double factor = 1.0; ///< Of all intensities.
};

/// How a file may deviate from the standard without being ambiguous.
struct IesReading
{
  Commas commas = Commas::Separate;
  bool hasWatts = true;
};

/// Reads them, and what the solid keeps of them.
IesCounts ReadIesCounts(
  TextReader& reader, IesEdition edition, const IesReading& reading, PhotometricSolid& solid);

} // namespace PhotonTransport
