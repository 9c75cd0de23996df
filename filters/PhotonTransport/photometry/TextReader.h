// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/NumberText.h"
#include "PhotonTransport/photometry/PhotometricText.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace PhotonTransport
{

/// What a number of a file is, for messages: a name, and its number where there are many of that
/// name (from 1; 0: there is only one).
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

/// The meaning of a comma that stands before a digit and behind a digit, a minus or the blanks at
/// the beginning of a line. Any other comma separates numbers as a blank does.
enum class Commas
{
  Separate,
  AreDecimal
};

/// Reads a photometric file by lines or by numbers. What is wrong becomes a PhotometricFileError
/// with the number of the line that was read last. Values that the light does not depend on are
/// read leniently: a value that makes no sense gives a note.
class TextReader
{
public:
  /// The text must outlive the reader. A copy goes on from the same place.
  TextReader(const PhotometricText& text, Commas commas);

  std::size_t LineNumber() const;
  /// The notes of the text and then those of the reader.
  const std::vector<std::string>& Notes() const { return this->AllNotes; }
  /// Adds a note with the number of the line that was read last.
  void Note(const std::string& note);

  /// The next line, without blanks at either end; numbers come from later ones. @return False at
  /// the end of the file.
  bool NextLine(std::string& line);
  /// The next line, which must be there.
  std::string TextLine(const char* name);

  /// The number that fills the next line.
  double NumberLine(const NumberName& name, double smallest, double largest);
  /// The same for a value that the light does not depend on: 0 for an empty line; 0 and a note for
  /// a line that is no number or out of range.
  double LenientNumberLine(const char* name, double smallest, double largest);
  std::size_t CountLine(const NumberName& name, std::size_t smallest, std::size_t largest);

  /// The next number, on this line or a later one, after blanks or commas.
  double NextNumber(const NumberName& name, double smallest, double largest);
  /// The same for a value that the light does not depend on: `otherwise` and a note for a number
  /// that is out of range. Text that is no number is refused.
  double LenientNumber(const char* name, double smallest, double largest, double otherwise);
  std::size_t NextCount(const NumberName& name, std::size_t smallest, std::size_t largest);
  /// How many numbers follow before the end of the file or the first text that is no number.
  std::size_t NumbersAhead() const;
  /// Takes the words that follow on the line that was read last.
  std::string RestOfLine();
  /// Takes the first of them, which may be a number, and those after it up to a number.
  std::string WordsOfLine();
  /// Whether only blanks follow on the line that was read last.
  bool LineIsRead() const;

  /// The value, which must be the one read last; refuses it unless it is above 0.
  double Positive(const NumberName& name, double value) const;

  /// To be called after the last number that the counts announce: refuses a number that follows,
  /// and notes text that follows.
  void EndAfter(const char* lastName);

  /// "<name> is '<text that was read last>'; <wanted>".
  [[noreturn]] void Refuse(const NumberName& name, const std::string& wanted) const;
  [[noreturn]] void Fail(const std::string& message) const;
  [[noreturn]] void FailAtEnd(const NumberName& name) const;

private:
  bool FetchLine();
  bool FindToken();
  bool FindTokenOnLine();
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

} // namespace PhotonTransport
