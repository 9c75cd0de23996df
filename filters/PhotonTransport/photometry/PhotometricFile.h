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
// factors) and lenient elsewhere. A file that deviates from the standard is read in several ways,
// one after the other. The first way counts in which all numbers that the file announces are there,
// and no more. PhotometricSolid::notes say what was assumed. A file that can be read in no way is
// refused by a PhotometricFileError, which is that of the standard's way.

/// IESNA LM-63 of 1986, which has no format line, 1991, 1995, 2002 and 2019: photometry types C, B
/// and A with their symmetries, TILT (NONE, INCLUDE, or a file beside it), relative and absolute
/// photometry. Intensities are the file's times the candela multiplier, the ballast factor, the
/// ballast-lamp photometric factor (before 1995) and the TILT factor at 0 degrees. The TILT factors
/// at other angles are for luminaires that are tilted from the position in which they were
/// measured; they are not used. @param folder Where the file is, for TILT=name.
PhotometricSolid ReadIes(std::istream& file, const std::string& folder = {});

/// EULUMDAT (.ldt), symmetries 0 to 4. Intensities are the file's, in cd/klm, times the flux of the
/// first set of lamps in klm and the conversion factor. See EulumdatLamps.
PhotometricSolid ReadEulumdat(std::istream& file);

/// By the name's extension: .ies, .ldt (or .eul), in any case. Throws std::runtime_error with the
/// name for a file that can't be opened or is of another kind, and PhotometricFileError.
PhotometricSolid ReadPhotometricFile(const std::string& path);

/// Whether a name has one of those extensions.
bool IsPhotometricFileName(const std::string& path);

} // namespace PhotonTransport
