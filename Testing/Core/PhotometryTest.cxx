// SPDX-License-Identifier: BSD-3-Clause
// Photometric solids, and files of which the light is known.
#include "PhotometryTools.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace PhotonTransport;

namespace
{

using Type = PhotometricSolid::Type;
constexpr double Pi = 3.14159265358979323846;

/// The test files have six digits.
constexpr double DigitsOfFiles = 5e-6;
/// Rounding of a few hundred products and sums.
constexpr double Rounding = 1e-12;

/// The integral of Intensity by Simpson's rule along p, along z by the trapezoid, which is exact
/// for a function that is linear there. @param error Bound of Simpson's.
double FluxByQuadrature(const PhotometricSolid& solid, double& error)
{
  double flux = 0.0;
  error = 0.0;
  const double largest = *std::max_element(solid.candela.begin(), solid.candela.end());
  for (std::size_t i = 0; i + 1 < solid.azimuth.size(); ++i)
  {
    // At the planes themselves: an azimuth of a full turn is the first one again.
    const double middle = 0.5 * (solid.azimuth[i] + solid.azimuth[i + 1]);
    const double dz = glm::radians(solid.azimuth[i + 1] - solid.azimuth[i]);
    for (std::size_t j = 0; j + 1 < solid.polar.size(); ++j)
    {
      const double span = solid.polar[j + 1] - solid.polar[j];
      const int parts = static_cast<int>(std::ceil(span));
      const double h = span / parts;
      for (int k = 0; k < parts; ++k)
      {
        const auto value = [&](double part)
        {
          const double p = solid.polar[j] + std::min((k + part) * h, span);
          return Intensity(solid, p, middle) * std::sin(glm::radians(p));
        };
        flux += dz * glm::radians(h) * (value(0.0) + 4.0 * value(0.5) + value(1.0)) / 6.0;
        // |(I sin p)''''| <= I + 4 |I'| for linear I.
        const double slope = largest / glm::radians(span);
        error += dz * std::pow(glm::radians(h), 5) / 2880.0 * (largest + 4.0 * slope);
      }
    }
  }
  return flux;
}

void ExpectFluxIsIntegral(const PhotometricSolid& solid)
{
  double error = 0.0;
  const double flux = FluxByQuadrature(solid, error);
  EXPECT_NEAR(Flux(solid), flux, error + Rounding * flux);
  EXPECT_LT(error, 1e-5 * flux) << "the check is worth nothing";
}

/// I = 1000 cd max(0, d.a) (1 + d.x/2 + d.y/4), as in the files asymmetric*.
double Asymmetric(const glm::dvec3& d)
{
  return 1000.0 * std::max(0.0, -d.z) * (1.0 + 0.5 * d.x + 0.25 * d.y);
}

/// Largest second derivative of that along a circle: 1 of d.a; 2 of (d.a)(d.x), which is at most
/// cos(2t)/2 there.
constexpr double AsymmetricCurvature = 1000.0 * (1.0 + 0.5 * 2.0 + 0.25 * 2.0);

/// h^2/8 times the second derivative bounds what linear interpolation errs, for either angle.
double InterpolationError(const PhotometricSolid& solid)
{
  const double p = glm::radians(solid.polar[1] - solid.polar[0]);
  const double z = glm::radians(solid.azimuth[1] - solid.azimuth[0]);
  return (p * p + z * z) / 8.0 * AsymmetricCurvature;
}

void ExpectAsymmetric(const PhotometricSolid& solid, Type type)
{
  EXPECT_EQ(solid.type, type);
  EXPECT_EQ(solid.ratedFlux, 0.0);
  EXPECT_EQ(solid.inputPower, 40.0);
  const double error = InterpolationError(solid) + 2000.0 * DigitsOfFiles;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 2000; ++i)
  {
    const double p = 180.0 * uniform(random);
    const double z = 720.0 * uniform(random) - 360.0;
    const glm::dvec3 d = PhotometricDirection(type, p, z);
    EXPECT_NEAR(Intensity(solid, p, z), Asymmetric(d), error) << p << ' ' << z;
  }
  // The flux is pi 1000 cd: the other terms are odd.
  EXPECT_NEAR(Flux(solid), 1000.0 * Pi, 2.0 * Pi * error);
  ExpectFluxIsIntegral(solid);
}

/// Symmetric to both planes (0), to that of 0 degrees (1), to that of 90 degrees (2), to none (3).
double Lobes(int asymmetry, double p, double z)
{
  const double c = std::cos(glm::radians(z)) * (asymmetry == 1 || asymmetry == 3 ? 1.0 : 0.0);
  const double s = std::sin(glm::radians(z)) * (asymmetry >= 2 ? 1.0 : 0.0);
  const double both = std::cos(glm::radians(2.0 * z));
  return (2.0 + std::cos(glm::radians(p))) * (5.0 + c + s + both);
}

