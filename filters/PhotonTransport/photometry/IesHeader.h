// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/TextReader.h"

#include <string>

namespace PhotonTransport
{

/// What the lines before the numbers say of the number after the ballast factor.
enum class IesEdition
{
  Unknown,          ///< No line says it, as in files of 1986.
  WithoutYear,      ///< LM-63 without a year that an edition may have.
  FactorAfterwards, ///< 1986 and 1991: the ballast-lamp photometric factor.
  Since1995         ///< Reserved in 1995 and 2002, in 2019 how the file came about; never a factor.
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
