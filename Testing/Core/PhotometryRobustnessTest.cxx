// SPDX-License-Identifier: BSD-3-Clause
// Files that are cut, spoiled or written anew by another program: the same light, or it is told.
#include "PhotometryVariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace PhotonTransport;
using namespace PhotometryVariants;

namespace
{

class PhotometricRobustness : public FileTest
{
protected:
  PhotometricRobustness()
    : FileTest("cut and spoiled files: a crash, or other light without a word")
  {
  }
};

struct Base
{
  Read read;
  std::string text;
};

std::vector<Base> Bases()
{
  std::vector<Base> bases;
  for (const char* header : { "IESNA:LM-63-2002", "IESNA95", "IES:LM-63-2019" })
  {
    bases.push_back({ ReadIesText, Joined(Ies({ header }, "1.1 20")) });
  }
  for (const char* header : { "IESNA91", "IESNA:LM-63-1991" })
  {
    bases.push_back({ ReadIesText, Joined(Ies({ header }, "0.9 20", "5000")) });
  }
  bases.push_back({ ReadIesText, Joined(Ies({}, "0.9 20", "5000"), "\r\n") });
  for (const int type : { 1, 2, 3 })
  {
    bases.push_back({ ReadIesText,
      IesText(type, Steps(0, 90, 10), Steps(0, 90, 15),
        [](double v, double h) { return std::floor(1000.0 + 3.0 * v + h); }) });
  }
  bases.push_back({ ReadEulumdatText, Joined(Eulumdat()) });
  for (const Sets& sets :
    { Sets{ "1", "58", "5200", "4000", "85", "63", "2", "36", "6700", "3000", "82", "80" },
      Sets{ "1", "2", "LED-A", "LED-B", "2000", "5000", "830", "840", "80", "90", "20", "45" } })
  {
    bases.push_back({ ReadEulumdatText, Joined(Eulumdat(sets), "\r\n") });
  }
  for (const int symmetry : { 0, 2, 3, 4 })
  {
    bases.push_back({ ReadEulumdatText,
      EulumdatText(symmetry, Steps(0, 345, 15), Steps(0, 180, 20),
        [](double g, double c) { return std::floor(20.0 + g / 10.0 + c / 100.0); }) });
  }
  return bases;
}

class Random
{
public:
  std::size_t Below(std::size_t count)
  {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(this->Numbers);
  }
  template <typename List>
  auto OneOf(const List& list)
  {
    return list[this->Below(list.size())];
  }

private:
  std::mt19937 Numbers{ 7 };
};

constexpr double Tolerance = 2e-4;

bool HasNewNote(const PhotometricSolid& solid, const PhotometricSolid& good)
{
  return std::any_of(solid.notes.begin(), solid.notes.end(),
    [&](const std::string& note)
    { return std::find(good.notes.begin(), good.notes.end(), note) == good.notes.end(); });
}

/// @param change Of a text.
template <typename Change>
void ExpectSameOrTold(int cases, Change change)
{
  Random random;
  int read = 0;
  int refused = 0;
  for (const Base& base : Bases())
  {
    const PhotometricSolid good = base.read(base.text);
    const double flux = Flux(good);
    for (int i = 0; i < cases; ++i)
    {
      const std::string text = change(base.text, random);
      try
      {
        const PhotometricSolid solid = base.read(text);
        const bool isSame = std::abs(Flux(solid) - flux) <= Tolerance * flux;
        EXPECT_TRUE(isSame || HasNewNote(solid, good))
          << Flux(solid) << " lm, not " << flux << ":\n"
          << text;
        ++read;
      }
      catch (const PhotometricFileError& error)
      {
        EXPECT_FALSE(std::string(error.what()).empty());
        ++refused;
      }
    }
  }
  EXPECT_GT(read, 0); // both happen, or it were no test
  EXPECT_GT(refused, cases);
  FileTest::NumberRead += read;
  FileTest::NumberRefused += refused;
}

/// The place of the last number: a number that is cut is a number.
std::size_t LastNumber(const std::string& text)
{
  const std::size_t last = text.find_last_not_of(" \r\n");
  return text.find_last_of(" \r\n", last) + 1;
}

} // namespace

TEST_F(PhotometricRobustness, CutFiles)
{
  ExpectSameOrTold(300,
    [](const std::string& text, Random& random)
    {
      std::size_t length = random.Below(text.size() + 1);
      const std::size_t last = LastNumber(text);
      const bool isWithinLast = length > last && length <= text.find_last_not_of(" \r\n");
      return text.substr(0, isWithinLast ? last : length);
    });
}

TEST_F(PhotometricRobustness, SpoiledBytes)
{
  // Bytes of which numbers are made could make another number, which nobody can tell.
  const std::string bytes("xXnN@#?:;[]=\x01\x7F\xFF\xC3\0", 18);
  ExpectSameOrTold(1000,
    [&](std::string text, Random& random)
    {
      for (std::size_t i = random.Below(2) + 1; i-- > 0;)
      {
        text[random.Below(text.size())] = random.OneOf(bytes);
      }
      return text;
    });
}

TEST_F(PhotometricRobustness, InsertedBlanks)
{
  const std::vector<std::string> blanks{ " ", "  ", "\t", "\xA0", "\xC2\xA0", "\xE3\x80\x80", "\n",
    "\n\n", "\r", "\r\n", "\f" };
  ExpectSameOrTold(1000,
    [&](std::string text, Random& random)
    { return text.insert(random.Below(text.size() + 1), random.OneOf(blanks)); });
}

TEST_F(PhotometricRobustness, LostLineEnds)
{
  ExpectSameOrTold(300,
    [](std::string text, Random& random)
    {
      const std::size_t end = text.find_first_of("\r\n", random.Below(text.size()));
      return end == std::string::npos ? text : text.erase(end, text[end] == '\r' ? 2 : 1);
    });
}

TEST_F(PhotometricRobustness, LineEndsOfEveryKindLeaveTheLight)
{
  const std::vector<std::string> ends{ "\n", "\r\n", "\r\r\n" };
  Random random;
  for (const Base& base : Bases())
  {
    const double flux = Flux(base.read(base.text));
    for (int i = 0; i < 20; ++i)
    {
      std::string text;
      const bool isMixed = i % 2 == 0;
      const std::string& one = random.OneOf(ends);
      for (const char c : base.text)
      {
        text += c == '\r' ? "" : c != '\n' ? std::string(1, c) : isMixed ? random.OneOf(ends) : one;
      }
      EXPECT_NEAR(Flux(base.read(text)), flux, Tolerance * flux) << text;
      ++FileTest::NumberRead;
    }
    EXPECT_NEAR(
      Flux(base.read(Replaced(Replaced(base.text, "\r", ""), "\n", "\r"))), flux, Tolerance * flux);
  }
}

TEST_F(PhotometricRobustness, AnyBytesInUtf16GiveASolidOrTheError)
{
  Random random;
  for (const Base& base : Bases())
  {
    for (int i = 0; i < 100; ++i)
    {
      std::string text = Utf16(base.text, random.Below(2) == 0, random.Below(2) == 0);
      for (std::size_t k = random.Below(4); k-- > 0;)
      {
        text[random.Below(text.size())] = static_cast<char>(random.Below(256));
      }
      text.resize(text.size() - random.Below(3));
      try
      {
        EXPECT_GT(Flux(base.read(text)), 0.0);
        ++FileTest::NumberRead;
      }
      catch (const PhotometricFileError& error)
      {
        EXPECT_GE(error.Line, 1u);
        ++FileTest::NumberRefused;
      }
    }
  }
}
