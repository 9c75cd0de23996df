// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/PhotometricText.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace PhotonTransport
{

/// What a number of a file is, for messages: a name, and which of many it is (from 1; 0: the one).
struct NumberName
{
  NumberName(const char* name, std::size_t index = 0)
    : Name(name)
    , Index(index)
  {
  }
  const char* Name;
  std::size_t Index;
};

/// Far beyond any lamp, and any sum of such numbers is finite.
constexpr double LargestNumber = 1e30;

/// What a comma between digits is; another comma separates numbers as a blank does.
enum class Commas
{
  Separate,
  AreDecimal
};

/// Reads a photometric file by lines or by numbers. Everything wrong becomes a PhotometricFileError
/// with the line that was read last. What the light does not depend on is read leniently: it gives
/// a note where it makes no sense.
class TextReader
{
public:
  /// The text must outlive the reader. A copy goes on from the same place.
  TextReader(const PhotometricText& text, Commas commas);

  std::size_t LineNumber() const;
  /// Those of the text first.
  const std::vector<std::string>& Notes() const { return this->AllNotes; }
  /// With the number of the line that was read last.
  void Note(const std::string& note);

  /// The next line, without blanks at either end; numbers come from later ones. @return False at
  /// the end of the file.
  bool NextLine(std::string& line);
  /// The next line, which must be there.
  std::string TextLine(const char* name);

  /// A number that has the next line for itself.
  double NumberLine(const NumberName& name, double smallest, double largest);
  /// For what light does not depend on: 0 for an empty line, 0 and a note for one that is no
  /// number or out of range.
  double LenientNumberLine(const char* name, double smallest, double largest);
  std::size_t CountLine(const NumberName& name, std::size_t smallest, std::size_t largest);

  /// The next number, on this line or a later one, after blanks or commas.
  double NextNumber(const NumberName& name, double smallest, double largest);
  /// For what light does not depend on: `otherwise` and a note for a number out of range.
  double LenientNumber(const char* name, double smallest, double largest, double otherwise);
  std::size_t NextCount(const NumberName& name, std::size_t smallest, std::size_t largest);
  /// How many numbers follow before the end or the first text that is none.
  std::size_t NumbersAhead() const;
  /// Whether only blanks follow on the line that was read last.
  bool LineIsRead() const;

  /// The value, refused as the one read last unless it is above 0.
  double Positive(const NumberName& name, double value) const;

  /// Notes text that follows and refuses numbers, which the counts do not announce.
  void EndAfter(const char* lastName);

  /// "<name> is '<text that was read last>'; <wanted>".
  [[noreturn]] void Refuse(const NumberName& name, const std::string& wanted) const;
  [[noreturn]] void Fail(const std::string& message) const;
  [[noreturn]] void FailAtEnd(const NumberName& name) const;

private:
  bool FetchLine();
  bool FindToken();
  std::string_view Token() const
  {
    return std::string_view(this->Line).substr(this->TokenBegin, this->TokenEnd - this->TokenBegin);
  }
  void ReadTokenLine(const NumberName& name);
  double Parse(const NumberName& name, double smallest, double largest) const;
  std::size_t AsCount(const NumberName& name, double value) const;

  const PhotometricText* Source;
  Commas Comma;
  std::vector<std::string> AllNotes;
  std::size_t Fetched = 0; ///< Lines.
  std::string Line;
  std::size_t Position = 0; ///< In Line, after the token.
  std::size_t TokenBegin = 0;
  std::size_t TokenEnd = 0;
};

/// A number as photometric files have them. @return False for anything else.
bool ParseNumber(std::string_view text, double& value);

/// As short as it is exact to six digits.
std::string NumberText(double value);

} // namespace PhotonTransport
