// SPDX-License-Identifier: BSD-3-Clause
// A. W. Stockmar, "EULUMDAT - ein Leuchtendatenformat fuer den europaeischen Beleuchtungsplaner",
// Licht '90, pp. 641-644; numbers in comments are lines of that format.
#include "PhotonTransport/photometry/EulumdatGrid.h"
#include "PhotonTransport/photometry/EulumdatLamps.h"
#include "PhotonTransport/photometry/PhotometricFile.h"
#include "PhotonTransport/photometry/PhotometricNumbers.h"
#include "PhotonTransport/photometry/Readings.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace PhotonTransport
{

namespace
{

constexpr std::size_t DirectRatios = 10; ///< Lines between the lamps and the C-angles.

void Skip(TextReader& reader, std::size_t lines, const char* name)
{
  for (std::size_t i = 0; i < lines; ++i)
  {
    reader.TextLine(name);
  }
}

double ReadSize(TextReader& reader, const char* name)
{
  constexpr double metres = 1e-3;
  return metres * std::abs(reader.LenientNumberLine(name, -LargestNumber, LargestNumber));
}

void ReadOpening(TextReader& reader, PhotometricSolid& solid)
{
  Skip(reader, 3, "size of the luminaire"); // 13 to 15
  solid.length = ReadSize(reader, "length of the luminous area");
  const double width = ReadSize(reader, "width of the luminous area");
  solid.width = width == 0.0 ? solid.length : width; // 0: round
  for (int plane = 0; plane < 4; ++plane)
  {
    solid.height = std::max(solid.height, ReadSize(reader, "height of the luminous area"));
  }
}

/// The lines before the C-angles.
struct Head
{
  EulumdatGrid grid;
  double outputRatio = 0.0; ///< %, of the luminaire's to the lamps' flux.
  double factor = 1.0;      ///< cd for each unit of the file's intensities.
  bool isPlausible = false; ///< The lamps are where they should be.
};

/// To the end of the sets of lamps.
Head ReadHead(TextReader& reader, PhotometricSolid& solid)
{
  Head head;
  AddToList(solid.description, reader.TextLine("company"));
  Skip(reader, 1, "type indicator"); // 2
  head.grid = ReadEulumdatGrid(reader);
  Skip(reader, 1, "measurement report number");
  AddToList(solid.description, reader.TextLine("luminaire name"));
  AddToList(solid.description, reader.TextLine("luminaire number"));
  Skip(reader, 2, "file name and date");
  ReadOpening(reader, solid);
  Skip(reader, 1, "downward flux fraction"); // 22
  head.outputRatio = reader.LenientNumberLine("light output ratio", 0.0, LargestNumber);
  constexpr const char* conversion = "conversion factor for intensities";
  head.factor = reader.Positive(conversion, reader.NumberLine(conversion, 0.0, LargestNumber));
  Skip(reader, 1, "tilt during measurement"); // 25
  const EulumdatLamps lamps = ReadEulumdatLamps(reader);
  head.isPlausible = lamps.isPlausible;
  solid.inputPower = lamps.watts;
  solid.ratedFlux = lamps.isAbsolute ? 0.0 : lamps.flux;
  head.factor *= lamps.flux / 1000.0; // cd/klm
  return head;
}

/// @param reader After the lamps. @param ratios Lines to skip.
PhotometricSolid ReadRest(TextReader reader, PhotometricSolid solid, const Head& head,
  EulumdatPlanes planes, std::size_t ratios)
{
  Skip(reader, ratios, "direct ratio"); // 27
  if (ratios != DirectRatios)
  {
    reader.Note(std::to_string(ratios) +
      " lines come between the lamps and the C-angles instead "
      "of " +
      std::to_string(DirectRatios) + "; the light does not depend on them");
  }
  ReadEulumdatSolid(reader, head.grid, planes, head.factor, solid);
  if (ratios != DirectRatios && solid.polar.front() != 0.0 && solid.polar.front() != 90.0)
  {
    reader.Fail("the first gamma angle is " + NumberText(solid.polar.front()) + ", not 0 or 90");
  }
  solid.notes.insert(solid.notes.begin(), reader.Notes().begin(), reader.Notes().end());
  NoteOnOutputRatio(solid, head.outputRatio);
  return solid;
}

/// Numbers from the line on that comes after the direct ratios; 0 where the file ends before.
std::size_t NumbersAfter(TextReader reader, std::size_t ratios)
{
  std::string line;
  for (std::size_t i = 0; i < ratios; ++i)
  {
    if (!reader.NextLine(line))
    {
      return 0;
    }
  }
  return reader.NumbersAhead();
}

/// @param text Outlives the call. @param fewerRatios Also with fewer direct ratios, which is
/// believed only where the lines of the lamps make sense: others may be missing instead.
PhotometricSolid Read(const PhotometricText& text, bool fewerRatios)
{
  TextReader reader(text, Commas::AreDecimal);
  PhotometricSolid solid;
  const Head head = ReadHead(reader, solid);
  std::vector<Attempt> attempts;
  const auto attempt = [&](EulumdatPlanes planes, std::size_t ratios)
  {
    attempts.push_back([&reader, &solid, &head, planes, ratios]
      { return ReadRest(reader, solid, head, planes, ratios); });
  };
  attempt(EulumdatPlanes::Standard, DirectRatios);
  const std::size_t least = fewerRatios && head.isPlausible ? 0 : DirectRatios;
  for (std::size_t ratios = DirectRatios + 1; ratios-- > least;)
  {
    const std::size_t numbers = NumbersAfter(reader, ratios);
    for (const EulumdatPlanes planes : AllEulumdatPlanes)
    {
      if (numbers > 0 && numbers == NumbersOf(head.grid, planes))
      {
        attempt(planes, ratios);
      }
    }
  }
  return FirstThatReads(attempts);
}

template <typename Predicate>
PhotometricText Without(const PhotometricText& text, const char* what, Predicate isLeftOut)
{
  PhotometricText rest;
  rest.notes = text.notes;
  rest.notes.push_back(std::string(what) + " were left out");
  std::copy_if(text.lines.begin(), text.lines.end(), std::back_inserter(rest.lines),
    [&](const TextLine& line) { return !isLeftOut(line); });
  return rest;
}

bool IsBlank(const TextLine& line)
{
  return Trimmed(line.text).empty();
}

/// Without the blank lines that follow every line where a program has doubled line ends.
PhotometricText WithoutDoubledLines(const PhotometricText& text)
{
  const auto& lines = text.lines;
  const auto isAdded = [](const TextLine& line) { return line.number % 2 == 0; };
  const bool isDoubled = lines.size() > 1 &&
    std::all_of(lines.begin(), lines.end(),
      [&](const TextLine& line) { return !isAdded(line) || IsBlank(line); });
  return isDoubled ? Without(text, "blank lines after every line", isAdded) : text;
}

/// The text, and without blank lines that a program may have added. A blank line may also be a
/// field that is not filled in: which it is shows in what the file makes then.
std::vector<PhotometricText> Texts(const PhotometricText& text)
{
  std::vector<PhotometricText> texts{ text };
  const auto first = std::find_if_not(text.lines.begin(), text.lines.end(), IsBlank);
  if (first != text.lines.begin() && first != text.lines.end())
  {
    texts.push_back(Without(text, "blank lines before the first text",
      [&](const TextLine& line) { return line.number < first->number; }));
  }
  if (std::any_of(first, text.lines.end(), IsBlank))
  {
    texts.push_back(Without(text, "blank lines", IsBlank));
  }
  return texts;
}

} // namespace

PhotometricSolid ReadEulumdat(std::istream& file)
{
  // The format's reading comes first; another one counts only where that one fails and where all
  // numbers that the file announces are there, and no more.
  const std::vector<PhotometricText> texts = Texts(WithoutDoubledLines(ReadText(file)));
  std::vector<Attempt> attempts;
  for (const bool fewerRatios : { false, true })
  {
    for (const PhotometricText& text : texts)
    {
      attempts.push_back([&text, fewerRatios] { return Read(text, fewerRatios); });
    }
  }
  return FirstThatReads(attempts);
}

} // namespace PhotonTransport
