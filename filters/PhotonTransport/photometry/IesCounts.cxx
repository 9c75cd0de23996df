// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/IesCounts.h"

#include "PhotonTransport/photometry/PhotometricNumbers.h"

#include <cmath>

namespace PhotonTransport
{

namespace
{

using Type = PhotometricSolid::Type;

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

void ReadLamps(TextReader& reader, PhotometricSolid& solid)
{
  const double lamps = reader.LenientNumber("number of lamps", 1.0, 1e6, 1.0);
  const double lumens = reader.NextNumber("lumens per lamp", -LargestNumber, LargestNumber);
  if (!(lumens > 0.0 || lumens == -1.0))
  {
    reader.Refuse("lumens per lamp", "it must be above 0, or -1 for absolute photometry");
  }
  solid.ratedFlux = lumens > 0.0 ? lamps * lumens : 0.0;
}

/// The number after the ballast factor, which is a factor until 1991 only. Where no line says the
/// edition it is one as in 1986, as far as it can be one; photometry of a whole luminaire has none.
double ReadThirdFactor(TextReader& reader, IesEdition edition, bool isAbsolute)
{
  const double value =
    reader.NextNumber("number after the ballast factor", -LargestNumber, LargestNumber);
  if (value == 1.0 || edition == IesEdition::Since1995)
  {
    return 1.0;
  }
  const std::string text = "the number after the ballast factor is " + NumberText(value);
  if (value <= 0.0)
  {
    reader.Note(text + ", which can't be a ballast-lamp photometric factor; it was not used");
    return 1.0;
  }
  if (edition == IesEdition::FactorAfterwards)
  {
    return value;
  }
  if (edition == IesEdition::WithoutYear)
  {
    reader.Note(text +
      " and the line that names LM-63 gives no year of an edition; it was not "
      "used, as files name LM-63 since 1995, when it was no factor any more");
    return 1.0;
  }
  reader.Note(text + " and no line tells the edition of LM-63; " +
    (isAbsolute ? "it was not used, as absolute photometry needs no factor"
                : "it was used as the ballast-lamp photometric factor of 1986; write "
                  "IESNA:LM-63-2002 into the first line if it is none"));
  return isAbsolute ? 1.0 : value;
}

/// A number, or text on the line of the ballast factor, such as 58 W or n/a.
double ReadInputWatts(TextReader& reader)
{
  constexpr const char* name = "input watts";
  TextReader afterWords = reader;
  TextReader afterLine = reader;
  const std::string words = afterWords.WordsOfLine();
  const std::string line = afterLine.RestOfLine();
  double number = 0.0;
  if (words.empty() || ParseNumber(words, number))
  {
    return reader.LenientNumber(name, 0.0, LargestNumber, 0.0);
  }
  const bool wholeLine = WattsOf(line) || words[0] < '0' || words[0] > '9';
  reader = wholeLine ? afterLine : afterWords; // the angles may follow on the line
  return LenientWatts(reader, name, wholeLine ? line : words);
}

} // namespace

IesCounts ReadIesCounts(
  TextReader& reader, IesEdition edition, const IesReading& reading, PhotometricSolid& solid)
{
  IesCounts counts;
  ReadLamps(reader, solid);
  const auto positive = [&](const char* name)
  { return reader.Positive(name, reader.NextNumber(name, -LargestNumber, LargestNumber)); };
  counts.factor = positive("candela multiplier");
  counts.vertical = reader.NextCount("number of vertical angles", 2, MostAngles);
  counts.horizontal = reader.NextCount("number of horizontal angles", 1, MostAngles);
  RequireManageable(reader, counts.vertical, counts.horizontal);
  const Type types[] = { Type::C, Type::B, Type::A };
  solid.type = types[reader.NextCount("photometric type", 1, 3) - 1];
  if (solid.type != Type::C && counts.horizontal < 2)
  {
    reader.Fail("there is 1 horizontal angle; types A and B need 2 or more");
  }
  ReadOpening(reader, solid);
  counts.factor *= positive("ballast factor");
  counts.factor *= ReadThirdFactor(reader, edition, solid.ratedFlux == 0.0);
  if (reading.hasWatts)
  {
    solid.inputPower = ReadInputWatts(reader);
  }
  else if (reader.LineIsRead())
  {
    reader.Note("the input watts are missing; the light does not depend on them");
  }
  else
  {
    reader.Fail("the line goes on after the number after the ballast factor");
  }
  return counts;
}

} // namespace PhotonTransport
