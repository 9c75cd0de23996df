// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/IesHeader.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace PhotonTransport
{

namespace
{

bool TakeBeginning(std::string_view& text, std::string_view beginning)
{
  const bool found = text.substr(0, beginning.size()) == beginning;
  text.remove_prefix(found ? beginning.size() : 0);
  return found;
}

/// Letters and digits, in upper case: "IESNA: LM-63-2002" is "IESNALM632002".
std::string LettersAndDigits(const std::string& line)
{
  std::string text = UpperCase(line);
  text.erase(std::remove_if(text.begin(), text.end(),
               [](char c) { return !((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')); }),
    text.end());
  return text;
}

/// @param digits As in 1995, 95 and 02. @return 0 if they are no year that an edition may have.
int Year(std::string_view digits)
{
  constexpr int first = 1986;
  double number = 0.0;
  if ((digits.size() != 2 && digits.size() != 4) || !ParseNumber(digits, number))
  {
    return 0;
  }
  const int century = digits.size() == 4 ? 0 : number >= first % 100 ? 1900 : 2000;
  const int year = century + static_cast<int>(number);
  return year >= first && year < first + 100 ? year : 0;
}

bool IsYearOfAnEdition(int year)
{
  const int years[] = { 1986, 1991, 1995, 2002, 2019 };
  return std::find(std::begin(years), std::end(years), year) != std::end(years);
}

/// Of a line such as "IESNA:LM-63-2002", "IES LM-63-2019" or "IESNA91", whatever stands between
/// letters and digits; nothing for other lines.
std::optional<IesEdition> EditionOf(const std::string& line)
{
  if (line.empty() || line[0] == '[')
  {
    return std::nullopt;
  }
  const std::string normalised = LettersAndDigits(line);
  std::string_view text = normalised;
  TakeBeginning(text, "ANSI");
  const bool isIesna = TakeBeginning(text, "IESNA");
  const bool isIes = isIesna || TakeBeginning(text, "IES");
  const bool isLm63 = TakeBeginning(text, "LM63");
  if (!isIes && !isLm63)
  {
    return std::nullopt;
  }
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  // 2019 is the IES's edition; after IESNA, 19 is the beginning of another year.
  const bool isCut = isIesna && text.substr(0, end) == "19";
  const int year = isCut ? 0 : Year(text.substr(0, end));
  // Names of luminaires begin with such letters too.
  const bool isEdition = IsYearOfAnEdition(year);
  if (!(isIes && isLm63) && !isEdition)
  {
    return std::nullopt;
  }
  if (year == 0 || (end == 2 && !isEdition))
  {
    return IesEdition::WithoutYear;
  }
  return year < 1995 ? IesEdition::FactorAfterwards : IesEdition::Since1995;
}

/// TILT=something, with blanks anywhere; TILT: NONE and TILT NONE too. @return False for others.
bool ReadTiltLine(const std::string& line, std::string& tilt)
{
  constexpr std::string_view word = "TILT";
  std::string_view text = line;
  if (UpperCase(text.substr(0, word.size())) != word)
  {
    return false;
  }
  text = Trimmed(text.substr(word.size()));
  const bool hasEquals = !text.empty() && text[0] == '=';
  text = Trimmed(text.substr(hasEquals || (!text.empty() && text[0] == ':') ? 1 : 0));
  // NONE and INCLUDE may be followed by a comment; a name may have blanks in it.
  const std::string first = UpperCase(text.substr(0, std::min(text.find(' '), text.size())));
  const bool isKnown = first == "NONE" || first == "INCLUDE";
  tilt = isKnown ? first : std::string(text);
  return hasEquals || isKnown;
}

/// [KEYWORD] text.
void ReadKeywordLine(
  std::string_view line, std::string& maker, std::string& name, std::string& number)
{
  const std::size_t end = line.find(']');
  if (line.empty() || line[0] != '[' || end == std::string_view::npos)
  {
    return;
  }
  const std::string keyword = UpperCase(Trimmed(line.substr(1, end - 1)));
  std::string* value = keyword == "MANUFAC" ? &maker
    : keyword == "LUMINAIRE"                ? &name
    : keyword == "LUMCAT"                   ? &number
                                            : nullptr;
  if (value)
  {
    *value = line.substr(end + 1);
  }
}

} // namespace

IesHeader ReadIesHeader(TextReader& reader)
{
  IesHeader header;
  std::string labels; // the lines of 1986, which has no keywords
  std::string maker, name, number;
  bool hasFormatLine = false;
  for (std::string line; reader.NextLine(line);)
  {
    if (ReadTiltLine(line, header.tilt))
    {
      for (const std::string& part : { maker, name, number })
      {
        AddToList(header.description, part);
      }
      if (header.description.empty() && !hasFormatLine)
      {
        header.description = labels;
      }
      return header;
    }
    const std::optional<IesEdition> edition = hasFormatLine ? std::nullopt : EditionOf(line);
    if (edition)
    {
      hasFormatLine = true;
      header.edition = *edition;
      continue;
    }
    ReadKeywordLine(line, maker, name, number);
    AddToList(labels, line);
  }
  reader.Fail("the file ends without a line TILT=; it is no IES file");
}

} // namespace PhotonTransport
