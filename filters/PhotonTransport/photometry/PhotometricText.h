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

/// The text of a file, however a program has stored it.
struct PhotometricText
{
  std::vector<TextLine> lines;
  std::vector<std::string> notes; ///< What was assumed of the file.
};

/// Reads UTF-8, UTF-16 (with a byte order mark, or without one where every second byte is 0) and,
/// line by line, Latin-1, which is what bytes that are not UTF-8 are taken for. Lines end with LF,
/// CR LF or CR, in any mixture, the file with Ctrl-Z at the latest. Tabs and spaces of any width
/// become blanks; other control characters stay, so that they spoil a number and do not cut it in
/// two. NULs at the end of the file are dropped.
PhotometricText ReadText(std::istream& file);

/// Without blanks at either end.
std::string_view Trimmed(std::string_view text);

/// Letters a to z in upper case.
std::string UpperCase(std::string_view text);

/// For messages: the first bytes, at most `length`, without a cut through a character, and "..."
/// for the rest; blanks for control characters.
std::string Shortened(std::string_view text, std::size_t length);

/// Adds a part that is not empty to a list that commas separate.
void AddToList(std::string& list, std::string_view part);

} // namespace PhotonTransport
