// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/PhotometricText.h"

#include <algorithm>
#include <iterator>

namespace PhotonTransport
{

namespace
{

constexpr char CtrlZ = '\x1A';

enum class Encoding
{
  Bytes, ///< UTF-8 or Latin-1, each line for itself.
  Utf16LittleEndian,
  Utf16BigEndian
};

/// Tabs and form feeds, no-break space, spaces of all widths, and the byte order mark, which is a
/// space without a width.
bool IsSpace(char32_t c)
{
  return c == ' ' || (c >= '\t' && c <= '\r') || c == 0xA0 || c == 0x1680 ||
    (c >= 0x2000 && c <= 0x200B) || c == 0x2028 || c == 0x2029 || c == 0x202F || c == 0x205F ||
    c == 0x3000 || c == 0xFEFF;
}

void AppendUtf8(std::string& text, char32_t c)
{
  constexpr char32_t minusSign = 0x2212;
  if (IsSpace(c))
  {
    text += ' ';
    return;
  }
  if (c < 0x80 || c == minusSign)
  {
    text += c == minusSign ? '-' : static_cast<char>(c);
    return;
  }
  const int following = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  const unsigned marks[] = { 0, 0xC0, 0xE0, 0xF0 };
  text += static_cast<char>(marks[following] | (c >> (6 * following)));
  for (int i = following; i-- > 0;)
  {
    text += static_cast<char>(0x80 | ((c >> (6 * i)) & 0x3F));
  }
}

/// The next character of UTF-8, which has no surrogates. @return False where the bytes at
/// `position` are none.
bool NextUtf8(std::string_view bytes, std::size_t& position, char32_t& c)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const char32_t first = byte(position++);
  if ((first >= 0x80 && first < 0xC2) || first >= 0xF5)
  {
    return false;
  }
  const int following = first < 0x80 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
  c = following == 0 ? first : first & (0x3Fu >> following);
  for (int i = 0; i < following; ++i)
  {
    if (position >= bytes.size() || (byte(position) & 0xC0) != 0x80)
    {
      return false;
    }
    c = (c << 6) | (byte(position++) & 0x3F);
  }
  return c < 0xD800 || (c > 0xDFFF && c <= 0x10FFFF);
}

std::string LineAsUtf8(std::string_view bytes)
{
  std::string text;
  char32_t c = 0;
  for (std::size_t i = 0; i < bytes.size(); AppendUtf8(text, c))
  {
    if (!NextUtf8(bytes, i, c))
    {
      text.clear();
      for (const char byte : bytes)
      {
        AppendUtf8(text, static_cast<unsigned char>(byte)); // Latin-1
      }
      break;
    }
  }
  return text;
}

Encoding EncodingOf(const std::string& bytes, std::vector<std::string>& notes)
{
  if (bytes.compare(0, 2, "\xFF\xFE") == 0)
  {
    return Encoding::Utf16LittleEndian;
  }
  if (bytes.compare(0, 2, "\xFE\xFF") == 0)
  {
    return Encoding::Utf16BigEndian;
  }
  std::size_t zeros[2] = { 0, 0 }; // at even and odd places
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
  }
  const bool isWide = bytes.size() >= 4 && bytes.size() % 2 == 0 &&
    std::min(zeros[0], zeros[1]) == 0 && 4 * std::max(zeros[0], zeros[1]) > bytes.size();
  if (!isWide)
  {
    return Encoding::Bytes;
  }
  const bool isLittle = zeros[1] > zeros[0];
  notes.push_back(std::string("the file has no byte order mark; as every second byte is 0 it was "
                              "read as UTF-16, ") +
    (isLittle ? "little" : "big") + " endian");
  return isLittle ? Encoding::Utf16LittleEndian : Encoding::Utf16BigEndian;
}

/// Lines keep their ends.
std::string Utf16AsUtf8(const std::string& bytes, bool isLittle)
{
  const auto unit = [&](std::size_t i) -> char32_t
  {
    const auto a = static_cast<unsigned char>(bytes[i]);
    const auto b = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(isLittle ? b << 8 | a : a << 8 | b);
  };
  constexpr char32_t unknown = 0xFFFD;
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
  {
    char32_t c = unit(i);
    if (c >= 0xD800 && c < 0xE000)
    {
      const char32_t low = c < 0xDC00 && i + 3 < bytes.size() ? unit(i + 2) : 0;
      const bool isPair = low >= 0xDC00 && low < 0xE000;
      c = isPair ? 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00) : unknown;
      i += isPair ? 2 : 0;
    }
    if (c == '\n' || c == '\r')
    {
      text += static_cast<char>(c);
    }
    else
    {
      AppendUtf8(text, c);
    }
  }
  return text;
}

/// CRs before an LF belong to it: programs that wrote text twice leave CR CR LF.
std::vector<TextLine> Lines(const std::string& bytes)
{
  std::vector<TextLine> lines;
  for (std::size_t begin = 0; begin < bytes.size();)
  {
    std::size_t end = std::min(bytes.find_first_of("\r\n", begin), bytes.size());
    lines.push_back(
      { LineAsUtf8(std::string_view(bytes).substr(begin, end - begin)), lines.size() + 1 });
    const std::size_t afterCrs = std::min(bytes.find_first_not_of('\r', end), bytes.size());
    begin = afterCrs < bytes.size() && bytes[afterCrs] == '\n' ? afterCrs + 1 : end + 1;
  }
  return lines;
}

} // namespace

PhotometricText ReadText(std::istream& file)
{
  PhotometricText text;
  std::string bytes{ std::istreambuf_iterator<char>(file), {} };
  const Encoding encoding = EncodingOf(bytes, text.notes);
  if (encoding != Encoding::Bytes)
  {
    bytes = Utf16AsUtf8(bytes, encoding == Encoding::Utf16LittleEndian);
  }
  bytes.erase(bytes.find_last_not_of('\0') + 1);
  const std::size_t end = bytes.find(CtrlZ);
  if (end != std::string::npos)
  {
    if (bytes.find_first_not_of(std::string(" \t\r\n") + CtrlZ, end) != std::string::npos)
    {
      text.notes.push_back("what follows Ctrl-Z, the end of a file from DOS, was not read");
    }
    bytes.erase(end);
  }
  text.lines = Lines(bytes);
  return text;
}

std::string_view Trimmed(std::string_view text)
{
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

std::string UpperCase(std::string_view text)
{
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
    [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return upper;
}

std::string Shortened(std::string_view text, std::size_t length)
{
  std::size_t end = std::min(length, text.size());
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
  {
    --end;
  }
  std::string beginning(text.substr(0, end));
  std::replace_if(
    beginning.begin(), beginning.end(),
    [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7F; }, ' ');
  return beginning + (end < text.size() ? "..." : "");
}

void AddToList(std::string& list, std::string_view part)
{
  const std::string text = Shortened(Trimmed(part), part.size());
  if (!text.empty())
  {
    list += (list.empty() ? "" : ", ") + text;
  }
}

} // namespace PhotonTransport
