// SPDX-License-Identifier: BSD-3-Clause
#ifndef Text_h
#define Text_h

#include <sstream>
#include <string>

namespace Illumination
{

/// A message of its parts.
template <typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

} // namespace Illumination

#endif
