// SPDX-License-Identifier: BSD-3-Clause
// One lamp in files that programs write in many ways, and its flux by a quadrature that shares no
// code with the readers.
#pragma once

#include "PhotometryTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace PhotometryVariants
{

const std::vector<double> Angles{ 0.0, 30.0, 60.0, 90.0 };
const std::vector<double> Candela{ 900.0, 700.0, 300.0, 40.0 };

/// 2 pi times the integral of I(p) sin p, I linear between the angles, by Simpson's rule in steps
/// of 0.01 degrees, which leaves less than 1e-12 of it.
inline double ExpectedFlux(double factor = 1.0)
{
  const double degree = std::acos(-1.0) / 180.0;
  const auto value = [&](std::size_t i, double part)
  {
    const double p = Angles[i] + part * (Angles[i + 1] - Angles[i]);
    return (Candela[i] + part * (Candela[i + 1] - Candela[i])) * std::sin(p * degree);
  };
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < Angles.size(); ++i)
  {
    const double span = Angles[i + 1] - Angles[i];
    const int steps = static_cast<int>(span / 0.01);
    for (int k = 0; k < steps; ++k)
    {
      const double h = 1.0 / steps;
      sum += span * degree * h / 6.0 *
        (value(i, k * h) + 4.0 * value(i, (k + 0.5) * h) + value(i, (k + 1) * h));
    }
  }
  return 360.0 * degree * sum * factor;
}

inline std::string Joined(const std::vector<std::string>& lines, const std::string& end = "\n")
{
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + end;
  }
  return text;
}

/// An IES file by lines. @param header Before the keywords. @param numbers After the ballast
/// factor.
inline std::vector<std::string> Ies(const std::vector<std::string>& header,
  const std::string& numbers = "1 20", const std::string& lumens = "-1")
{
  std::vector<std::string> lines = header;
  for (const std::string& line : { std::string("[TEST] x1"), std::string("[MANUFAC] own"),
         std::string("TILT=NONE"), "1 " + lumens + " 1 4 1 1 2 0.1 0.1 0", "1 " + numbers,
         std::string("0 30 60 90"), std::string("0"), std::string("900 700 300 40") })
  {
    lines.push_back(line);
  }
  return lines;
}

/// Six lines for each set of lamps, in the order of the file.
using Sets = std::vector<std::string>;

/// An EULUMDAT file of 36 lines before its C-angles if it has one set of lamps. It gives its
/// intensities for 1000 lm, and 228 % as
/// the light output ratio, which is what they make.
inline std::vector<std::string> Eulumdat(
  const Sets& sets = { "1", "LED", "1000", "840", "80", "20" })
{
  std::vector<std::string> lines{ "own lamps", "1", "1", "1", "0", "4", "30", "rep", "name", "num",
    "file", "date", "600", "300", "80", "500", "200", "0", "0", "0", "0", "100", "228", "1.0", "0",
    std::to_string(sets.size() / 6) };
  lines.insert(lines.end(), sets.begin(), sets.end());
  lines.insert(lines.end(), 10, "0.5");
  for (const char* number : { "0", "0", "30", "60", "90", "900", "700", "300", "40" })
  {
    lines.emplace_back(number);
  }
  return lines;
}

using Read = PhotonTransport::PhotometricSolid (*)(const std::string& text);

/// ASCII text in UTF-16.
inline std::string Utf16(const std::string& text, bool isLittle, bool hasMark)
{
  std::string bytes = !hasMark ? "" : isLittle ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : text)
  {
    bytes += isLittle ? std::string{ c, '\0' } : std::string{ '\0', c };
  }
  return bytes;
}

inline std::string Replaced(std::string text, const std::string& what, const std::string& by)
{
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
  {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// Tells the table in Testing/README.md what became of a test's files.
class FileTest : public ::testing::Test
{
public:
  /// @param protects What the tests protect against.
  explicit FileTest(const char* protects)
    : Protects(protects)
  {
    NumberRead = NumberRefused = 0;
  }

  static inline int NumberRead = 0;
  static inline int NumberRefused = 0;

protected:
  void TearDown() override
  {
    this->RecordProperty("protects", this->Protects);
    const auto part = [](int number, const char* what)
    { return number > 0 ? std::to_string(number) + what : std::string(); };
    this->RecordProperty("measured",
      part(NumberRead, " read") + (NumberRead > 0 && NumberRefused > 0 ? ", " : "") +
        part(NumberRefused, " refused"));
  }

private:
  std::string Protects;
};

} // namespace PhotometryVariants
