// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/EulumdatGrid.h"

#include "PhotonTransport/photometry/PhotometricFile.h"
#include "PhotonTransport/photometry/PhotometricNumbers.h"
#include "PhotonTransport/photometry/SolidSymmetry.h"

#include <utility>

namespace PhotonTransport
{

namespace
{

constexpr const char* CAngle = "C-angle";

/// C-angles that the file lists, and planes of which it gives intensities.
std::pair<std::size_t, std::size_t> ListedAndGiven(const EulumdatGrid& grid, EulumdatPlanes planes)
{
  const std::size_t given = grid.Given();
  const bool isWhole = grid.planes % grid.Divisor() == 0;
  switch (planes)
  {
    case EulumdatPlanes::Standard:
      return isWhole ? std::pair(grid.planes, given) : std::pair<std::size_t, std::size_t>();
    case EulumdatPlanes::AllGiven:
      return { grid.planes, grid.planes };
    case EulumdatPlanes::ListGiven:
      return isWhole ? std::pair(given, given) : std::pair<std::size_t, std::size_t>();
    case EulumdatPlanes::Closed:
      break;
  }
  EulumdatGrid open = grid;
  --open.planes;
  const bool isClosed = grid.Divisor() > 1 && open.planes > 0 && open.planes % grid.Divisor() == 0;
  return isClosed ? std::pair(grid.planes, open.Given()) : std::pair<std::size_t, std::size_t>();
}

/// Planes must be where the symmetry has its mirrors.
void RequireMirrors(
  const TextReader& reader, const EulumdatGrid& grid, const std::vector<double>& all)
{
  const auto require = [&](std::size_t plane, double angle)
  {
    if (all[plane] != angle)
    {
      reader.Fail("C-angle " + std::to_string(plane + 1) + " of " + std::to_string(grid.planes) +
        " is " + NumberText(all[plane]) + ", not " + NumberText(angle) + ", as symmetry " +
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

/// Of the planes that the standard gives; those of symmetry 3 run from 270 degrees through 0 to 90.
std::vector<double> GivenAzimuths(
  const TextReader& reader, const EulumdatGrid& grid, const std::vector<double>& all)
{
  RequireMirrors(reader, grid, all);
  if (grid.symmetry == 0 && grid.planes > 1 && !GapIsOneStep(all))
  {
    reader.Refuse({ CAngle, grid.planes }, "the last must be one step before 360");
  }
  std::vector<double> given;
  for (std::size_t i = grid.FirstGiven(); i < grid.FirstGiven() + grid.Given(); ++i)
  {
    const bool turned = i >= grid.planes;
    given.push_back(turned ? all[i - grid.planes] : all[i] - (grid.symmetry == 3 ? 360.0 : 0.0));
  }
  return given;
}

/// The symmetry of planes that are all given: where they end tells what their mirrors are.
std::size_t SymmetryOf(
  const TextReader& reader, const EulumdatGrid& grid, const std::vector<double>& given)
{
  const double first = given.front();
  const double last = given.back();
  if (given.size() == 1)
  {
    return 1;
  }
  if ((grid.symmetry == 4 && first == 0.0 && last == 90.0) ||
    (grid.symmetry == 2 && first == 0.0 && last == 180.0) ||
    (grid.symmetry == 3 && first == 90.0 && last == 270.0))
  {
    return grid.symmetry;
  }
  if (first == 0.0 && GapIsOneStep(given))
  {
    return 0;
  }
  reader.Refuse({ CAngle, given.size() },
    "intensities follow for every C-angle of the file, but the angles do not end where symmetry " +
      std::to_string(grid.symmetry) + " has a mirror, and make no full circle");
}

void NoteOn(TextReader& reader, const EulumdatGrid& grid, EulumdatPlanes planes)
{
  const std::string symmetry = "symmetry " + std::to_string(grid.symmetry);
  const std::string count = std::to_string(grid.planes) + " C-planes";
  if (planes == EulumdatPlanes::AllGiven)
  {
    reader.Note("intensities of all " + count + " are there, although " + symmetry +
      " needs fewer; all were used");
  }
  else if (planes == EulumdatPlanes::ListGiven)
  {
    reader.Note("only the C-angles that " + symmetry + " needs are listed, not " + count);
  }
  else if (planes == EulumdatPlanes::Closed)
  {
    reader.Note("the " + count + " count 360 degrees beside 0");
  }
}

} // namespace

std::size_t EulumdatGrid::Divisor() const
{
  return this->symmetry < 2 ? 1 : this->symmetry == 2 ? 2 : 4;
}

std::size_t EulumdatGrid::Given() const
{
  const std::size_t given[] = { this->planes, 1, this->planes / 2 + 1, this->planes / 2 + 1,
    this->planes / 4 + 1 };
  return given[this->symmetry];
}

EulumdatGrid ReadEulumdatGrid(TextReader& reader)
{
  EulumdatGrid grid;
  grid.symmetry = reader.CountLine("symmetry indicator", 0, 4);
  grid.planes = reader.CountLine("number of C-planes", 1, MostAngles);
  grid.planesLine = reader.LineNumber();
  reader.TextLine("distance of C-planes"); // the angles are listed all the same
  grid.angles = reader.CountLine("number of angles in each C-plane", 2, MostAngles);
  RequireManageable(reader, grid.planes, grid.angles);
  reader.TextLine("distance of angles");
  return grid;
}

std::size_t NumbersOf(const EulumdatGrid& grid, EulumdatPlanes planes)
{
  const auto [listed, given] = ListedAndGiven(grid, planes);
  return listed == 0 ? 0 : listed + grid.angles + given * grid.angles;
}

void ReadEulumdatSolid(TextReader& reader, const EulumdatGrid& grid, EulumdatPlanes planes,
  double factor, PhotometricSolid& solid)
{
  const auto [listed, given] = ListedAndGiven(grid, planes);
  if (listed == 0)
  {
    throw PhotometricFileError(grid.planesLine,
      "number of C-planes is '" + std::to_string(grid.planes) + "'; symmetry " +
        std::to_string(grid.symmetry) + " needs a multiple of " + std::to_string(grid.Divisor()));
  }
  NoteOn(reader, grid, planes);
  std::vector<double> azimuth = ReadAngles(reader, CAngle, listed, 0.0, 360.0);
  EulumdatGrid read = grid;
  if (planes == EulumdatPlanes::AllGiven || planes == EulumdatPlanes::ListGiven)
  {
    read.symmetry = SymmetryOf(reader, grid, azimuth);
    solid.azimuth = std::move(azimuth);
  }
  else
  {
    if (planes == EulumdatPlanes::Closed)
    {
      if (azimuth.back() != 360.0)
      {
        reader.Refuse({ CAngle, listed }, "the number of C-planes does not go with the symmetry");
      }
      azimuth.pop_back();
      --read.planes;
    }
    solid.azimuth = GivenAzimuths(reader, read, azimuth);
  }
  solid.polar = ReadAngles(reader, "gamma angle", grid.angles, 0.0, 180.0);
  solid.candela = ReadIntensities(reader, "intensity", given * grid.angles, factor);
  if (read.symmetry >= 2)
  {
    MirrorAtLastAzimuth(solid);
  }
  if (read.symmetry == 4)
  {
    MirrorAtLastAzimuth(solid);
  }
  CloseCircle(solid);
}

} // namespace PhotonTransport
