// SPDX-License-Identifier: BSD-3-Clause
// ANSI/IES LM-63, "Standard File Format for the Electronic Transfer of Photometric Data".
#include "PhotonTransport/photometry/IesHeader.h"
#include "PhotonTransport/photometry/PhotometricFile.h"
#include "PhotonTransport/photometry/SolidSymmetry.h"
#include "PhotonTransport/photometry/TextReader.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

namespace
{

using Type = PhotometricSolid::Type;

/// The numbers between the header and the angles.
struct Counts
{
  std::size_t vertical = 0;
  std::size_t horizontal = 0;
  double factor = 1.0; ///< Of all intensities.
};

double PositiveNumber(TextReader& reader, const char* name)
{
  const double value = reader.NextNumber(name, -LargestNumber, LargestNumber);
  if (!(value > 0.0))
  {
    reader.Refuse(name, "it must be above 0");
  }
  return value;
}

void ReadOpening(TextReader& reader, PhotometricSolid& solid)
{
  const double metres = reader.NextCount("units type", 1, 2) == 1 ? 0.3048 : 1.0;
  const auto size = [&](const char* name)
  { return metres * reader.NextNumber(name, -LargestNumber, LargestNumber); };
  const double width = size("width");
  const double length = size("length");
  // Below 0 marks what is round; of a circle, 1995 wants the width alone.
  solid.width = std::abs(width);
  solid.length = width < 0.0 && length == 0.0 ? solid.width : std::abs(length);
  solid.height = std::abs(size("height"));
}

Counts ReadCounts(TextReader& reader, bool isOld, PhotometricSolid& solid)
{
  Counts counts;
  const std::size_t lamps = reader.NextCount("number of lamps", 1, 1000000);
  const double lumens = reader.NextNumber("lumens per lamp", -LargestNumber, LargestNumber);
  if (!(lumens > 0.0 || lumens == -1.0))
  {
    reader.Refuse("lumens per lamp", "it must be above 0, or -1 for absolute photometry");
  }
  solid.ratedFlux = lumens > 0.0 ? static_cast<double>(lamps) * lumens : 0.0;
  counts.factor = PositiveNumber(reader, "candela multiplier");
  counts.vertical = reader.NextCount("number of vertical angles", 2, MostAngles);
  counts.horizontal = reader.NextCount("number of horizontal angles", 1, MostAngles);
  if (counts.vertical * counts.horizontal > MostIntensities)
  {
    reader.Fail("there are " + std::to_string(counts.vertical) + " x " +
      std::to_string(counts.horizontal) + " angles; there must be at most " +
      std::to_string(MostIntensities));
  }
  const Type types[] = { Type::C, Type::B, Type::A };
  solid.type = types[reader.NextCount("photometric type", 1, 3) - 1];
  if (solid.type != Type::C && counts.horizontal < 2)
  {
    reader.Fail("there is 1 horizontal angle; types A and B need 2 or more");
  }
  ReadOpening(reader, solid);
  counts.factor *= PositiveNumber(reader, "ballast factor");
  if (isOld)
  {
    counts.factor *= PositiveNumber(reader, "ballast-lamp photometric factor");
  }
  else
  {
    // For future use in 1995 and 2002, how the file came about in 2019.
    reader.NextNumber("number after the ballast factor", -LargestNumber, LargestNumber);
  }
  solid.inputPower = reader.NextNumber("input watts", 0.0, LargestNumber);
  return counts;
}

/// Type C: 0 alone; 0 to 90, 180 or 360; 90 to 270; or 0 to one step before 360.
std::vector<double> ReadHorizontalC(TextReader& reader, std::size_t count)
{
  constexpr const char* name = "horizontal angle";
  std::vector<double> angles;
  for (std::size_t i = 1; i <= count; ++i)
  {
    angles.push_back(reader.NextNumber({ name, i }, 0.0, 360.0));
    if (i == 1 && angles[0] != 0.0 && (angles[0] != 90.0 || count == 1))
    {
      reader.Refuse({ name, i }, "the first must be 0, or 90 where the last is 270");
    }
    RequireRising(reader, { name, i }, angles);
  }
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
  std::vector<double> angles;
  for (std::size_t i = 1; i <= count; ++i)
  {
    angles.push_back(reader.NextNumber({ name, i }, -largest, largest));
    if (angles[0] > 0.0)
    {
      reader.Refuse({ name, i }, "the first must be 0, where the lamp is symmetric, or below");
    }
    RequireRising(reader, { name, i }, angles);
  }
  return angles;
}

/// [horizontal][vertical].
std::vector<double> ReadIntensities(TextReader& reader, const Counts& counts)
{
  std::vector<double> candela; // grows with the file, not by its promise
  double largest = 0.0;
  for (std::size_t i = 1; i <= counts.horizontal * counts.vertical; ++i)
  {
    const NumberName name{ "candela value", i };
    candela.push_back(counts.factor * reader.NextNumber(name, 0.0, LargestNumber));
    if (candela.back() > LargestNumber)
    {
      reader.Refuse(name, "times the factors of the file it is too large");
    }
    largest = std::max(largest, candela.back());
  }
  reader.RequireEnd("candela value");
  if (largest == 0.0)
  {
    reader.Fail("all candela values are 0");
  }
  return candela;
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

} // namespace

PhotometricSolid ReadIes(std::istream& file, const std::string& folder)
{
  TextReader reader(file);
  const IesHeader header = ReadIesHeader(reader);
  PhotometricSolid solid;
  solid.description = header.description;
  const double tiltFactor = ReadIesTilt(reader, header.tilt, folder);
  Counts counts = ReadCounts(reader, header.isOld, solid);
  counts.factor *= tiltFactor;
  constexpr const char* vertical = "vertical angle";
  constexpr const char* horizontal = "horizontal angle";
  if (solid.type == Type::C)
  {
    auto polar = ReadIesAngles(reader, vertical, counts.vertical, 0.0, 180.0);
    auto azimuth = ReadHorizontalC(reader, counts.horizontal);
    solid.candela = ReadIntensities(reader, counts);
    SetTypeC(solid, std::move(polar), std::move(azimuth));
    return solid;
  }
  const bool isA = solid.type == Type::A;
  const auto v = ReadSymmetricAngles(reader, vertical, counts.vertical, isA ? 90.0 : 180.0);
  const auto h = ReadSymmetricAngles(reader, horizontal, counts.horizontal, isA ? 180.0 : 90.0);
  solid.candela = ReadIntensities(reader, counts);
  SetTypeAOrB(solid, v, h);
  return solid;
}

} // namespace PhotonTransport
