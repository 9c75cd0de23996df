// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/PhotometricSolid.h"

#include <istream>
#include <stdexcept>
#include <string>

namespace PhotonTransport
{

/// A photometric file that can't be read. what() says what is wrong and which value; Line is where.
class PhotometricFileError : public std::runtime_error
{
public:
  PhotometricFileError(std::size_t line, const std::string& message)
    : std::runtime_error("line " + std::to_string(line) + ": " + message)
    , Line(line)
  {
  }
  const std::size_t Line; ///< From 1.
};

// Both readers are strict where light depends on it (counts, rising angles, intensities, units,
// factors) and lenient elsewhere. What a program has done differently from the standard is read by
// the first reading for which all numbers that the file announces are there, and no more; what was
// assumed stands in PhotometricSolid::notes. A file for which there is none is refused.

/// IESNA LM-63 of 1991, 1995, 2002 and 2019 (and 1986, which has no format line): photometry types
/// C, B and A with their symmetries, TILT (NONE, INCLUDE, or a file beside it), relative and
/// absolute. Intensities are the file's times the candela multiplier, the ballast factor, the
/// ballast-lamp photometric factor (1986 and 1991; later a number without a meaning here) and the
/// TILT factor at 0 degrees: the factors at other angles are for luminaires that are tilted from
/// the position in which they were measured, which a file can't know. @param folder Of the file,
/// for TILT=name.
PhotometricSolid ReadIes(std::istream& file, const std::string& folder = {});

/// EULUMDAT (.ldt): symmetries 0 to 4, cd/klm times the flux of the lamps and the conversion
/// factor. Sets of lamps are alternatives, the first one counts, in whichever of the two orders in
/// use they are written.
PhotometricSolid ReadEulumdat(std::istream& file);

/// By the name's extension: .ies, .ldt (or .eul), in any case. Throws std::runtime_error with the
/// name for a file that can't be opened or is of another kind, and PhotometricFileError.
PhotometricSolid ReadPhotometricFile(const std::string& path);

/// Whether a name has one of those extensions.
bool IsPhotometricFileName(const std::string& path);

} // namespace PhotonTransport
