// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/TextReader.h"

#include "PhotonTransport/photometry/PhotometricFile.h"

#include <cmath>

namespace PhotonTransport
{

namespace
{

bool IsSeparator(char c)
{
  return c == ' ' || c == ',';
}

std::string Text(const NumberName& name)
{
  return name.Index == 0 ? name.Name : name.Name + (" " + std::to_string(name.Index));
}

std::string Range(double smallest, double largest)
{
  return "within [" + NumberText(smallest) + ", " + NumberText(largest) + "]";
}

std::string Quoted(std::string_view text)
{
  constexpr std::size_t longest = 40;
  return "'" + Shortened(text, longest) + "'";
}

} // namespace

TextReader::TextReader(const PhotometricText& text, Commas commas)
  : Source(&text)
  , Comma(commas)
  , AllNotes(text.notes)
{
}

std::size_t TextReader::LineNumber() const
{
  return this->Fetched == 0 ? 1 : this->Source->lines[this->Fetched - 1].number;
}

void TextReader::Note(const std::string& note)
{
  this->AllNotes.push_back("line " + std::to_string(this->LineNumber()) + ": " + note);
}

bool TextReader::FetchLine()
{
  this->Position = this->TokenBegin = this->TokenEnd = 0;
  this->Line.clear();
  if (this->Fetched == this->Source->lines.size())
  {
    return false;
  }
  this->Line = this->Source->lines[this->Fetched++].text;
  if (this->Comma == Commas::AreDecimal)
  {
    MakeCommasPoints(this->Line);
  }
  return true;
}

bool TextReader::NextLine(std::string& line)
{
  const bool found = this->FetchLine();
  line = found ? Trimmed(this->Source->lines[this->Fetched - 1].text) : std::string_view();
  this->Position = this->Line.size();
  return found;
}

std::string TextReader::TextLine(const char* name)
{
  std::string line;
  if (!this->NextLine(line))
  {
    this->FailAtEnd(name);
  }
  return line;
}

void TextReader::ReadTokenLine(const NumberName& name)
{
  if (!this->FetchLine())
  {
    this->FailAtEnd(name);
  }
  const std::string_view token = Trimmed(this->Line);
  this->TokenBegin = static_cast<std::size_t>(token.data() - this->Line.data());
  this->TokenEnd = this->TokenBegin + token.size();
  this->Position = this->Line.size();
}

double TextReader::NumberLine(const NumberName& name, double smallest, double largest)
{
  this->ReadTokenLine(name);
  return this->Parse(name, smallest, largest);
}

double TextReader::LenientNumberLine(const char* name, double smallest, double largest)
{
  this->ReadTokenLine(name);
  const std::string_view token = this->Token();
  double value = 0.0;
  if (!token.empty() && !(ParseNumber(token, value) && value >= smallest && value <= largest))
  {
    this->Note(std::string(name) + " is " + Quoted(token) + ", not a number " +
      Range(smallest, largest) + "; 0 was taken, and the light does not depend on it");
    return 0.0;
  }
  return value;
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
    this->FailAtEnd(name);
  }
  return this->Parse(name, smallest, largest);
}

double TextReader::LenientNumber(
  const char* name, double smallest, double largest, double otherwise)
{
  const double value = this->NextNumber(name, -LargestNumber, LargestNumber);
  if (value >= smallest && value <= largest)
  {
    return value;
  }
  this->Note(std::string(name) + " is " + NumberText(value) + ", not " + Range(smallest, largest) +
    "; " + NumberText(otherwise) + " was taken, and the light does not depend on it");
  return otherwise;
}

std::size_t TextReader::NextCount(const NumberName& name, std::size_t smallest, std::size_t largest)
{
  return this->AsCount(
    name, this->NextNumber(name, static_cast<double>(smallest), static_cast<double>(largest)));
}

std::size_t TextReader::NumbersAhead() const
{
  TextReader ahead = *this;
  std::size_t numbers = 0;
  for (double value; ahead.FindToken() && ParseNumber(ahead.Token(), value);)
  {
    ++numbers;
  }
  return numbers;
}

std::string TextReader::RestOfLine()
{
  const std::size_t begin = this->FindTokenOnLine() ? this->TokenBegin : this->Line.size();
  this->Position = this->Line.size();
  return std::string(Trimmed(std::string_view(this->Line).substr(begin)));
}

std::string TextReader::WordsOfLine()
{
  if (!this->FindTokenOnLine())
  {
    return "";
  }
  const std::size_t begin = this->TokenBegin;
  std::size_t end = this->TokenEnd;
  for (double number; this->FindTokenOnLine() && !ParseNumber(this->Token(), number);)
  {
    end = this->TokenEnd;
  }
  this->Position = end;
  return this->Line.substr(begin, end - begin);
}

bool TextReader::LineIsRead() const
{
  return Trimmed(std::string_view(this->Line).substr(this->Position)).empty();
}

double TextReader::Positive(const NumberName& name, double value) const
{
  if (!(value > 0.0))
  {
    this->Refuse(name, "it must be above 0");
  }
  return value;
}

void TextReader::EndAfter(const char* lastName)
{
  if (!this->FindToken())
  {
    return;
  }
  double value = 0.0;
  if (ParseNumber(this->Token(), value))
  {
    this->Refuse("what follows",
      std::string("no number must follow the last ") + lastName +
        " that the counts announce; the counts or the numbers are wrong");
  }
  this->Note(
    Quoted(this->Token()) + " and what follows after the last " + lastName + " was not read");
}

void TextReader::Refuse(const NumberName& name, const std::string& wanted) const
{
  this->Fail(Text(name) + " is " + Quoted(this->Token()) + "; " + wanted);
}

void TextReader::Fail(const std::string& message) const
{
  throw PhotometricFileError(this->LineNumber(), message);
}

void TextReader::FailAtEnd(const NumberName& name) const
{
  this->Fail(
    "the file ends where its " + Text(name) + " should come; numbers are missing before or here");
}

bool TextReader::FindTokenOnLine()
{
  while (this->Position < this->Line.size() && IsSeparator(this->Line[this->Position]))
  {
    ++this->Position;
  }
  this->TokenBegin = this->Position;
  while (this->Position < this->Line.size() && !IsSeparator(this->Line[this->Position]))
  {
    ++this->Position;
  }
  this->TokenEnd = this->Position;
  return this->TokenEnd > this->TokenBegin;
}

bool TextReader::FindToken()
{
  while (!this->FindTokenOnLine())
  {
    if (!this->FetchLine())
    {
      return false;
    }
  }
  return true;
}

double TextReader::Parse(const NumberName& name, double smallest, double largest) const
{
  double value = 0.0;
  if (!ParseNumber(this->Token(), value))
  {
    this->Refuse(name, "it must be a number");
  }
  if (value < smallest || value > largest)
  {
    this->Refuse(name, "it must be " + Range(smallest, largest));
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

} // namespace PhotonTransport