void ExpectSame(const PhotometricSolid& a, const PhotometricSolid& b, const std::string& what)
{
  SCOPED_TRACE(what);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 500; ++i)
  {
    const double p = 180.0 * uniform(random);
    const double z = 360.0 * uniform(random);
    EXPECT_NEAR(Intensity(a, p, z), Intensity(b, p, z), Rounding * 24.0) << p << ' ' << z;
  }
  EXPECT_NEAR(Flux(a), Flux(b), Rounding * Flux(b));
}

PhotometricSolid File(const std::string& name)
{
  return ReadPhotometricFile(DataFile(name));
}

} // namespace

TEST(PhotometricSolid, DirectionsAreThoseOfTheHeader)
{
  const auto expect = [](Type type, double p, double z, const glm::dvec3& d)
  { EXPECT_LT(glm::distance(PhotometricDirection(type, p, z), d), Rounding); };
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), aim(0, 0, -1);
  expect(Type::C, 0, 30, aim);
  expect(Type::C, 90, 0, x);
  expect(Type::C, 90, 90, y);
  expect(Type::A, 0, 30, y);
  expect(Type::A, 90, 0, aim);
  expect(Type::A, 90, 90, x);
  expect(Type::B, 0, 30, x);
  expect(Type::B, 90, 0, aim);
  expect(Type::B, 90, 90, y);
}

TEST(PhotometricSolid, FluxIsTheIntegralOfIntensity)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 20; ++i)
  {
    PhotometricSolid solid;
    for (double p = 20.0 * uniform(random); p <= 180.0; p += 0.01 + 20.0 * uniform(random))
    {
      solid.polar.push_back(p);
    }
    for (double z = -90.0 * uniform(random); z <= 270.0; z += 0.01 + 40.0 * uniform(random))
    {
      solid.azimuth.push_back(z);
    }
    for (std::size_t k = 0; k < solid.polar.size() * solid.azimuth.size(); ++k)
    {
      solid.candela.push_back(uniform(random));
    }
    ExpectFluxIsIntegral(solid);
  }
}

TEST(PhotometricSolid, NarrowIntervalsLoseNothing)
{
  PhotometricSolid even;
  even.polar = { 0.0, 5e-324, 1e-9, 30.0, 30.0 + 1e-13, 180.0 };
  even.azimuth = { 0.0, 360.0 };
  even.candela.assign(12, 1.0);
  EXPECT_NEAR(Flux(even), 4.0 * Pi, Rounding);
  even.candela[4] = even.candela[10] = 1e3; // a peak of no width
  EXPECT_TRUE(std::isfinite(Flux(even)));
}

TEST(PhotometricFile, EvenLight)
{
  for (const char* name : { "isotropic.ies", "isotropic.ldt" })
  {
    const PhotometricSolid solid = File(name);
    EXPECT_NEAR(Flux(solid), 1000.0, 1000.0 * DigitsOfFiles);
    EXPECT_EQ(solid.ratedFlux, 1000.0);
    EXPECT_EQ(solid.inputPower, 12.5);
    EXPECT_NEAR(Intensity(solid, 77.0, 1234.5), 250.0 / Pi, 250.0 * DigitsOfFiles);
    EXPECT_DOUBLE_EQ(solid.width, 0.1);
    EXPECT_DOUBLE_EQ(solid.length, 0.1);
  }
  EXPECT_EQ(File("isotropic.ies").description, "Example, Even light, 1000 lm, ISO-1000");
  EXPECT_EQ(File("isotropic.ldt").description, "Example, Even light, 1000 lm, ISOTROPIC");
}

TEST(PhotometricFile, FactorsCommasFeetAndLinesOfDos)
{
  const PhotometricSolid solid = File("lambertian.ies");
  // Candela multiplier 2, ballast factor 0.95.
  const double peak = 1000.0 * 2.0 * 0.95;
  EXPECT_NEAR(Intensity(solid, 0.0, 0.0), peak, peak * DigitsOfFiles);
  // h^2/8 I'' of I = I_0 cos p, over the half sphere's 2 pi.
  const double h = glm::radians(5.0);
  EXPECT_NEAR(Flux(solid), Pi * peak, 2.0 * Pi * peak * (h * h / 8.0 + DigitsOfFiles));
  EXPECT_EQ(Intensity(solid, 90.1, 0.0), 0.0);
  EXPECT_EQ(solid.ratedFlux, 7000.0);
  EXPECT_DOUBLE_EQ(solid.width, 2.0 * 0.3048);
  EXPECT_DOUBLE_EQ(solid.length, 4.0 * 0.3048);
  EXPECT_EQ(solid.height, 0.0);
}

TEST(PhotometricFile, AllTypesDescribeTheSameLamp)
{
  ExpectAsymmetric(File("asymmetric_c.ies"), Type::C);
  ExpectAsymmetric(File("asymmetric_b.ies"), Type::B);
  ExpectAsymmetric(File("asymmetric_a.ies"), Type::A);
  ExpectAsymmetric(File("asymmetric.ldt"), Type::C);
  EXPECT_EQ(File("asymmetric_c.ies").description,
    "Example, Brighter towards 0 than 180, 90 than 270 degrees, ASYM-C");
}

