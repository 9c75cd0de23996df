// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <sstream>
#include <string>

namespace PhotonTransport
{

/// A message of its parts. Numbers have all digits of single precision, so that a value just beyond
/// a limit does not read like the limit.
template <typename... Parts>
std::string ValueText(const Parts&... parts)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<float>::max_digits10);
  (text << ... << parts);
  return text.str();
}

} // namespace PhotonTransport
