// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/NumberText.h"

#include "PhotonTransport/photometry/PhotometricText.h"

#include <charconv>
#include <cmath>
#include <sstream>

namespace PhotonTransport
{
namespace
{

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

} // namespace

bool ParseNumber(std::string_view text, double& value)
{
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
  {
    text.remove_prefix(1); // from_chars takes no plus
  }
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return !text.empty() && error == std::errc() && stop == end && std::isfinite(value);
}

std::string NumberText(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

void MakeCommasPoints(std::string& line)
{
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const bool isInNumber = i > 0 && (IsDigit(line[i - 1]) || line[i - 1] == '-');
    if (line[i] == ',' && IsDigit(line[i + 1]) &&
      (isInNumber || Trimmed(std::string_view(line).substr(0, i)).empty()))
    {
      line[i] = '.';
    }
  }
}

} // namespace PhotonTransport
