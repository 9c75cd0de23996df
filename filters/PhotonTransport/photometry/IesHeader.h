// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/TextReader.h"

#include <string>
#include <vector>

namespace PhotonTransport
{

/// The lines of an IES file before its numbers.
struct IesHeader
{
  std::string description;
  std::string tilt;  ///< What follows TILT=.
  bool isOld = true; ///< Of 1986 or 1991.
};

/// Reads up to the line TILT= and throws PhotometricFileError if there is none.
IesHeader ReadIesHeader(TextReader& reader);

/// The factor of a luminaire that is not tilted. @param tilt What follows TILT=. @param folder
/// Where its file is, if it names one.
double ReadIesTilt(TextReader& reader, const std::string& tilt, const std::string& folder);

/// Degrees, rising, as many as `count`.
std::vector<double> ReadIesAngles(
  TextReader& reader, const char* name, std::size_t count, double smallest, double largest);

/// Refuses the last angle unless it is above the one before it.
void RequireRising(
  const TextReader& reader, const NumberName& name, const std::vector<double>& angles);

} // namespace PhotonTransport
