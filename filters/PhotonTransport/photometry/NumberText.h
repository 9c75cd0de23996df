// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text.
#pragma once

#include <string>
#include <string_view>

namespace PhotonTransport
{

/// Photometric files with larger numbers are refused. It is far beyond any lamp, and sums of such
/// numbers are finite.
constexpr double LargestNumber = 1e30;

/// A number as photometric files have them. @return False for anything else.
bool ParseNumber(std::string_view text, double& value);

/// The number with at most six significant digits.
std::string NumberText(double value);

/// Commas between digits, and those that begin a line's first number, become points.
void MakeCommasPoints(std::string& line);

} // namespace PhotonTransport
