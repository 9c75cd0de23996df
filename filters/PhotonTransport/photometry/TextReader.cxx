// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/TextReader.h"

#include "PhotonTransport/photometry/PhotometricFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace PhotonTransport
{

namespace
{

/// Blanks and all control characters: Ctrl-Z ends files from DOS.
bool IsBlank(char c)
{
  return static_cast<unsigned char>(c) <= ' ';
}

bool IsSeparator(char c)
{
  return IsBlank(c) || c == ',';
}

std::string Text(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

std::string Text(const NumberName& name)
{
  return name.Index == 0 ? name.Name : name.Name + (" " + std::to_string(name.Index));
}

bool IsUtf8(std::string_view text)
{
  for (std::size_t i = 0; i < text.size();)
  {
    const auto c = static_cast<unsigned char>(text[i++]);
    if ((c >= 0x80 && c < 0xC2) || c >= 0xF5)
    {
      return false;
    }
    for (int following = c < 0x80 ? 0 : c < 0xE0 ? 1 : c < 0xF0 ? 2 : 3; following > 0; --following)
    {
      if (i >= text.size() || (static_cast<unsigned char>(text[i++]) & 0xC0) != 0x80)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

bool TextReader::FetchLine()
{
  this->Token = {};
  this->Position = 0;
  this->Line.clear();
  if (!std::getline(this->File, this->Line))
  {
    this->Line.clear();
    return false;
  }
  if (++this->Number == 1 && this->Line.compare(0, 3, "\xEF\xBB\xBF") == 0)
  {
    this->Line.erase(0, 3); // a byte order mark
  }
  if (!this->Line.empty() && this->Line.back() == '\r')
  {
    this->Line.pop_back();
  }
  return true;
}

bool TextReader::NextLine(std::string& line)
{
  const bool found = this->FetchLine();
  line = this->Line;
  this->Position = this->Line.size();
  return found;
}

std::string TextReader::TextLine(const char* name)
{
  std::string line;
  if (!this->NextLine(line))
  {
    this->Fail(std::string("the file ends where its ") + name + " should come");
  }
  return std::string(Trimmed(line));
}

void TextReader::ReadTokenLine(const NumberName& name)
{
  if (!this->FetchLine())
  {
    this->Fail("the file ends where its " + Text(name) + " should come");
  }
  const std::size_t comma = this->Line.find(',');
  if (comma != std::string::npos)
  {
    this->Line[comma] = '.';
  }
  this->Token = Trimmed(this->Line);
  this->Position = this->Line.size();
}

double TextReader::NumberLine(const NumberName& name, double smallest, double largest)
{
  this->ReadTokenLine(name);
  return this->Parse(name, smallest, largest);
}

double TextReader::NumberLineOr0(const NumberName& name, double smallest, double largest)
{
  this->ReadTokenLine(name);
  return this->Token.empty() ? 0.0 : this->Parse(name, smallest, largest);
}

std::size_t TextReader::CountLine(const NumberName& name, std::size_t smallest, std::size_t largest)
{
  return this->AsCount(
    name, this->NumberLine(name, static_cast<double>(smallest), static_cast<double>(largest)));
}

double TextReader::NextNumber(const NumberName& name, double smallest, double largest)
{
  if (!this->FindToken())
  {
    this->Fail("the file ends where its " + Text(name) + " should come");
  }
  return this->Parse(name, smallest, largest);
}

std::size_t TextReader::NextCount(const NumberName& name, std::size_t smallest, std::size_t largest)
{
  return this->AsCount(
    name, this->NextNumber(name, static_cast<double>(smallest), static_cast<double>(largest)));
}

void TextReader::RequireEnd(const char* lastName)
{
  if (this->FindToken())
  {
    this->Refuse(NumberName("what follows"),
      std::string("nothing must follow the last ") + lastName + " that the counts announce");
  }
}

void TextReader::Refuse(const NumberName& name, const std::string& wanted) const
{
  constexpr std::size_t longest = 40;
  std::string token = OneLine(this->Token.substr(0, longest));
  this->Fail(
    Text(name) + " is '" + token + (this->Token.size() > longest ? "...'; " : "'; ") + wanted);
}

void TextReader::Fail(const std::string& message) const
{
  throw PhotometricFileError(std::max<std::size_t>(this->Number, 1), message);
}

bool TextReader::FindToken()
{
  const auto skip = [this]
  {
    while (this->Position < this->Line.size() && IsSeparator(this->Line[this->Position]))
    {
      ++this->Position;
    }
    return this->Position < this->Line.size();
  };
  while (!skip())
  {
    if (!this->FetchLine())
    {
      return false;
    }
  }
  const std::size_t begin = this->Position;
  while (this->Position < this->Line.size() && !IsSeparator(this->Line[this->Position]))
  {
    ++this->Position;
  }
  this->Token = std::string_view(this->Line).substr(begin, this->Position - begin);
  return true;
}

double TextReader::Parse(const NumberName& name, double smallest, double largest) const
{
  std::string_view digits = this->Token;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
  {
    digits.remove_prefix(1); // from_chars takes no plus
  }
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (digits.empty() || error != std::errc() || stop != end || !std::isfinite(value))
  {
    this->Refuse(name, "it must be a number");
  }
  if (value < smallest || value > largest)
  {
    this->Refuse(name, "it must be within [" + Text(smallest) + ", " + Text(largest) + "]");
  }
  return value;
}

std::size_t TextReader::AsCount(const NumberName& name, double value) const
{
  if (value != std::floor(value))
  {
    this->Refuse(name, "it must be a whole number");
  }
  return static_cast<std::size_t>(value);
}

std::string_view Trimmed(std::string_view text)
{
  while (!text.empty() && IsBlank(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && IsBlank(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

std::string OneLine(std::string_view text)
{
  text = Trimmed(text);
  const bool isUtf8 = IsUtf8(text);
  std::string line;
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && !isUtf8)
    {
      line += static_cast<char>(0xC0 | (byte >> 6));
      line += static_cast<char>(0x80 | (byte & 0x3F));
    }
    else
    {
      line += IsBlank(c) || byte == 0x7F ? ' ' : c;
    }
  }
  return line;
}

void AddToList(std::string& list, std::string_view part)
{
  const std::string text = OneLine(part);
  if (!text.empty())
  {
    list += (list.empty() ? "" : ", ") + text;
  }
}

} // namespace PhotonTransport
