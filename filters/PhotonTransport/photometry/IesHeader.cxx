// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/IesHeader.h"

#include "PhotonTransport/photometry/PhotometricFile.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace PhotonTransport
{

namespace
{

std::string UpperCase(std::string_view text)
{
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
    [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return upper;
}

bool BeginsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

bool IsFormatLine(const std::string& line)
{
  const std::string upper = UpperCase(line);
  return BeginsWith(upper, "IESNA91") || BeginsWith(upper, "IESNA86") ||
    BeginsWith(upper, "IESNA:LM-63-") || BeginsWith(upper, "IES:LM-63-");
}

bool IsOldFormat(const std::string& line)
{
  const std::string upper = UpperCase(Trimmed(line));
  const std::string year = upper.substr(upper.size() < 2 ? 0 : upper.size() - 2);
  return year == "86" || year == "91";
}

/// TILT=something, with blanks anywhere. @return False for other lines.
bool ReadTiltLine(const std::string& line, std::string& tilt)
{
  const std::string_view text = Trimmed(line);
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || UpperCase(Trimmed(text.substr(0, equals))) != "TILT")
  {
    return false;
  }
  tilt = Trimmed(text.substr(equals + 1));
  return true;
}

/// [KEYWORD] text.
void ReadKeywordLine(
  const std::string& line, std::string& maker, std::string& name, std::string& number)
{
  const std::string_view text = Trimmed(line);
  const std::size_t end = text.find(']');
  if (text.empty() || text[0] != '[' || end == std::string_view::npos)
  {
    return;
  }
  const std::string keyword = UpperCase(Trimmed(text.substr(1, end - 1)));
  std::string* value = keyword == "MANUFAC" ? &maker
    : keyword == "LUMINAIRE"                ? &name
    : keyword == "LUMCAT"                   ? &number
                                            : nullptr;
  if (value)
  {
    *value = text.substr(end + 1);
  }
}

/// The factor of a luminaire that is not tilted.
double ReadTiltFactors(TextReader& reader)
{
  reader.NextCount("lamp-to-luminaire geometry", 1, 3);
  const std::size_t count = reader.NextCount("number of tilt angles", 1, MostAngles);
  const std::vector<double> angles = ReadIesAngles(reader, "tilt angle", count, 0.0, 180.0);
  if (angles.front() != 0.0)
  {
    reader.Fail("the first tilt angle is not 0");
  }
  double first = 0.0;
  for (std::size_t i = 1; i <= count; ++i)
  {
    const NumberName name{ "tilt factor", i };
    const double factor = reader.NextNumber(name, 0.0, LargestNumber);
    first = i == 1 ? factor : first;
    if (first == 0.0)
    {
      reader.Refuse(name, "it must be above 0");
    }
  }
  return first;
}

} // namespace

IesHeader ReadIesHeader(TextReader& reader)
{
  IesHeader header;
  std::string labels; // the lines of 1986, which has no keywords
  std::string maker, name, number;
  bool has1986 = true;
  for (std::string line; reader.NextLine(line);)
  {
    if (reader.LineNumber() == 1 && IsFormatLine(line))
    {
      has1986 = false;
      header.isOld = IsOldFormat(line);
    }
    else if (ReadTiltLine(line, header.tilt))
    {
      AddToList(header.description, maker);
      AddToList(header.description, name);
      AddToList(header.description, number);
      if (header.description.empty() && has1986)
      {
        header.description = labels;
      }
      return header;
    }
    else
    {
      ReadKeywordLine(line, maker, name, number);
      AddToList(labels, line);
    }
  }
  reader.Fail("the file ends without a line TILT=; it is no IES file");
}

void RequireRising(
  const TextReader& reader, const NumberName& name, const std::vector<double>& angles)
{
  if (angles.size() > 1 && !(angles.back() > angles[angles.size() - 2]))
  {
    reader.Refuse(name, "angles must rise");
  }
}

std::vector<double> ReadIesAngles(
  TextReader& reader, const char* name, std::size_t count, double smallest, double largest)
{
  std::vector<double> angles;
  for (std::size_t i = 1; i <= count; ++i)
  {
    angles.push_back(reader.NextNumber({ name, i }, smallest, largest));
    RequireRising(reader, { name, i }, angles);
  }
  return angles;
}

double ReadIesTilt(TextReader& reader, const std::string& tilt, const std::string& folder)
{
  const std::string kind = UpperCase(tilt);
  if (kind == "NONE")
  {
    return 1.0;
  }
  if (kind == "INCLUDE")
  {
    return ReadTiltFactors(reader);
  }
  // The name alone counts: folders are those of the maker's computer.
  const std::string name = tilt.substr(tilt.find_last_of("/\\") + 1);
  std::ifstream file(std::filesystem::path(folder) / name, std::ios::binary);
  if (name.empty() || !file)
  {
    reader.Fail(
      "TILT is '" + OneLine(tilt) + "'; it must be NONE, INCLUDE or a file in '" + folder + "'");
  }
  try
  {
    TextReader tiltReader(file);
    const double factor = ReadTiltFactors(tiltReader);
    tiltReader.RequireEnd("tilt factor");
    return factor;
  }
  catch (const PhotometricFileError& error)
  {
    reader.Fail("in the TILT file '" + OneLine(name) + "', " + error.what());
  }
}

} // namespace PhotonTransport
