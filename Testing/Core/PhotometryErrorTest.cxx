// SPDX-License-Identifier: BSD-3-Clause
// Photometric files that are broken: one error with the line, and never anything else.
#include "PhotometryTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <fstream>
#include <random>

using namespace PhotonTransport;

namespace
{

const std::vector<std::string> GoodIes = { "IESNA:LM-63-2002", "[TEST] none", "TILT=NONE",
  "1 1000 1 3 2 1 2 0.1 0.1 0.1", "1 1 10", "0 45 90", "0 90", "10 20", "30", "1 2 3" };

std::vector<std::string> Lines(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

std::string Joined(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + "\n";
  }
  return text;
}

using Reader = PhotometricSolid (*)(const std::string& text);

void ExpectError(Reader read, const std::string& text, std::size_t line, const std::string& message)
{
  try
  {
    read(text);
    ADD_FAILURE() << "no error, expected: " << message;
  }
  catch (const PhotometricFileError& error)
  {
    EXPECT_EQ(error.Line, line) << error.what();
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos)
      << "'" << error.what() << "', expected '" << message << "'";
  }
}

/// A line of a good file replaced.
void ExpectError(Reader read, std::vector<std::string> good, std::size_t replaced,
  const std::string& by, const std::string& message, std::size_t line = 0)
{
  good[replaced - 1] = by;
  ExpectError(read, Joined(good), line == 0 ? replaced : line, message);
}

bool Rises(const std::vector<double>& list)
{
  return std::is_sorted(list.begin(), list.end()) &&
    std::adjacent_find(list.begin(), list.end()) == list.end();
}

/// All that PhotometricSolid.h promises.
void ExpectValid(const PhotometricSolid& solid)
{
  EXPECT_TRUE(Rises(solid.polar) && Rises(solid.azimuth));
  ASSERT_TRUE(solid.polar.size() >= 2 && solid.azimuth.size() >= 2);
  EXPECT_TRUE(solid.polar.front() >= 0.0 && solid.polar.back() <= 180.0);
  EXPECT_LE(solid.azimuth.back() - solid.azimuth.front(), 360.0);
  ASSERT_EQ(solid.candela.size(), solid.polar.size() * solid.azimuth.size());
  EXPECT_TRUE(std::all_of(solid.candela.begin(), solid.candela.end(),
    [](double candela) { return candela >= 0.0 && std::isfinite(candela); }));
  for (const double value : { Flux(solid), solid.ratedFlux, solid.inputPower, solid.width,
         solid.length, solid.height, Intensity(solid, 50.0, 70.0) })
  {
    EXPECT_TRUE(value >= 0.0 && std::isfinite(value));
  }
}

/// Bytes changed, lost, doubled, moved; the rest cut off.
std::string Mutated(std::string text, std::mt19937& random)
{
  const auto number = [&](std::size_t below)
  { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  const std::string likely = "0123456789.,-+e \n\r\t=[]";
  for (std::size_t i = number(4) + 1; i > 0 && !text.empty(); --i)
  {
    const std::size_t at = number(text.size());
    const std::size_t length = number(std::min<std::size_t>(text.size() - at, 20)) + 1;
    switch (number(6))
    {
      case 0:
        text[at] = static_cast<char>(number(256));
        break;
      case 1:
        text[at] = likely[number(likely.size())];
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(number(text.size()), length));
        break;
      case 4:
        text.insert(at, 1, likely[number(likely.size())]);
        break;
      default:
        text.resize(at);
    }
  }
  return text;
}

std::string Contents(const std::string& name)
{
  std::ifstream file(DataFile(name), std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_GT(text.str().size(), 0u) << name;
  return text.str();
}

} // namespace