TEST(PhotometricFile, TiltFactorsAndThoseOf1986)
{
  for (const char* name : { "tilt_included.ies", "tilt_file.ies" })
  {
    const PhotometricSolid solid = File(name);
    // Ballast 0.9, ballast-lamp photometric factor 0.8, tilt factor 0.5 at 0 degrees.
    EXPECT_NEAR(Intensity(solid, 45.0, 10.0), 1000.0 * 0.9 * 0.8 * 0.5, 1000.0 * Rounding);
    EXPECT_NEAR(Flux(solid), 360.0 * 4.0 * Pi, 5000.0 * Rounding);
    EXPECT_NE(solid.description.find("dims with tilt"), std::string::npos);
  }
}

TEST(PhotometricFile, EulumdatOfUnevenAnglesFromTheFirstOfTwoSetsOfLamps)
{
  const PhotometricSolid solid = File("lateral.ldt");
  EXPECT_EQ(solid.ratedFlux, 2000.0);
  EXPECT_EQ(solid.inputPower, 30.0);
  EXPECT_DOUBLE_EQ(solid.length, 0.4);
  EXPECT_DOUBLE_EQ(solid.width, 0.2);
  const auto expect = [&](double p, double z, double candela)
  { EXPECT_NEAR(Intensity(solid, p, z), candela, 1000.0 * DigitsOfFiles * 2.0); };
  const double half = 1000.0 * std::sqrt(0.5);
  // I = 1000 cd cos p (1 + sin p sin z / 2 + 0.3 (sin p cos z)^2)
  expect(45.0, 90.0, half * (1.0 + 0.5 * std::sqrt(0.5)));
  expect(45.0, 270.0, half * (1.0 - 0.5 * std::sqrt(0.5)));
  expect(45.0, 0.0, half * 1.15);
  expect(45.0, 180.0, half * 1.15);
  expect(2.5, 120.0, Intensity(solid, 2.5, 60.0));
}

TEST(PhotometricFile, SymmetriesOfTypeCExpandToTheSameSolid)
{
  const auto vertical = Steps(0, 180, 20);
  const auto read = [&](int asymmetry, const std::vector<double>& horizontal)
  {
    return ReadIesText(
      IesText(1, vertical, horizontal, [&](double v, double h) { return Lobes(asymmetry, v, h); }));
  };
  const auto full = [&](int asymmetry) { return read(asymmetry, Steps(0, 360, 15)); };
  ExpectSame(read(0, Steps(0, 90, 15)), full(0), "a quarter");
  ExpectSame(read(1, Steps(0, 180, 15)), full(1), "the half above 0 degrees");
  ExpectSame(read(2, Steps(90, 270, 15)), full(2), "the half about 180 degrees");
  ExpectSame(read(3, Steps(0, 345, 15)), full(3), "without the last plane");
  for (int symmetry : { 0, 2, 3, 4 })
  {
    const int asymmetry = symmetry == 0 ? 3 : symmetry == 4 ? 0 : symmetry - 1;
    const auto text = EulumdatText(symmetry, Steps(0, 345, 15), vertical,
      [&](double g, double c) { return Lobes(asymmetry, g, c); });
    ExpectSame(
      ReadEulumdatText(text), full(asymmetry), "EULUMDAT's symmetry " + std::to_string(symmetry));
  }
}

TEST(PhotometricFile, SymmetriesOfTypesAAndBExpandToTheSameSolid)
{
  for (int type : { 2, 3 })
  {
    // Symmetric in the vertical angle (1), in the horizontal one (2), in both (0).
    const auto read = [&](int asymmetry, double firstV, double firstH)
    {
      return ReadIesText(IesText(type, Steps(firstV, 90, 10), Steps(firstH, 90, 15),
        [&](double v, double h)
        {
          const double odd = asymmetry == 0 ? 0.0 : asymmetry == 1 ? h : v;
          return 2.0 + std::cos(glm::radians(v)) * std::cos(glm::radians(h)) +
            std::sin(glm::radians(odd));
        }));
    };
    ExpectSame(read(0, 0, 0), read(0, -90, -90), "a quarter");
    ExpectSame(read(1, 0, -90), read(1, -90, -90), "the upper half");
    ExpectSame(read(2, -90, 0), read(2, -90, -90), "the right half");
  }
}

TEST(PhotometricFile, IsUtf8ForEveryFile)
{
  const auto description = [](const std::string& maker)
  {
    std::string text = IesText(1, { 0, 90 }, { 0 }, [](double, double) { return 1.0; });
    return ReadIesText(text.insert(text.find("[TEST]"), "[MANUFAC] " + maker + "\n")).description;
  };
  EXPECT_EQ(description("L\xC3\xBC"
                        "x\t1"),
    "L\xC3\xBC"
    "x 1");
  EXPECT_EQ(description("L\xFC"
                        "x"),
    "L\xC3\xBC"
    "x");
}
