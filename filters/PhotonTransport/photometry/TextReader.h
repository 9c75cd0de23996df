// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

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

/// Reads a photometric file by lines or by numbers. Everything wrong becomes a PhotometricFileError
/// with the line that was read last.
class TextReader
{
public:
  explicit TextReader(std::istream& file)
    : File(file)
  {
  }

  std::size_t LineNumber() const { return this->Number; }

  /// The next line without its end; numbers come from later ones. @return False at the end of the
  /// file.
  bool NextLine(std::string& line);

  /// The next line, which must be there, without blanks at either end.
  std::string TextLine(const char* name);

  /// A number that has the next line for itself, with a decimal point or comma.
  double NumberLine(const NumberName& name, double smallest, double largest);
  /// 0 for an empty line: for numbers that matter little, which some files leave out.
  double NumberLineOr0(const NumberName& name, double smallest, double largest);
  std::size_t CountLine(const NumberName& name, std::size_t smallest, std::size_t largest);

  /// The next number, on this line or a later one, after blanks or commas.
  double NextNumber(const NumberName& name, double smallest, double largest);
  std::size_t NextCount(const NumberName& name, std::size_t smallest, std::size_t largest);

  /// Throws if anything but blanks follows.
  void RequireEnd(const char* lastName);

  /// "<name> is '<text that was read last>'; <wanted>".
  [[noreturn]] void Refuse(const NumberName& name, const std::string& wanted) const;
  [[noreturn]] void Fail(const std::string& message) const;

private:
  bool FetchLine();
  bool FindToken();
  void ReadTokenLine(const NumberName& name);
  double Parse(const NumberName& name, double smallest, double largest) const;
  std::size_t AsCount(const NumberName& name, double value) const;

  std::istream& File;
  std::size_t Number = 0;
  std::string Line;
  std::size_t Position = 0; ///< In Line, after the token.
  std::string_view Token;
};

/// Without blanks and control characters at either end.
std::string_view Trimmed(std::string_view text);

/// Trimmed, without control characters, in UTF-8: other bytes are taken for Latin-1.
std::string OneLine(std::string_view text);

/// Adds a part that is not empty to a list that commas separate.
void AddToList(std::string& list, std::string_view part);

} // namespace PhotonTransport