TEST(PhotometricFileError, NamesLineAndValueOfAnIesHeader)
{
  EXPECT_NO_THROW(ReadIesText(Joined(GoodIes)));
  const auto expect = [](std::size_t line, const std::string& by, const std::string& message)
  { ExpectError(ReadIesText, GoodIes, line, by, message); };
  expect(4, "many", "line 4: number of lamps is 'many'; it must be a number");
  expect(4, "1 0", "lumens per lamp is '0'; it must be above 0, or -1");
  expect(4, "1 nan", "lumens per lamp is 'nan'; it must be a number");
  expect(4, "1 1e400", "lumens per lamp is '1e400'; it must be a number");
  expect(4, "1 1000x", "lumens per lamp is '1000x'; it must be a number");
  expect(4, "1 1000 -1", "candela multiplier is '-1'; it must be above 0");
  expect(4, "1 1000 1 1", "number of vertical angles is '1'; it must be within [2, 10000]");
  expect(4, "1 1000 1 3 100000", "number of horizontal angles is '100000'; it must be within");
  expect(4, "1 1000 1 10000 10000", "10000 x 10000 angles; there must be at most 10000000");
  expect(4, "1 1000 1 3 2 4", "photometric type is '4'; it must be within [1, 3]");
  expect(4, "1 1000 1 3 1 2", "1 horizontal angle; types A and B need 2 or more");
  expect(4, "1 1000 1 3 2 1 3", "units type is '3'; it must be within [1, 2]");
  expect(4, "1 1000 1 3 2 1 2 inf", "width is 'inf'; it must be a number");
  expect(5, "0 1 10", "ballast factor is '0'; it must be above 0");
}

TEST(PhotometricFileError, NamesLineAndValueOfIesAnglesAndIntensities)
{
  const auto expect =
    [](std::size_t line, const std::string& by, const std::string& message, std::size_t said = 0)
  { ExpectError(ReadIesText, GoodIes, line, by, message, said); };
  expect(6, "0 90 45", "vertical angle 3 is '45'; angles must rise");
  expect(6, "0 45 181", "vertical angle 3 is '181'; it must be within [0, 180]");
  expect(7, "10 90", "horizontal angle 1 is '10'; the first must be 0");
  expect(7, "0 0", "horizontal angle 2 is '0'; angles must rise");
  expect(7, "0 100", "horizontal angle 2 is '100'; the last must be 90, 180, 360 or one step");
  expect(7, "90 180", "horizontal angle 2 is '180'; the last must be 270");
  expect(8, "10 -20", "candela value 2 is '-20'; it must be within [0, 1e+30]");
  expect(9, "", "the file ends where its candela value 6 should come", 10);
  expect(10, "1 2 3 4", "what follows is '4'; no number must follow the last candela value");
  std::vector<std::string> dark = GoodIes;
  dark[7] = dark[8] = dark[9] = "0 0";
  ExpectError(
    ReadIesText, Joined(dark), 10, "every candela value is 0; a lamp must shine somewhere");
  std::vector<std::string> bright = GoodIes;
  bright[3] = "1 1000 1e20 3 2 1 2 0 0 0";
  bright[8] = "1e20";
  ExpectError(ReadIesText, Joined(bright), 9, "candela value 3 is '1e20'; times the factors");
  std::vector<std::string> typeA = GoodIes;
  typeA[3] = "1 1000 1 3 2 3 2 0 0 0";
  ExpectError(ReadIesText, typeA, 6, "10 45 90", "vertical angle 1 is '10'; the first must be 0");
  ExpectError(ReadIesText, typeA, 6, "0 45 91", "vertical angle 3 is '91'; it must be within");
}

TEST(PhotometricFileError, NamesLineAndValueOfTilt)
{
  const auto expect = [](std::size_t line, const std::string& tilt, const std::string& message)
  { ExpectError(ReadIesText, GoodIes, 3, tilt, message, line); };
  expect(10, "[MORE] no tilt", "the file ends without a line TILT=");
  expect(3, "TILT=absent.tlt", "TILT is 'absent.tlt'; it must be NONE, INCLUDE or a file in");
  expect(3, "TILT=", "TILT is ''; it must be NONE");
  expect(3, "TILT=isotropic.ies", "in the TILT file 'isotropic.ies', line 1: lamp-to-luminaire");
  expect(4, "TILT=INCLUDE\none\n2\n0 90\n1 1", "lamp-to-luminaire geometry is 'one'");
  expect(6, "TILT=INCLUDE\n1\n3\n0 90 45\n1 1", "tilt angle 3 is '45'; angles must rise");
  expect(6, "TILT=INCLUDE\n1\n2\n10 90\n1 1", "tilt angle 1 is '10'; the first must be 0");
  expect(7, "TILT=INCLUDE\n1\n2\n0 90\n1 -1", "tilt factor 2 is '-1'; it must be within");
  expect(7, "TILT=INCLUDE\n1\n2\n0 90\n0 1", "tilt factor 1 is '0'; it must be above 0");
  ExpectError(ReadIesText, "", 1, "the file ends without a line TILT=");
}

