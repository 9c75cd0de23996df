// SPDX-License-Identifier: BSD-3-Clause
// ANSI/IES LM-63, "Standard File Format for the Electronic Transfer of Photometric Data".
#include "PhotonTransport/photometry/IesCounts.h"
#include "PhotonTransport/photometry/IesHeader.h"
#include "PhotonTransport/photometry/IesTilt.h"
#include "PhotonTransport/photometry/PhotometricFile.h"
#include "PhotonTransport/photometry/PhotometricNumbers.h"
#include "PhotonTransport/photometry/Readings.h"
#include "PhotonTransport/photometry/SolidSymmetry.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace PhotonTransport
{

namespace
{

using Type = PhotometricSolid::Type;

/// Type C: 0 alone; 0 to 90, 180 or 360; 90 to 270; or 0 to one step before 360.
std::vector<double> ReadHorizontalC(TextReader& reader, std::size_t count)
{
  constexpr const char* name = "horizontal angle";
  const auto requireFirst = [&](double first)
  {
    if (first != 0.0 && (first != 90.0 || count == 1))
    {
      reader.Refuse({ name, 1 }, "the first must be 0, or 90 where the last is 270");
    }
  };
  const std::vector<double> angles = ReadAngles(reader, name, count, 0.0, 360.0, requireFirst);
  const double last = angles.back();
  const bool known = angles[0] == 90.0
    ? last == 270.0
    : count == 1 || last == 90.0 || last == 180.0 || (last > 180.0 && GapIsOneStep(angles));
  if (!known)
  {
    reader.Refuse({ name, count },
      angles[0] == 90.0 ? "the last must be 270 where the first is 90"
                        : "the last must be 90, 180, 360 or one step before 360");
  }
  return angles;
}

/// Types A and B: from 0 (mirrored there) or from below 0.
std::vector<double> ReadSymmetricAngles(
  TextReader& reader, const char* name, std::size_t count, double largest)
{
  const auto requireFirst = [&](double first)
  {
    if (first > 0.0)
    {
      reader.Refuse({ name, 1 }, "the first must be 0, where the lamp is symmetric, or below");
    }
  };
  return ReadAngles(reader, name, count, -largest, largest, requireFirst);
}

void SetTypeC(PhotometricSolid& solid, std::vector<double> vertical, std::vector<double> horizontal)
{
  solid.polar = std::move(vertical);
  solid.azimuth = std::move(horizontal);
  if (solid.azimuth.back() == 90.0)
  {
    MirrorAtLastAzimuth(solid);
  }
  if (solid.azimuth.back() - solid.azimuth.front() == 180.0)
  {
    MirrorAtLastAzimuth(solid);
  }
  CloseCircle(solid);
}

/// The elevation above the equator and the angle about the pole of types A and B.
void SetTypeAOrB(PhotometricSolid& solid, const std::vector<double>& vertical,
  const std::vector<double>& horizontal)
{
  const bool isA = solid.type == Type::A;
  const std::vector<double>& elevation = isA ? vertical : horizontal;
  solid.azimuth = isA ? horizontal : vertical;
  std::vector<double> candela;
  for (std::size_t i = 0; i < solid.azimuth.size(); ++i)
  {
    for (std::size_t j = elevation.size(); j-- > 0;)
    {
      candela.push_back(solid.candela[isA ? i * vertical.size() + j : j * vertical.size() + i]);
    }
  }
  solid.candela = std::move(candela);
  std::transform(elevation.rbegin(), elevation.rend(), std::back_inserter(solid.polar),
    [](double angle) { return 90.0 - angle; });
  if (elevation.front() == 0.0)
  {
    MirrorAtEquator(solid);
  }
  if (solid.azimuth.front() == 0.0)
  {
    MirrorAtFirstAzimuth(solid);
  }
}

PhotometricSolid Read(
  const PhotometricText& text, const std::string& folder, const IesReading& reading)
{
  TextReader reader(text, reading.commas);
  const IesHeader header = ReadIesHeader(reader);
  PhotometricSolid solid;
  solid.description = header.description;
  const double tiltFactor = ReadIesTilt(reader, header.tilt, folder);
  IesCounts counts = ReadIesCounts(reader, header.edition, reading, solid);
  counts.factor *= tiltFactor;
  constexpr const char* vertical = "vertical angle";
  constexpr const char* horizontal = "horizontal angle";
  const auto readIntensities = [&]
  {
    solid.candela =
      ReadIntensities(reader, "candela value", counts.horizontal * counts.vertical, counts.factor);
    solid.notes = reader.Notes();
  };
  if (solid.type == Type::C)
  {
    auto polar = ReadAngles(reader, vertical, counts.vertical, 0.0, 180.0);
    auto azimuth = ReadHorizontalC(reader, counts.horizontal);
    readIntensities();
    SetTypeC(solid, std::move(polar), std::move(azimuth));
    return solid;
  }
  const bool isA = solid.type == Type::A;
  const auto v = ReadSymmetricAngles(reader, vertical, counts.vertical, isA ? 90.0 : 180.0);
  const auto h = ReadSymmetricAngles(reader, horizontal, counts.horizontal, isA ? 180.0 : 90.0);
  readIntensities();
  SetTypeAOrB(solid, v, h);
  return solid;
}

bool IsNumberWithComma(std::string_view token)
{
  const std::size_t comma = token.find(',');
  return comma != std::string_view::npos && comma > 0 && comma + 1 < token.size() &&
    token.find(',', comma + 1) == std::string_view::npos &&
    token.find_first_not_of("0123456789,.+-") == std::string_view::npos;
}

/// Whether each comma after the line TILT= stands within a number that blanks separate from others.
bool MayHaveDecimalCommas(const PhotometricText& text)
{
  const auto isTilt = [](const TextLine& line)
  { return UpperCase(Trimmed(line.text).substr(0, 4)) == "TILT"; };
  bool found = false;
  for (auto line = std::find_if(text.lines.begin(), text.lines.end(), isTilt);
       line != text.lines.end(); ++line)
  {
    std::istringstream tokens(line->text);
    for (std::string token; tokens >> token;)
    {
      if (token.find(',') != std::string::npos && !IsNumberWithComma(token))
      {
        return false;
      }
      found = found || IsNumberWithComma(token);
    }
  }
  return found;
}

PhotometricSolid ReadWithNote(
  const PhotometricText& text, const std::string& folder, const IesReading& reading)
{
  PhotometricSolid solid = Read(text, folder, reading);
  NoteOnOutputRatio(solid, 0.0);
  if (reading.commas == Commas::AreDecimal)
  {
    solid.notes.push_back("commas between digits were read as decimal points: taken for "
                          "separators they make the numbers too many or too few");
  }
  return solid;
}

} // namespace

PhotometricSolid ReadIes(std::istream& file, const std::string& folder)
{
  // The standard's reading comes first; another one counts only where that one fails and where all
  // numbers that it announces are there, and no more.
  const PhotometricText text = ReadText(file);
  std::vector<Attempt> attempts;
  for (const Commas commas : { Commas::Separate, Commas::AreDecimal })
  {
    for (const bool hasWatts : { true, false })
    {
      if (commas == Commas::Separate || MayHaveDecimalCommas(text))
      {
        attempts.push_back([&text, &folder, reading = IesReading{ commas, hasWatts }]
          { return ReadWithNote(text, folder, reading); });
      }
    }
  }
  return FirstThatReads(attempts);
}

} // namespace PhotonTransport
