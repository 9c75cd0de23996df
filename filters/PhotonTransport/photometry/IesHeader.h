// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/TextReader.h"

#include <string>

namespace PhotonTransport
{

/// What the number after the ballast factor means, by the edition that the header names.
enum class IesEdition
{
  Unknown,          ///< No line names an edition, as in files of 1986.
  WithoutYear,      ///< A line names LM-63 without a year that an edition may have.
  FactorAfterwards, ///< Before 1995: it is the ballast-lamp photometric factor.
  Since1995         ///< It is no factor: reserved until 2019, then how the file was made.
};

/// The lines of an IES file before its numbers.
struct IesHeader
{
  std::string description;
  std::string tilt; ///< What follows TILT=.
  IesEdition edition = IesEdition::Unknown;
};

/// Reads up to the line TILT= and throws PhotometricFileError if there is none. The line with the
/// edition may come anywhere before, in any of the spellings in use.
IesHeader ReadIesHeader(TextReader& reader);

} // namespace PhotonTransport
