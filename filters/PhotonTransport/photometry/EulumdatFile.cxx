// SPDX-License-Identifier: BSD-3-Clause
// A. W. Stockmar, "EULUMDAT - ein Leuchtendatenformat fuer den europaeischen Beleuchtungsplaner",
// Licht '90, pp. 641-644; numbers in comments are lines of that format.
#include "PhotonTransport/photometry/PhotometricFile.h"
#include "PhotonTransport/photometry/SolidSymmetry.h"
#include "PhotonTransport/photometry/TextReader.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

namespace
{

/// What lines 2 to 7 say of the intensities to come.
struct Grid
{
  std::size_t symmetry = 0;
  std::size_t planes = 0; ///< Of the full circle.
  std::size_t angles = 0;

  std::size_t FirstGiven() const { return this->symmetry == 3 ? 3 * this->planes / 4 : 0; }
  std::size_t Given() const
  {
    const std::size_t given[] = { this->planes, 1, this->planes / 2 + 1, this->planes / 2 + 1,
      this->planes / 4 + 1 };
    return given[this->symmetry];
  }
};

void Skip(TextReader& reader, std::size_t lines, const char* name)
{
  for (std::size_t i = 0; i < lines; ++i)
  {
    reader.TextLine(name);
  }
}

Grid ReadGrid(TextReader& reader)
{
  Grid grid;
  Skip(reader, 1, "type indicator"); // 2
  grid.symmetry = reader.CountLine("symmetry indicator", 0, 4);
  grid.planes = reader.CountLine("number of C-planes", 1, MostAngles);
  const std::size_t divisor = grid.symmetry < 2 ? 1 : grid.symmetry == 2 ? 2 : 4;
  if (grid.planes % divisor != 0)
  {
    reader.Refuse("number of C-planes",
      "symmetry " + std::to_string(grid.symmetry) + " needs a multiple of " +
        std::to_string(divisor));
  }
  Skip(reader, 1, "distance of C-planes"); // 5: the angles are listed all the same
  grid.angles = reader.CountLine("number of angles in each C-plane", 2, MostAngles);
  if (grid.angles * grid.planes > MostIntensities)
  {
    reader.Fail("there are " + std::to_string(grid.planes) + " x " + std::to_string(grid.angles) +
      " angles; there must be at most " + std::to_string(MostIntensities));
  }
  Skip(reader, 1, "distance of angles"); // 7
  return grid;
}

double ReadSize(TextReader& reader, const char* name)
{
  constexpr double metres = 1e-3;
  return metres * std::abs(reader.NumberLineOr0(name, -LargestNumber, LargestNumber));
}

void ReadOpening(TextReader& reader, PhotometricSolid& solid)
{
  Skip(reader, 3, "size of the luminaire"); // 13 to 15
  solid.length = ReadSize(reader, "length of the luminous area");
  const double width = ReadSize(reader, "width of the luminous area");
  solid.width = width == 0.0 ? solid.length : width; // 0: round
  for (int plane = 0; plane < 4; ++plane)
  {
    solid.height = std::max(solid.height, ReadSize(reader, "height of the luminous area"));
  }
}

bool IsNumber(const std::string& line)
{
  return !line.empty() && line.find_first_not_of("+-0123456789") == std::string::npos;
}

double PositiveNumber(TextReader& reader, const char* name)
{
  const double value = reader.NumberLine(name, 0.0, LargestNumber);
  if (value == 0.0)
  {
    reader.Refuse(name, "it must be above 0");
  }
  return value;
}

/// cd for each cd/klm.
double ReadLamps(TextReader& reader, PhotometricSolid& solid)
{
  Skip(reader, 2, "ratio of fluxes"); // 22, 23
  const double conversion = PositiveNumber(reader, "conversion factor for intensities");
  Skip(reader, 1, "tilt during measurement"); // 25
  const std::size_t sets = reader.CountLine("number of sets of lamps", 1, MostAngles);
  // 26a to 26f: the format lists each of the six for all sets before the next one, but many
  // programs write set after set. A second number of lamps, not the first set's type, tells which
  // it is.
  double lamps = 0.0;
  double flux = 0.0;
  std::size_t step = 1;
  for (std::size_t i = 0; i < 6 * sets; ++i)
  {
    if (i == 0)
    {
      lamps = reader.NumberLine("number of lamps", -LargestNumber, LargestNumber);
    }
    else if (i == 1)
    {
      step = IsNumber(reader.TextLine("type of lamps")) ? sets : 1;
    }
    else if (i == 2 * step)
    {
      flux = PositiveNumber(reader, "flux of the lamps");
    }
    else if (i == 5 * step)
    {
      solid.inputPower = reader.NumberLineOr0("wattage", 0.0, LargestNumber);
    }
    else
    {
      Skip(reader, 1, "set of lamps");
    }
  }
  // A number below 0 marks absolute photometry; the flux is the luminaire's then.
  solid.ratedFlux = lamps < 0.0 ? 0.0 : flux;
  return conversion * flux / 1000.0;
}

std::vector<double> ReadAngles(
  TextReader& reader, const char* name, std::size_t count, double largest)
{
  std::vector<double> angles;
  for (std::size_t i = 1; i <= count; ++i)
  {
    angles.push_back(reader.NumberLine({ name, i }, 0.0, largest));
    if (i > 1 && !(angles[i - 1] > angles[i - 2]))
    {
      reader.Refuse({ name, i }, "angles must rise");
    }
  }
  return angles;
}

/// Planes must be where the symmetry has its mirrors.
void RequireMirrors(const TextReader& reader, const Grid& grid, const std::vector<double>& all)
{
  const auto require = [&](std::size_t plane, double angle)
  {
    if (all[plane] != angle)
    {
      reader.Fail("C-angle " + std::to_string(plane + 1) + " of " + std::to_string(grid.planes) +
        " is not " + std::to_string(static_cast<int>(angle)) + ", as symmetry " +
        std::to_string(grid.symmetry) + " wants");
    }
  };
  if (grid.symmetry != 1)
  {
    require(0, 0.0);
  }
  if (grid.symmetry == 2)
  {
    require(grid.planes / 2, 180.0);
  }
  if (grid.symmetry >= 3)
  {
    require(grid.planes / 4, 90.0);
  }
  if (grid.symmetry == 3)
  {
    require(grid.FirstGiven(), 270.0);
  }
}

/// Angles of the planes that are given; those of symmetry 3 run from 270 degrees through 0 to 90.
std::vector<double> ReadPlanes(TextReader& reader, const Grid& grid)
{
  constexpr const char* name = "C-angle";
  const std::vector<double> all = ReadAngles(reader, name, grid.planes, 360.0);
  RequireMirrors(reader, grid, all);
  if (grid.symmetry == 0 && grid.planes > 1 && !GapIsOneStep(all))
  {
    reader.Refuse({ name, grid.planes }, "the last must be one step before 360");
  }
  std::vector<double> given;
  for (std::size_t i = grid.FirstGiven(); i < grid.FirstGiven() + grid.Given(); ++i)
  {
    const bool turned = i >= grid.planes;
    given.push_back(turned ? all[i - grid.planes] : all[i] - (grid.symmetry == 3 ? 360.0 : 0.0));
  }
  return given;
}

void ReadIntensities(TextReader& reader, const Grid& grid, double factor, PhotometricSolid& solid)
{
  double largest = 0.0;
  for (std::size_t i = 1; i <= grid.Given() * grid.angles; ++i)
  {
    const NumberName name{ "intensity", i };
    solid.candela.push_back(factor * reader.NumberLine(name, 0.0, LargestNumber));
    if (solid.candela.back() > LargestNumber)
    {
      reader.Refuse(name, "times the flux and the conversion factor it is too large");
    }
    largest = std::max(largest, solid.candela.back());
  }
  reader.RequireEnd("intensity");
  if (largest == 0.0)
  {
    reader.Fail("all intensities are 0");
  }
}

} // namespace

PhotometricSolid ReadEulumdat(std::istream& file)
{
  TextReader reader(file);
  PhotometricSolid solid;
  AddToList(solid.description, reader.TextLine("company"));
  const Grid grid = ReadGrid(reader);
  Skip(reader, 1, "measurement report number");
  AddToList(solid.description, reader.TextLine("luminaire name"));
  AddToList(solid.description, reader.TextLine("luminaire number"));
  Skip(reader, 2, "file name and date");
  ReadOpening(reader, solid);
  const double factor = ReadLamps(reader, solid);
  Skip(reader, 10, "direct ratio"); // 27
  solid.azimuth = ReadPlanes(reader, grid);
  solid.polar = ReadAngles(reader, "gamma angle", grid.angles, 180.0);
  ReadIntensities(reader, grid, factor, solid);
  if (grid.symmetry >= 2)
  {
    MirrorAtLastAzimuth(solid);
  }
  if (grid.symmetry == 4)
  {
    MirrorAtLastAzimuth(solid);
  }
  CloseCircle(solid);
  return solid;
}

} // namespace PhotonTransport
