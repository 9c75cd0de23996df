// SPDX-License-Identifier: BSD-3-Clause
// Angles and intensities, which files of all kinds have.
#pragma once

#include "PhotonTransport/photometry/PhotometricSolid.h"
#include "PhotonTransport/photometry/TextReader.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace PhotonTransport
{

/// More planes or angles than this is no photometry, but a broken count.
constexpr std::size_t MostAngles = 10000;
constexpr std::size_t MostIntensities = 10000000;

/// Refuses more than MostIntensities.
void RequireManageable(const TextReader& reader, std::size_t planes, std::size_t angles);

/// Reads `count` rising angles, degrees, within [smallest, largest]. Throws PhotometricFileError.
/// @param requireFirst Throws for a first angle that is not allowed; empty if all are.
std::vector<double> ReadAngles(TextReader& reader, const char* name, std::size_t count,
  double smallest, double largest, const std::function<void(double)>& requireFirst = {});

/// Reads the file's last `count` numbers as intensities, cd: finite, >= 0, and one above 0. Throws
/// PhotometricFileError. @param factor By which the file's numbers are multiplied.
std::vector<double> ReadIntensities(
  TextReader& reader, const char* name, std::size_t count, double factor);

/// The number that the text is, with a decimal point or comma; nothing for other text.
std::optional<double> Number(std::string text);

/// Watts as in 58, 58 W and 2x58 W; nothing for other text.
std::optional<double> WattsOf(std::string text);

/// The same for a lamp's power, on which the light does not depend: 0 for text that says none. A
/// note says what was taken for text that is no number. @param name Of what the text is.
double LenientWatts(TextReader& reader, const char* name, const std::string& text);

/// Adds a note if the intensities of relative photometry make another flux than the file states, by
/// more than 1 % of the lamps' flux and more than 5 % of the stated part. @param stated The
/// luminaire's part of the lamps' flux by the file, %. 0: the file does not say; a note is added
/// where the part is above 105 %.
void NoteOnOutputRatio(PhotometricSolid& solid, double stated);

} // namespace PhotonTransport
