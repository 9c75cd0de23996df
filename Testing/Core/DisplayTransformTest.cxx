// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/appearance/DisplayTransform.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace PhotonTransport;

namespace
{

using Bytes = std::array<std::uint8_t, 3>;

/// A display that shows luminances (cd/m²) as shares of 100 cd/m², and cuts off what is brighter.
DisplaySettings Plain()
{
  DisplaySettings settings;
  settings.adaptationLuminance = 18.0;
  settings.highlightCompression = 0.0;
  settings.whiteLuminance = 100.0;
  return settings;
}

} // namespace

TEST(DisplayTransform, EncodesAsTheStandardSays)
{
  // IEC 61966-2-1: 0.5 is shown by 188, 0.2140 by 127.5; the two branches meet at 0.0031308.
  EXPECT_DOUBLE_EQ(SrgbEncoded(0.0), 0.0);
  EXPECT_NEAR(SrgbEncoded(1.0), 1.0, 1e-12);
  EXPECT_NEAR(255.0 * SrgbEncoded(0.5), 187.5160, 1e-4);
  EXPECT_NEAR(SrgbEncoded(std::pow((0.5 + 0.055) / 1.055, 2.4)), 0.5, 1e-12);
  EXPECT_NEAR(SrgbEncoded(0.002), 0.02584, 1e-12);
  EXPECT_NEAR(SrgbEncoded(0.0031308), SrgbEncoded(std::nextafter(0.0031308, 1.0)), 3e-8);
}

TEST(DisplayTransform, ShowsTheAdaptationLuminanceAsMidGrey)
{
  // 18 % of white: 1.055 * 0.18^(1/2.4) - 0.055 = 0.46136, times 255 = 117.6.
  const DisplayTransform display(Plain());
  EXPECT_EQ(display(glm::dvec3(18.0)), (Bytes{ 118, 118, 118 }));
  EXPECT_EQ(display(glm::dvec3(0.0)), (Bytes{ 0, 0, 0 }));
  EXPECT_EQ(display(glm::dvec3(100.0)), (Bytes{ 255, 255, 255 }));
  EXPECT_EQ(display(glm::dvec3(1e30)), (Bytes{ 255, 255, 255 }));
  DisplaySettings brighter = Plain();
  brighter.compensation = 1.0; // one stop is a factor of two
  EXPECT_EQ(DisplayTransform(brighter)(glm::dvec3(25.0)), display(glm::dvec3(50.0)));
}

TEST(DisplayTransform, CompressesHighlightsByReinhardsCurve)
{
  const ToneCurve all(1.0, 4.0);
  for (const double x : { 0.1, 0.5, 1.0, 2.0, 3.0 })
  {
    EXPECT_NEAR(all(x), x * (1.0 + x / 16.0) / (1.0 + x), 1e-15);
  }
  EXPECT_DOUBLE_EQ(all(4.0), 1.0) << "white is shown as white";
  EXPECT_DOUBLE_EQ(all(5.0), 1.0);

  const ToneCurve half(0.5, 4.0);
  EXPECT_DOUBLE_EQ(half(0.3), 0.3) << "below the knee ratios stay";
  EXPECT_DOUBLE_EQ(half(4.0), 1.0);
  const double slope = (half(0.5 + 1e-6) - half(0.5)) / 1e-6;
  EXPECT_NEAR(slope, 1.0, 1e-5) << "there is no bend at the knee";
  double last = 0.0;
  for (int i = 0; i <= 500; ++i)
  {
    const double shown = half(0.01 * i);
    EXPECT_TRUE(shown >= last && shown <= 1.0) << i;
    last = shown;
  }
  const ToneCurve none(1.0, 0.7);
  EXPECT_DOUBLE_EQ(none(0.6), 0.6) << "where all fits the display nothing is compressed";
}

TEST(DisplayTransform, BalancesWhite)
{
  EXPECT_EQ(WhiteAdaptation(Colour(2.0f)), glm::dmat3(1.0));
  const Colour warm(1.0f, 0.6f, 0.25f);
  const glm::dvec3 white = WhiteAdaptation(warm) * glm::dvec3(warm);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(white[c], LuminousSum(warm), 1e-6) << "that light looks white, as bright as it was";
  }
  // Bradford's published matrix from illuminant A to D65 (B. Lindbloom, "Chromatic adaptation"),
  // from XYZ to XYZ, here between red, green and blue of the same whites.
  const glm::dmat3 toXyz = glm::transpose(
    glm::dmat3(0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505));
  const glm::dvec3 a = glm::inverse(toXyz) * glm::dvec3(1.09850, 1.0, 0.35585);
  const glm::dmat3 expected = glm::transpose(glm::dmat3(0.8446965, -0.1179225, 0.3948108,
    -0.1366303, 1.1041226, 0.1291718, 0.0798489, -0.1348999, 3.1924009));
  const glm::dmat3 found = toXyz * WhiteAdaptation(Colour(a)) * glm::inverse(toXyz);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(found[i][j], expected[i][j], 1e-3) << i << " " << j;
    }
  }
}

TEST(DisplayTransform, KeepsHueAndLuminanceWithinTheDisplay)
{
  const glm::dvec3 bright = WithinDisplay({ 1.6, 0.4, 0.1 });
  EXPECT_NEAR(LuminousSum(bright), LuminousSum({ 1.6, 0.4, 0.1 }), 1e-7);
  EXPECT_DOUBLE_EQ(bright.x, 1.0);
  EXPECT_NEAR((bright.x - bright.y) / (bright.x - bright.z), 1.2 / 1.5, 1e-9) << "the same hue";
  const glm::dvec3 below = WithinDisplay({ 0.5, 0.3, -0.1 });
  EXPECT_NEAR(below.z, 0.0, 1e-15);
  EXPECT_NEAR(LuminousSum(below), LuminousSum({ 0.5, 0.3, -0.1 }), 1e-7);
  EXPECT_EQ(WithinDisplay({ 0.2, 0.9, 1.0 }), glm::dvec3(0.2, 0.9, 1.0));
}

TEST(DisplayTransform, AdaptsToTheMeanOfTheLogarithm)
{
  EXPECT_NEAR(LogMeanLuminance({ { 1.0, 10.0 }, { 1.0, 1000.0 } }), 100.0, 1e-12);
  EXPECT_NEAR(LogMeanLuminance({ { 3.0, 10.0 }, { 1.0, 1000.0 } }), std::pow(10.0, 1.5), 1e-12);
  // The mean is 5, so what is dark counts as 0.005.
  EXPECT_NEAR(LogMeanLuminance({ { 1.0, 0.0 }, { 1.0, 10.0 } }), std::sqrt(0.05), 1e-12);
  EXPECT_EQ(LogMeanLuminance({ { 1.0, 0.0 } }), 0.0);
  EXPECT_EQ(LogMeanLuminance({}), 0.0);
}
