// SPDX-License-Identifier: BSD-3-Clause
// Filtration in the rows of vertices beside edges of the light: what it brings into them, and what
// it says of its error there.
#include "PhotonMap.h"
#include "Shapes.h"

#include "PhotonTransport/filtration/Filtration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace PhotonTransport;

namespace
{

const FiltrationMonitor NoMonitor = [](double) {};
constexpr double CreaseAngle = 0.7;
constexpr int Cells = 40;

/// Share of photons that a place gets, by its distance from the middle in cells.
using Light = std::function<double(double)>;

/// The shadow of a plate just above: its edge is amid a row of cells.
double PlateShadow(double distance)
{
  return distance < 0.5 ? 1.0 : 0.0;
}

/// At the foot of a box: the light fades towards it, and there is none below.
double ContactShadow(double distance)
{
  return distance < 0.0 ? std::min(1.0, 0.5 - 0.1 * distance) : 0.0;
}

/// A crease's row with a thirtieth of the light beside it.
double Crease(double distance)
{
  return std::fabs(distance) < 1.0 ? 0.01 : std::min(1.0, 0.15 * std::fabs(distance));
}

Shapes::Surface UnitSquare()
{
  return Shapes::Rectangle(
    glm::dvec3(0.0), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), Cells);
}

/// A column of vertices across the light: sums of squares, in the unit of the light, squared.
struct Column
{
  double truth = 0.0;
  double before = 0.0, after = 0.0, told = 0.0;
};

/// The light at a column of vertices, which all count together what falls within a cell's width, by
/// how near it is: a quadrature by midpoints, none of them at an edge of the light.
double TruthOf(const Light& light, double column)
{
  constexpr int Points = 2000;
  double sum = 0.0;
  for (int i = 0; i < Points; ++i)
  {
    const double offset = (i + 0.5) / Points * 2.0 - 1.0;
    sum += (1.0 - std::fabs(offset)) * light(column + offset);
  }
  return 2.0 * sum / Points;
}

/// The columns of the square after smoothing a map of so many photons. The ends of the columns are
/// left out, which count by other weights.
std::vector<Column> ColumnsOf(const Light& light, int photons, unsigned seed)
{
  const Shapes::Surface surface = UnitSquare();
  const SmoothingGraph graph(surface.points, surface.facets, CreaseAngle);
  std::vector<Column> columns(Cells + 1);
  for (int column = 0; column <= Cells; ++column)
  {
    columns[static_cast<std::size_t>(column)].truth = TruthOf(light, column - 0.5 * Cells);
  }
  const auto across = [&](const glm::dvec3& place) { return light(Cells * (place.x - 0.5)); };
  const PhotonMap traced(surface, across, photons, seed);
  const FilteredMap smooth = Filtrate(graph, { traced.map }, traced.hits, {}, NoMonitor).front();
  for (std::size_t v = 0; v < traced.hits.size(); ++v)
  {
    const glm::dvec3& point = surface.points[v];
    if (std::fabs(point.y - 0.5) < 0.5 - 0.5 / Cells)
    {
      Column& column = columns[static_cast<std::size_t>(std::lround(Cells * point.x))];
      column.before += std::pow(traced.map.values[v] / photons - column.truth, 2);
      column.after += std::pow(smooth.values[v] / photons - column.truth, 2);
      column.told += smooth.squaredError[v] / photons / photons;
    }
  }
  return columns;
}

/// Of some numbers, one a seed.
struct Mean
{
  double sum = 0.0, squares = 0.0;
  int count = 0;

  void Add(double x)
  {
    sum += x;
    squares += x * x;
    ++count;
  }
  double Value() const { return sum / count; }
  double StandardError() const
  {
    return std::sqrt(std::max(0.0, squares / count - Value() * Value()) / (count - 1));
  }
};

/// Told over true error is from 0.6 to 2, within 3 standard errors, in the lit columns within three
/// of the middle.
void ExpectErrorsTold(const Light& light, const std::vector<int>& budgets)
{
  for (const int photons : budgets)
  {
    std::vector<Mean> ratios(Cells + 1);
    std::vector<Column> columns;
    for (unsigned seed = 1; seed <= 8; ++seed)
    {
      columns = ColumnsOf(light, photons, seed);
      for (std::size_t c = 0; c < columns.size(); ++c)
      {
        ratios[c].Add(std::sqrt(columns[c].told / columns[c].after));
      }
    }
    for (std::size_t c = Cells / 2 - 3; c <= Cells / 2 + 3; ++c)
    {
      if (columns[c].truth > 0.0)
      {
        const double tolerance = 3.0 * ratios[c].StandardError();
        EXPECT_GT(ratios[c].Value(), 0.6 - tolerance) << photons << " photons, column " << c;
        EXPECT_LT(ratios[c].Value(), 2.0 + tolerance) << photons << " photons, column " << c;
      }
    }
  }
}

} // namespace

TEST(FiltrationEdges, TellsTheErrorBesideThem)
{
  ExpectErrorsTold(PlateShadow, { 3'000, 20'000, 100'000, 500'000 });
  ExpectErrorsTold(ContactShadow, { 5'000, 20'000, 100'000, 500'000 });
  // Its middle has 0.1 photons a vertex at 20,000 photons. With fewer nothing tells it from chance.
  ExpectErrorsTold(Crease, { 20'000, 100'000, 500'000 });
}

TEST(FiltrationEdges, RelativeErrorDoesNotGrowAtADimCrease)
{
  for (const int photons : { 500'000, 2'000'000 })
  {
    double before = 0.0;
    double after = 0.0;
    for (unsigned seed = 1; seed <= 8; ++seed)
    {
      for (const Column& column : ColumnsOf(Crease, photons, seed))
      {
        before += column.before / (column.truth * column.truth);
        after += column.after / (column.truth * column.truth);
      }
    }
    EXPECT_LT(after, before) << photons;
  }
}

TEST(FiltrationEdges, TellsAnErrorOfASmallPatchThatNoPhotonCameTo)
{
  const Shapes::Surface square = UnitSquare();
  const Shapes::Surface surface = Shapes::Together(
    square, Shapes::Rectangle({ 5.0, 0.0, 0.0 }, { 0.01, 0.0, 0.0 }, { 0.0, 0.01, 0.0 }, 1));
  const SmoothingGraph graph(surface.points, surface.facets, CreaseAngle);
  PhotonMap traced(
    square, [](const glm::dvec3&) { return 1.0; }, 20'000, 1);
  traced.map.values.resize(surface.points.size(), 0.0);
  traced.map.groups.resize(surface.points.size(), GroupValues{});
  traced.hits.resize(surface.points.size(), 0.0);
  const FilteredMap smooth = Filtrate(graph, { traced.map }, traced.hits, {}, NoMonitor).front();
  // A photon would bring more than the light elsewhere, 20,000 of a unit of area 1, and that is
  // what it may have: the patch is 1 / 10,000 of the square.
  for (std::size_t v = square.points.size(); v < surface.points.size(); ++v)
  {
    EXPECT_EQ(smooth.values[v], 0.0);
    EXPECT_GT(std::sqrt(smooth.squaredError[v]), 0.3 * 20'000);
    EXPECT_LT(std::sqrt(smooth.squaredError[v]), 20'000 * 1.0001);
  }
}
