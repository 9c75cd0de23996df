// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/IesTilt.h"

#include "PhotonTransport/photometry/PhotometricFile.h"
#include "PhotonTransport/photometry/PhotometricNumbers.h"

#include <filesystem>
#include <fstream>

namespace PhotonTransport
{

namespace
{

namespace fs = std::filesystem;

/// The factor of a luminaire that is not tilted.
double ReadTiltFactors(TextReader& reader)
{
  reader.LenientNumber("lamp-to-luminaire geometry", 1.0, 3.0, 1.0);
  const std::size_t count = reader.NextCount("number of tilt angles", 1, MostAngles);
  const auto requireZero = [&](double angle)
  {
    if (angle != 0.0)
    {
      reader.Refuse(
        { "tilt angle", 1 }, "the first must be 0, the angle of a luminaire that is not tilted");
    }
  };
  ReadAngles(reader, "tilt angle", count, 0.0, 180.0, requireZero);
  double first = 0.0;
  for (std::size_t i = 1; i <= count; ++i)
  {
    const NumberName name{ "tilt factor", i };
    const double factor = reader.NextNumber(name, 0.0, LargestNumber);
    first = i == 1 ? reader.Positive(name, factor) : first;
  }
  return first;
}

/// The name in the folder, or else one that differs in capitals alone: file systems of other
/// computers take them for the same.
fs::path Find(const fs::path& folder, const std::string& name)
{
  std::error_code error;
  fs::path found = folder / name;
  if (fs::is_regular_file(found, error))
  {
    return found;
  }
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, error))
  {
    if (UpperCase(entry.path().filename().string()) == UpperCase(name))
    {
      return entry.path();
    }
  }
  return found;
}

} // namespace

double ReadIesTilt(TextReader& reader, const std::string& tilt, const std::string& folder)
{
  if (tilt == "NONE")
  {
    return 1.0;
  }
  if (tilt == "INCLUDE")
  {
    return ReadTiltFactors(reader);
  }
  // The name alone counts: folders are those of the maker's computer.
  const std::string name = tilt.substr(tilt.find_last_of("/\\") + 1);
  const fs::path path = Find(folder, name);
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  if (name.empty() || !file || !fs::is_regular_file(path, error))
  {
    reader.Fail("TILT is '" + Shortened(tilt, tilt.size()) +
      "'; it must be NONE, INCLUDE or a file in '" + folder + "'");
  }
  try
  {
    const PhotometricText text = ReadText(file);
    TextReader tiltReader(text, Commas::Separate);
    const double factor = ReadTiltFactors(tiltReader);
    tiltReader.EndAfter("tilt factor");
    for (const std::string& note : tiltReader.Notes())
    {
      reader.Note("in the TILT file, " + note);
    }
    return factor;
  }
  catch (const PhotometricFileError& inTilt)
  {
    reader.Fail("in the TILT file '" + Shortened(name, name.size()) + "', " + inTilt.what());
  }
}

} // namespace PhotonTransport