TEST(PhotometricFileError, NamesLineAndValueOfEulumdat)
{
  const std::vector<std::string> good = Lines(EulumdatText(
    2, Steps(0, 270, 90), { 0, 90, 180 }, [](double g, double c) { return 1.0 + g + c; }));
  EXPECT_NO_THROW(ReadEulumdatText(Joined(good)));
  const auto expect =
    [&](std::size_t line, const std::string& by, const std::string& message, std::size_t said = 0)
  { ExpectError(ReadEulumdatText, good, line, by, message, said); };
  expect(3, "5", "symmetry indicator is '5'; it must be within [0, 4]");
  expect(4, "3", "number of C-planes is '3'; symmetry 2 needs a multiple of 2");
  expect(4, "", "number of C-planes is ''; it must be a number");
  expect(6, "1", "number of angles in each C-plane is '1'; it must be within [2, 10000]");
  expect(24, "0", "conversion factor for intensities is '0'; it must be above 0");
  expect(26, "0", "number of sets of lamps is '0'; it must be within");
  expect(29, "0", "flux of the lamps is '0'; it must be above 0");
  expect(43, "10", "C-angle 1 of 4 is 10, not 0, as symmetry 2 wants", 46);
  expect(44, "190", "C-angle 3 is '180'; angles must rise", 45);
  expect(45, "170", "C-angle 3 of 4 is 170, not 180, as symmetry 2 wants", 46);
  std::vector<std::string> gap = good;
  gap[2] = "0";
  ExpectError(ReadEulumdatText, gap, 46, "181", "C-angle 4 is '181'; the last must be one step");
  expect(48, "180", "gamma angle 3 is '180'; angles must rise", 49);
  expect(50, "1 2", "what follows is '361'; no number must follow the last intensity", 58);
  expect(50, "1x", "intensity 1 is '1x'; it must be a number");
  expect(58, "-9", "intensity 9 is '-9'; it must be within [0, 1e+30]");
  expect(58, "9\n10", "what follows is '10'; no number must follow the last intensity", 59);
  for (std::size_t lines = 0; lines < good.size(); ++lines)
  {
    ExpectError(ReadEulumdatText, Joined({ good.begin(), good.begin() + long(lines) }),
      std::max<std::size_t>(lines, 1), "the file ends where its ");
  }
}

TEST(PhotometricFileError, NamesTheFile)
{
  const auto message = [](const std::string& path)
  {
    try
    {
      ReadPhotometricFile(path);
    }
    catch (const std::runtime_error& error)
    {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message("lamp.txt"),
    "'lamp.txt' has none of the extensions .ies, .ldt and .eul of photometric files");
  EXPECT_EQ(message("absent/lamp.IES"), "can't open the photometric file 'absent/lamp.IES'");
}

TEST(PhotometricFile, IsReadTheSameInAnyLocale)
{
  const double flux = Flux(ReadPhotometricFile(DataFile("asymmetric_c.ies")));
  for (const char* name : { "de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8" })
  {
    if (std::setlocale(LC_ALL, name)) // as far as the machine has any
    {
      EXPECT_EQ(Flux(ReadPhotometricFile(DataFile("asymmetric_c.ies"))), flux);
    }
  }
  std::setlocale(LC_ALL, "C");
}

TEST(PhotometricFile, GivesAValidSolidOrTheErrorForAnyBytes)
{
  std::mt19937 random(4);
  int read = 0;
  int refused = 0;
  for (const char* name :
    { "asymmetric_c.ies", "asymmetric_b.ies", "isotropic.ies", "lambertian.ies",
      "tilt_included.ies", "tilt_file.ies", "spots.ies", "isotropic.ldt", "lateral.ldt" })
  {
    const std::string good = Contents(name);
    const bool isIes = std::string(name).find(".ies") != std::string::npos;
    for (int i = 0; i < 1000; ++i)
    {
      const std::string text = Mutated(good, random);
      SCOPED_TRACE(std::string(name) + " " + std::to_string(i));
      try
      {
        ExpectValid(isIes ? ReadIesText(text) : ReadEulumdatText(text));
        ++read;
      }
      catch (const PhotometricFileError& error)
      {
        const auto lines = 1 +
          std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; });
        EXPECT_TRUE(error.Line >= 1 && error.Line <= static_cast<std::size_t>(lines));
        ++refused;
      }
    }
  }
  EXPECT_GT(read, 1000); // both happen often enough to be a test
  EXPECT_GT(refused, 1000);
}
