// SPDX-License-Identifier: BSD-3-Clause
// Files that leave their standard as programs do: the same light, and a note where it was assumed.
#include "PhotometryVariants.h"

#include <gtest/gtest.h>

using namespace PhotonTransport;
using namespace PhotometryVariants;

namespace
{

class PhotometricVariants : public FileTest
{
protected:
  PhotometricVariants()
    : FileTest("files that leave their standard as programs do: refused, or read with other light")
  {
  }
};

constexpr double Rounding = 1e-9;

std::string AllNotes(const PhotometricSolid& solid)
{
  std::string all;
  for (const std::string& note : solid.notes)
  {
    all += note + "\n";
  }
  return all;
}

/// @param note Part of what is noted; empty: nothing is.
void ExpectFlux(Read read, const std::string& text, double factor, const std::string& note,
  const std::string& what)
{
  SCOPED_TRACE(what);
  try
  {
    const PhotometricSolid solid = read(text);
    ++FileTest::NumberRead;
    const double expected = ExpectedFlux(factor);
    EXPECT_NEAR(Flux(solid), expected, Rounding * expected);
    const std::string notes = AllNotes(solid);
    EXPECT_EQ(notes.empty(), note.empty()) << notes;
    EXPECT_NE(notes.find(note), std::string::npos) << notes;
  }
  catch (const PhotometricFileError& error)
  {
    ADD_FAILURE() << "refused: " << error.what();
  }
}

void ExpectRefused(Read read, const std::string& text, const std::string& message)
{
  try
  {
    const PhotometricSolid solid = read(text);
    ADD_FAILURE() << "read with " << Flux(solid) << " lm; expected: " << message;
  }
  catch (const PhotometricFileError& error)
  {
    ++FileTest::NumberRefused;
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

/// With one line replaced, from 1.
std::string With(std::vector<std::string> lines, std::size_t line, const std::string& by)
{
  lines[line - 1] = by;
  return Joined(lines);
}

} // namespace

TEST_F(PhotometricVariants, TheNumberAfterTheBallastFactorIsNoFactorSince1995)
{
  for (const char* header :
    { "IESNA:LM-63-2002", "IESNA: LM-63-2002", "IESNA LM-63-2002", "IESNA:LM-63-1995",
      "IESNA LM-63-1995", "IESNA95", "IESNA02", "IESNA:LM63-2002", "IESNA : LM-63 - 1995",
      "iesna:lm-63-2002", "  IESNA:LM-63-2002", "\tIESNA:LM-63-1995  ", "IES:LM-63-2019",
      "IES LM-63-2019", "IES:LM-63-19", "ANSI/IES LM-63-19", "ANSI/IES:LM-63-2019",
      "IESNA:LM-63-2010", "\n\nIESNA:LM-63-2002", "lamp\nIESNA:LM-63-2002" })
  {
    for (const char* number : { "1", "1.1", "0", "-1", "0.95", "1.00001", "1.10100" })
    {
      ExpectFlux(ReadIesText, Joined(Ies({ header }, number + std::string(" 20"))), 1.0, "",
        std::string(header) + ", " + number);
    }
  }
}

TEST_F(PhotometricVariants, TheNumberAfterTheBallastFactorIsAFactorUntil1991)
{
  for (const char* header : { "IESNA91", "IESNA86", "iesna91", " IESNA91 ", "IESNA:LM-63-1991",
         "IESNA LM-63-1986", "IESNA 1991", "\nIESNA91" })
  {
    ExpectFlux(ReadIesText, Joined(Ies({ header }, "1.1 20", "5000")), 1.1, "", header);
    ExpectFlux(ReadIesText, Joined(Ies({ header }, "0 20", "5000")), 1.0,
      "is 0, which can't be a ballast-lamp photometric factor", header);
  }
}

TEST_F(PhotometricVariants, WithoutAnEditionTheNumberIsAFactorAsFarAsItCanBeOne)
{
  for (const std::vector<std::string>& header :
    { std::vector<std::string>{}, std::vector<std::string>{ "IES 63 W downlight" },
      std::vector<std::string>{ "[OTHER] IESNA:LM-63-2002" } })
  {
    const auto expect = [&](
                          const char* numbers, const char* lumens, double factor, const char* note)
    {
      ExpectFlux(ReadIesText, Joined(Ies(header, numbers, lumens)), factor, note,
        (header.empty() ? "no header" : header[0]) + ", " + numbers);
    };
    expect("1 20", "5000", 1.0, "");
    expect("1.1 20", "5000", 1.1, "was used as the ballast-lamp photometric factor of 1986");
    expect("1.1 20", "-1", 1.0, "was not used, as absolute photometry needs no factor");
    expect("0 20", "5000", 1.0, "is 0, which can't be");
    expect("-1 20", "-1", 1.0, "is -1, which can't be");
  }
}

TEST_F(PhotometricVariants, AnLm63LineWithoutItsYearIsOneSince1995)
{
  for (const char* header :
    { "IESNA:LM-63", "LM-63-2x02", "IESNA:LM-63-", "IESNA:LM-63-19", "IES LM-63-1902" })
  {
    const bool isNamed = header[0] == 'I';
    ExpectFlux(ReadIesText, Joined(Ies({ header }, "1.1 20", "5000")), isNamed ? 1.0 : 1.1,
      isNamed ? "gives no year of an edition; it was not used" : "no line tells the edition",
      header);
  }
}

TEST_F(PhotometricVariants, TextOfAnyEncodingAndLineEnd)
{
  const auto ies = Ies({ "IESNA:LM-63-2002" });
  const auto eulumdat = Eulumdat();
  for (const auto& [read, lines] :
    { std::pair(Read(ReadIesText), ies), std::pair(Read(ReadEulumdatText), eulumdat) })
  {
    const std::string text = Joined(lines);
    const auto expect = [read = read](const std::string& variant, const char* what)
    { ExpectFlux(read, variant, 1.0, "", what); };
    expect(text, "LF");
    expect(Joined(lines, "\r\n"), "CR LF");
    expect(Joined(lines, "\r"), "CR");
    expect(Joined(lines, "\r\r\n"), "CR CR LF");
    std::string mixture;
    const char* ends[] = { "\n", "\r\n", "\r" };
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      mixture += lines[i] + ends[i % 3];
    }
    expect(mixture, "a mixture of line ends");
    expect(text.substr(0, text.size() - 1), "no last line end");
    expect(text + "\x1A", "Ctrl-Z");
    expect(text.substr(0, text.size() - 1) + "\x1A", "Ctrl-Z without a line end");
    expect(text + "\n\n  \r\n\t\n", "blank lines at the end");
    expect(text + std::string(512, '\0'), "NULs at the end");
    expect("\xEF\xBB\xBF" + text, "UTF-8 with a mark");
    expect(Utf16(text, true, true), "UTF-16 LE");
    expect(Utf16(Joined(lines, "\r\n"), false, true), "UTF-16 BE");
    ExpectFlux(read, Utf16(text, true, false), 1.0, "read as UTF-16, little", "no mark");
    ExpectFlux(read, Utf16(text, false, false), 1.0, "read as UTF-16, big", "no mark");
    expect(Joined(lines, "\xA0\n"), "no-break spaces in Latin-1");
    expect(Joined(lines, "\xC2\xA0\n"), "no-break spaces in UTF-8");
    expect(Joined(lines, "\xE2\x80\x89 \t\n"), "thin spaces and tabs");
    expect(Replaced(text, "own", "\xF6wn \x96"), "Latin-1");
    ExpectFlux(read,
      text +
        "\x1A"
        "1 2 3",
      1.0, "follows Ctrl-Z", "text after Ctrl-Z");
  }
  ExpectFlux(ReadIesText, Replaced(Joined(ies), " ", "\xA0"), 1.0, "", "no blanks but these");
  ExpectFlux(ReadIesText,
    Replaced(Joined(ies), "-1",
      "\xE2\x88\x92"
      "1"),
    1.0, "", "minus signs");
}

TEST_F(PhotometricVariants, ControlCharactersSpoilANumberAndDoNotCutIt)
{
  for (const char c : { '\0', '\x01', '\x7F' })
  {
    const std::string text =
      Replaced(Joined(Ies({ "IESNA:LM-63-2002" })), "900", std::string("9") + c + "0");
    ExpectRefused(ReadIesText, text, "line 9: candela value 1 is '9 0'; it must be a number");
  }
}

TEST_F(PhotometricVariants, IesLinesThatLightDoesNotDependOn)
{
  const auto lines = Ies({ "IESNA:LM-63-2002" });
  const auto expect = [&](std::size_t line, const std::string& by, const char* note)
  { ExpectFlux(ReadIesText, With(lines, line, by), 1.0, note, by); };
  for (const char* tilt : { "TILT = NONE", "tilt=none", " Tilt= None ",
         "TILT=NONE ; measured upright", "TILT: NONE", "TILT NONE", "TILT=\tNONE" })
  {
    expect(4, tilt, "");
  }
  expect(2, "[MORE]", "");
  expect(2, "[MORE] more\n[LUMINAIRE]\n[]\n[", "");
  expect(2, "a line that is no keyword\n\n", "");
  expect(9, "900 700 300 40\nEND", "'END' and what follows after the last candela value");
  expect(9, "900 700 300 40 ; the last one\n12", "';' and what follows");
  expect(5, "0 -1 1 4 1 1 2 0.1 0.1 0", "number of lamps is 0");
  expect(6, "1 1 -20", "input watts is -20");
  expect(6, "1 1", "the input watts are missing");
  expect(6, "1 1 58W", "line 6: input watts is '58W'; 58 W was taken");
  expect(6, "1 1 58 W", "line 6: input watts is '58 W'; 58 W was taken");
  expect(6, "1 1 2x58 W", "input watts is '2x58 W'; 116 W was taken");
  expect(6, "1, 1, 2 x 58 watts", "input watts is '2 x 58 watts'; 116 W was taken");
  expect(6, "1 1 58,5 W", "input watts is '58.5 W'; 58.5 W was taken");
  expect(6, "1 1 n/a", "input watts is 'n/a'; 0 was taken for unknown");
  expect(6, "1 1 about 58 W", "input watts is 'about 58 W'; 0 was taken");
  EXPECT_EQ(ReadIesText(With(lines, 6, "1 1 2x58 W")).inputPower, 116.0);
  EXPECT_EQ(ReadIesText(With(lines, 6, "1 1 n/a")).inputPower, 0.0);
  ExpectFlux(ReadIesText,
    Joined({ lines[0], lines[1], lines[2], lines[3], lines[4], "1 1 58 W " + lines[6], lines[7],
      lines[8] }),
    1.0, "input watts is '58 W'; 58 W was taken", "angles on the same line");
  expect(5, "1 -1 1,0 4 1 1 2 0,1 0,1 0", "commas between digits were read as decimal points");
  expect(5, "1,-1,1,4,1,1,2,0.1,0.1,0", "");
  expect(9, "900, 700, 300, 40,", "");
  expect(9, "900,0 700,0 300,0 40,0", "commas between digits");
  ExpectFlux(ReadIesText, Joined(Ies({ "IESNA:LM-63-2002" }, "1 20", "1000")), 1.0,
    "make 227.994 % of the lamps' flux, 1000 lm", "more light than the lamps have");
  ExpectFlux(ReadIesText, With(lines, 4, "tilt = include\n1\n2\n0 90\n0.5 1"), 0.5, "", "include");
  ExpectFlux(ReadIesText, With(lines, 4, "TILT=INCLUDE\n7\n2\n0 90\n0.5 1"), 0.5,
    "lamp-to-luminaire geometry is 7", "geometry");
  ExpectFlux(
    ReadIesText, With(lines, 4, "TILT=C:\\tilts\\TILT.TLT"), 0.5, "", "another's file name");
}

TEST_F(PhotometricVariants, IesLinesThatContradictEachOther)
{
  const auto lines = Ies({ "IESNA:LM-63-2002" });
  const auto expect = [&](std::size_t line, const std::string& by, const char* message)
  { ExpectRefused(ReadIesText, With(lines, line, by), message); };
  expect(5, "1 -1 1 3 1 1 2 0 0 0", "horizontal angle 1 is '90'; the first must be 0");
  expect(5, "1 -1 1 5 1 1 2 0 0 0", "line 8: vertical angle 5 is '0'; angles must rise");
  expect(5, "1 -1 1 4 1 1 3 0 0 0", "units type is '3'; it must be within [1, 2]");
  expect(5, "1 -2 1 4 1 1 2 0 0 0", "lumens per lamp is '-2'; it must be above 0, or -1");
  expect(9, "900 700 300 4 0", "what follows is '0'; no number must follow");
  expect(9, "900 700 -300 40", "candela value 3 is '-300'; it must be within");
  expect(9, "900 700 300 40 50\nEND", "what follows is '50'");
  expect(9, "900 700 300 END", "candela value 4 is 'END'; it must be a number");
  expect(9, "1,900.5 700 300 40", "what follows is '40'");
}

TEST_F(PhotometricVariants, EulumdatLampSetsInEitherOrder)
{
  const auto expect = [](const Sets& sets, double flux, const char* note)
  { ExpectFlux(ReadEulumdatText, Joined(Eulumdat(sets)), flux / 1000.0, note, sets[1]); };
  // Set after set.
  expect(
    { "1", "LED-A", "2000", "830", "80", "20", "2", "LED-B", "5000", "840", "90", "45" }, 2000, "");
  expect({ "1", "58", "5200", "4000", "85", "63", "2", "36", "6700", "3000", "82", "80" }, 5200,
    "set after set was chosen, by lm/W, colour and the number of lamps: the flux is 5200 lm, not "
    "85");
  expect({ "2", "36", "6700", "840", "1B", "72", "2", "58", "10400", "840", "1B", "110", "1", "70",
           "6600", "830", "1B", "85" },
    6700, "set after set was chosen");
  // Line after line.
  expect(
    { "1", "2", "LED-A", "LED-B", "2000", "5000", "830", "840", "80", "90", "20", "45" }, 2000, "");
  expect({ "1", "2", "58", "36", "5200", "6700", "4000", "3000", "85", "82", "63", "80" }, 5200,
    "line after line was chosen");
  expect({ "-1", "-1", "0", "0", "2100", "3300", "3000", "4000", "80", "80", "18", "29" }, 2100,
    "line after line was chosen");
  // The other sets are alternatives, whatever they hold.
  expect({ "1", "LED", "2000", "830", "80", "20", "1", "LED", "", "", "", "" }, 2000, "");
  expect({ "1", "LED", "50000", "830", "80", "20" }, 50000, "give 50000 lm for 20 W");
  ExpectRefused(ReadEulumdatText,
    Joined(Eulumdat({ "1", "A", "many", "1", "1", "1", "1", "B", "5000", "1", "1", "1" })),
    "line 29: flux of the lamps is 'many'; it must be a number");
}

TEST_F(PhotometricVariants, EulumdatLinesThatLightDoesNotDependOn)
{
  const auto lines = Eulumdat();
  const auto expect = [&](std::size_t line, const std::string& by, const char* note)
  { ExpectFlux(ReadEulumdatText, With(lines, line, by), 1.0, note, by); };
  expect(32, "2x58 W", "line 32: wattage is '2x58 W'; 116 W was taken");
  expect(32, "58 W", "58 W was taken");
  expect(32, "2 x 58,5", "117 W was taken");
  expect(32, "approx. 60", "0 was taken for unknown");
  expect(32, "-20", "0 was taken for unknown");
  expect(32, "", "");
  expect(32, "20,5", "");
  EXPECT_EQ(ReadEulumdatText(With(lines, 32, "2x58 W")).inputPower, 116.0);
  EXPECT_EQ(ReadEulumdatText(With(lines, 32, "20,5")).inputPower, 20.5);
  expect(27, "-1", "");
  expect(27, "two", "number of lamps is 'two', not a number");
  expect(16, "long", "line 16: length of the luminous area is 'long', not a number");
  for (const std::size_t blank :
    { 1, 2, 5, 7, 8, 9, 10, 11, 12, 13, 16, 18, 22, 25, 28, 30, 31, 33 })
  {
    expect(blank, "", "");
  }
  expect(2, "0", "");
  expect(2, "x", "");
  expect(24, "1,0", "");
  expect(23, "100", "make 227.994 % of the lamps' flux, 1000 lm; the file says 100 %");
  expect(51, "40\nEND", "'END' and what follows after the last intensity");
  expect(51, "40\n\x1A", "");
}

TEST_F(PhotometricVariants, EulumdatWithBlankLinesAndDirectRatiosAdded)
{
  const auto lines = Eulumdat();
  const auto expect = [](const std::vector<std::string>& variant, const char* note)
  { ExpectFlux(ReadEulumdatText, Joined(variant), 1.0, note, Joined(variant)); };
  const auto inserted = [&](std::size_t before, std::size_t count, const char* text)
  {
    std::vector<std::string> variant = lines;
    variant.insert(variant.begin() + static_cast<std::ptrdiff_t>(before) - 1, count, text);
    return variant;
  };
  const auto without = [&](std::size_t first, std::size_t last)
  {
    std::vector<std::string> variant = lines;
    variant.erase(variant.begin() + static_cast<std::ptrdiff_t>(first) - 1,
      variant.begin() + static_cast<std::ptrdiff_t>(last));
    return variant;
  };
  expect(inserted(1, 1, ""), "blank lines before the first text were left out");
  expect(inserted(1, 3, "  "), "blank lines before the first text were left out");
  ExpectFlux(ReadEulumdatText, Joined(lines, "\n\n"), 1.0, "after every line", "doubled lines");
  ExpectFlux(ReadEulumdatText, Joined(lines, "\n\r"), 1.0, "after every line", "LF CR");
  for (std::size_t line = 2; line <= 42; ++line)
  {
    expect(inserted(line, 1, ""), "blank lines were left out");
  }
  for (std::size_t line = 43; line <= lines.size(); ++line)
  {
    expect(inserted(line, 2, ""), ""); // numbers alone, which blanks separate
  }
  expect(without(33, 42), "0 lines come between the lamps and the C-angles instead of 10");
  expect(without(42, 42), "9 lines come between the lamps and the C-angles");
  ExpectRefused(
    ReadEulumdatText, Joined(without(32, 32)), "gamma angle 4 is '900'; it must be within");
  ExpectRefused(ReadEulumdatText, Joined(without(28, 28)), "gamma angle 4 is '900'");
  ExpectRefused(ReadEulumdatText, Joined(inserted(29, 1, "1")), "angles must rise");
}

TEST_F(PhotometricVariants, EulumdatPlanesListedOrGivenInOtherNumbers)
{
  // The intensities of each plane are those of the lamp times the plane's weight.
  const auto file = [](const char* symmetry, const char* planes, const std::vector<double>& listed,
                      const std::vector<double>& weights)
  {
    std::vector<std::string> lines = Eulumdat();
    lines[2] = symmetry;
    lines[3] = planes;
    lines[22] = "0"; // no light output ratio
    lines[28] = "400";
    lines.resize(42);
    for (const auto* list : { &listed, &Angles })
    {
      for (const double angle : *list)
      {
        lines.push_back(std::to_string(angle));
      }
    }
    for (const double weight : weights)
    {
      for (const double candela : Candela)
      {
        lines.push_back(std::to_string(candela * weight / 16.0));
      }
    }
    return Joined(lines);
  };
  const auto expect = [](const std::string& text, double mean, const char* note, const char* what)
  { ExpectFlux(ReadEulumdatText, text, 0.4 / 16.0 * mean, note, what); };
  const auto eighths = Steps(0, 315, 45);
  const double quarter = (2.0 * 1.0 + 4.0 * 2.0 + 2.0 * 4.0) / 8.0;
  expect(file("4", "8", eighths, { 1, 2, 4 }), quarter, "", "the standard");
  expect(
    file("4", "8", { 0, 45, 90 }, { 1, 2, 4 }), quarter, "only the C-angles that", "short list");
  expect(file("4", "3", { 0, 45, 90 }, { 1, 2, 4 }), quarter, "all 3 C-planes are there", "given");
  expect(file("4", "9", Steps(0, 360, 45), { 1, 2, 4 }), quarter, "count 360", "closed");
  expect(file("4", "8", eighths, { 1, 2, 4, 2, 1, 2, 4, 2 }), quarter, "all 8 C-planes", "all");
  expect(file("4", "8", eighths, { 1, 2, 3, 4, 5, 6, 7, 8 }), 4.5, "all 8 C-planes", "all, uneven");
  expect(file("0", "9", Steps(0, 360, 45), { 1, 2, 3, 4, 5, 6, 7, 8, 1 }), 4.5, "", "to 360");
  const double half = (1.0 + 2.0 * (2.0 + 3.0 + 4.0) + 5.0) / 8.0;
  expect(file("2", "8", eighths, { 1, 2, 3, 4, 5 }), half, "", "half");
  expect(
    file("2", "5", Steps(0, 180, 45), { 1, 2, 3, 4, 5 }), half, "all 5 C-planes", "half, given");
  expect(file("3", "8", eighths, { 1, 2, 3, 4, 5 }), half, "", "half about 0");
  expect(file("3", "5", Steps(90, 270, 45), { 1, 2, 3, 4, 5 }), half, "all 5", "half about 180");
  expect(file("1", "8", eighths, { 3 }), 3.0, "", "revolution");
  expect(file("1", "8", { 0 }, { 3 }), 3.0, "only the C-angles that", "revolution, one angle");
  expect(
    file("1", "8", eighths, { 1, 2, 3, 4, 5, 6, 7, 8 }), 4.5, "all 8 C-planes", "no revolution");
  ExpectRefused(ReadEulumdatText, file("4", "6", Steps(0, 300, 60), { 1, 2 }),
    "line 4: number of C-planes is '6'; symmetry 4 needs a multiple of 4");
  ExpectRefused(ReadEulumdatText, file("4", "8", eighths, { 1, 2 }),
    "the file ends where its intensity 9 should come");
  ExpectRefused(ReadEulumdatText, file("4", "8", eighths, { 1, 2, 3, 4 }), "no number must follow");
  ExpectRefused(ReadEulumdatText, file("0", "8", Steps(0, 157.5, 22.5), { 1, 2, 3, 4, 5, 6, 7, 8 }),
    "C-angle 8 is '157.500000'; the last must be one step before 360");
}
