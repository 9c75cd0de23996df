// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace PhotonTransport
{

struct TextLine
{
  std::string text;       ///< UTF-8, without its end.
  std::size_t number = 0; ///< In the file, from 1.
};

/// The text of a file, in whichever encoding it was stored.
struct PhotometricText
{
  std::vector<TextLine> lines;
  std::vector<std::string> notes; ///< What was assumed of the file.
};

/// Reads UTF-8, UTF-16 and Latin-1. UTF-16 has a byte order mark or a 0 in more than half of all
/// second bytes. A line that is not UTF-8 is taken for Latin-1. Lines end with LF, CR LF or CR, in
/// any mixture; the file ends at Ctrl-Z, if there is one. Tabs and spaces of any width become
/// blanks. Other control characters stay, so that they make a number invalid and do not cut it in
/// two. NULs at the end of the file are dropped.
PhotometricText ReadText(std::istream& file);

/// Without blanks at either end.
std::string_view Trimmed(std::string_view text);

/// Letters a to z in upper case.
std::string UpperCase(std::string_view text);

/// For messages: the first bytes, at most `length`, and "..." if there are more. No character is
/// cut through, and control characters become blanks.
std::string Shortened(std::string_view text, std::size_t length);

/// Adds a part that is not empty to a list that commas separate.
void AddToList(std::string& list, std::string_view part);

} // namespace PhotonTransport
