// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that overlap in a plane and face the same way, such as a carpet modelled at the floor's
// level: all of them read the light that arrives there.
#include "FilterLightTools.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>
#include <random>
#include <sstream>

namespace
{

using Data = vtkSmartPointer<vtkPolyData>;

constexpr double Lux = 1000.0;

/// A triangle in z = 0 with its front up.
Data Triangle(double x, double y, double size)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x, y, 0.0);
  points->InsertNextPoint(x + size, y, 0.0);
  points->InsertNextPoint(x, y + size, 0.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  auto data = Data::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

/// Turns about an axis of unit length, then moves.
struct Motion
{
  Point axis;
  double degrees;
  Point shift{ 0.0, 0.0, 0.0 };

  Point Turned(const Point& p) const // Rodrigues' formula
  {
    const double angle = this->degrees * std::acos(-1.0) / 180.0;
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const Point& a = this->axis;
    const double along = (1.0 - cosine) * (a.x * p.x + a.y * p.y + a.z * p.z);
    return { cosine * p.x + sine * (a.y * p.z - a.z * p.y) + along * a.x,
      cosine * p.y + sine * (a.z * p.x - a.x * p.z) + along * a.y,
      cosine * p.z + sine * (a.x * p.y - a.y * p.x) + along * a.z };
  }
  Point operator()(const Point& p) const
  {
    const Point q = this->Turned(p);
    return { q.x + this->shift.x, q.y + this->shift.y, q.z + this->shift.z };
  }
};

/// A number rounded to single precision. Where GCC 12 vectorises two conversions in a row, it
/// leaves both out; it may not leave out the store.
double InSingle(double value)
{
  const volatile float single = static_cast<float>(value);
  return double{ single };
}

enum class Rounded
{
  Not,        ///< Double precision.
  ToSingle,   ///< Points of type float.
  Beforehand, ///< Points of type double that hold numbers of single precision.
};

Data Moved(const Data& data, const Motion& motion, Rounded rounded)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(rounded == Rounded::ToSingle ? VTK_FLOAT : VTK_DOUBLE);
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    double x[3];
    data->GetPoint(p, x);
    const Point place = motion({ x[0], x[1], x[2] });
    const auto coordinate = [&](double value)
    { return rounded == Rounded::Beforehand ? InSingle(value) : value; };
    points->InsertNextPoint(coordinate(place.x), coordinate(place.y), coordinate(place.z));
  }
  auto moved = Data::New();
  moved->SetPoints(points);
  moved->SetPolys(data->GetPolys());
  return moved;
}

/// A tilted floor, and a wall that is turned about z.
const std::vector<Motion> Turns = {
  { { 1.0 / std::sqrt(14.0), 2.0 / std::sqrt(14.0), 3.0 / std::sqrt(14.0) }, 33.0 },
  { { 1.0, 0.0, 0.0 }, 80.0 }
};

const std::vector<Point> Shifts = { { 0, 0, 0 }, { 10, 20, 5 }, { 100, 200, 30 },
  { 1000, 2000, 50 } };

class FilterOverlaps : public FilterLightTest
{
protected:
  FilterOverlaps()
    : FilterLightTest("a carpet at the floor's level and the like: part of the light on each")
  {
  }

  /// All points must read the same light. Their mean and their deviations are held against the
  /// standard errors. Those of neighbours depend on each other, which raises the mean's by less
  /// than sqrt(3). By chance one point in 200 000 is 12 of them off (Student's t with 7 degrees of
  /// freedom), and one floor of four points in 10 000 three on the root mean square (F with 4 and
  /// 28).
  void ExpectEverywhere(const LightArrays& light, double lux)
  {
    const Values& values = light.at("Illuminance");
    const Values& errors = light.at("StandardError");
    const auto number = static_cast<double>(values.size());
    double mean = 0.0;
    Values deviations;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      mean += values[i] / number;
      deviations.push_back(values[i] - lux);
      EXPECT_NEAR(values[i], lux, 12.0 * errors[i]) << "point " << i;
    }
    const double error = RootMeanSquare(errors);
    EXPECT_NEAR(mean, lux, 4.0 * std::sqrt(3.0 / number) * error);
    EXPECT_LT(RootMeanSquare(deviations), 3.0 * error);
    EXPECT_LT(error, 0.1 * lux); // so that half or twice the light would be seen
    this->LargestShare = std::max(this->LargestShare, std::fabs(mean / lux - 1.0));
    ++this->Compared;
  }

  /// A floor and a carpet in its plane, far from the origin, lit aslant.
  std::vector<Data> FloorAndCarpet(Motion motion, const Point& shift, Rounded rounded)
  {
    motion.shift = shift;
    const Point sun = motion.Turned({ 0.2, 0.1, -1.0 });
    this->Filter->SetLampDirection(sun.x, sun.y, sun.z);
    this->Filter->SetPhotons(400000);
    return { Moved(Patch({ -2, -2, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, 8, 8), motion, rounded),
      Moved(Patch({ -0.77, -0.63, 0 }, { 1.5, 0, 0 }, { 0, 1.3, 0 }, 5, 4), motion, rounded) };
  }

  void MeasuredMeans()
  {
    std::ostringstream text;
    text.precision(1);
    text << "the means of " << this->Compared << " surfaces are at most " << this->LargestShare
         << " of the light off";
    this->Measured(text.str());
  }
};

} // namespace

TEST_F(FilterOverlaps, CarpetAndFloorReadTheWholeLight)
{
  const double lux = Lux / std::sqrt(1.05); // for the direction (0.2, 0.1, -1)
  this->Filter->SetPhotons(1000000);
  const Data floor = Patch({ -2, -2, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, 16, 16);
  const Data carpet = Patch({ -0.77, -0.63, 0 }, { 1.5, 0, 0 }, { 0, 1.3, 0 }, 9, 7);
  for (const std::vector<Data>& blocks :
    { std::vector<Data>{ floor, carpet }, { carpet, floor }, { carpet, floor, carpet } })
  {
    vtkNew<vtkAppendPolyData> joined;
    for (const Data& block : blocks)
    {
      joined->AddInputData(block);
    }
    joined->Update();
    for (const int registration : { 0, 1, 2 })
    {
      SCOPED_TRACE(registration);
      this->Filter->SetRegistration(registration);
      for (const LightArrays& light : this->Light(Blocks(blocks)))
      {
        this->ExpectEverywhere(light, lux);
      }
      this->ExpectEverywhere(this->Light(joined->GetOutput())[0], lux);
      EXPECT_NE(
        this->Notes().find(" overlap others in their plane that face the same way, such as those "
                           "of cell "),
        std::string::npos)
        << this->Notes();
    }
  }
  this->MeasuredMeans();
}

// Single precision rounds the points of a site by far more than the scene rounds its own.
TEST_F(FilterOverlaps, RoundedFarFromTheOriginBothReadTheWholeLight)
{
  for (const Motion& turn : Turns)
  {
    for (const Point& shift : Shifts)
    {
      for (const Rounded rounded : { Rounded::ToSingle, Rounded::Not })
      {
        SCOPED_TRACE(testing::Message()
          << turn.degrees << " degrees, x " << shift.x << ", type " << static_cast<int>(rounded));
        const std::vector<Data> blocks = this->FloorAndCarpet(turn, shift, rounded);
        for (const LightArrays& light : this->Light(Blocks(blocks)))
        {
          this->ExpectEverywhere(light, Lux / std::sqrt(1.05));
        }
        EXPECT_NE(this->Notes().find(" triangles overlap others in their plane"), std::string::npos)
          << this->Notes();
      }
    }
  }
  this->MeasuredMeans();
}

// Where the filter does not know of the rounding, both read the whole light, or a warning names two
// cells, what they have in common and how far they are apart.
TEST_F(FilterOverlaps, RoundedUnknownToTheFilterTheyReadTheWholeLightOrAreTold)
{
  int told = 0;
  for (const Motion& turn : Turns)
  {
    for (const Point& shift : Shifts)
    {
      SCOPED_TRACE(testing::Message() << turn.degrees << " degrees, x " << shift.x);
      const std::vector<Data> blocks = this->FloorAndCarpet(turn, shift, Rounded::Beforehand);
      const bool far = shift.x > 50.0;
      const std::vector<LightArrays> lights = this->Light(Blocks(blocks), far ? 1 : 0);
      if (far)
      {
        for (const char* part : { " triangles lie nearly in the plane of others that face the same "
                                  "way, such as those of cell ",
               " of block 1 and cell ", " of block 2 (on 0.0", " m^2). They are at most " })
        {
          EXPECT_NE(this->Messages->Text.find(part), std::string::npos) << this->Messages->Text;
        }
        ++told;
        continue;
      }
      for (const LightArrays& light : lights)
      {
        this->ExpectEverywhere(light, Lux / std::sqrt(1.05));
      }
    }
  }
  std::ostringstream text;
  text << "right light in " << 2 * Shifts.size() - static_cast<std::size_t>(told)
       << " scenes, a warning in the other " << told;
  this->Measured(text.str());
}

// Tiles of random sizes on a tilted floor, in single precision, so that no two lie exactly in one
// plane.
TEST_F(FilterOverlaps, RandomTilesOnATiltedFloorReadTheWholeLight)
{
  const Point u{ 3.1, 0.7, 1.2 }, v{ -0.9, 2.8, 0.4 };
  const Point normal{ u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x };
  this->Filter->SetLampDirection(-normal.x, -normal.y, -normal.z);
  this->Filter->SetPhotons(400000);
  std::mt19937 random(5);
  const auto within = [&](double low, double high)
  { return std::uniform_real_distribution<>(low, high)(random); };
  const auto times = [](double a, const Point& p) { return Point{ a * p.x, a * p.y, a * p.z }; };
  for (int scene = 0; scene < 20; ++scene)
  {
    SCOPED_TRACE(scene);
    this->Filter->SetRegistration(scene % 3);
    std::vector<Data> blocks = { Patch({ 0, 0, 0 }, u, v, 1 + scene % 7, 1 + scene % 4) };
    for (int tile = 0; tile < 3; ++tile)
    {
      const double width = within(0.3, 0.6), height = within(0.3, 0.6);
      const Point a = times(within(0.0, 1.0 - width), u), b = times(within(0.0, 1.0 - height), v);
      blocks.insert(blocks.begin() + tile % 2,
        Patch({ a.x + b.x, a.y + b.y, a.z + b.z }, times(width, u), times(height, v), 1 + tile,
          1 + scene % 3));
    }
    for (const LightArrays& light : this->Light(Blocks(blocks)))
    {
      this->ExpectEverywhere(light, Lux);
    }
  }
  this->MeasuredMeans();
}

// The material of the later surface counts, and one warning names two cells and what they have in
// common.
TEST_F(FilterOverlaps, UnlikeMaterialsAreToldAndTheLaterCounts)
{
  this->Filter->SetReflectanceArray("rho");
  this->Filter->SetLampDirection(0.0, 0.0, -1.0);
  this->Filter->SetMetresPerUnit(0.5);
  const Data floor = Triangle(0.0, 0.0, 4.0); // 8 square units, and the carpet half of one
  const Data carpet = Triangle(0.25, 0.25, 1.0);
  for (const bool carpetLast : { true, false })
  {
    for (const bool whiteCarpet : { true, false })
    {
      SCOPED_TRACE(testing::Message() << carpetLast << whiteCarpet);
      SetCells(floor, "rho", whiteCarpet ? 0.0 : 1.0);
      SetCells(carpet, "rho", whiteCarpet ? 1.0 : 0.0);
      this->Light(
        Blocks(carpetLast ? std::vector{ floor, carpet } : std::vector{ carpet, floor }), 1);
      EXPECT_NE(this->Messages->Text.find(
                  "2 triangles lie in the place of others that face the same way and have another "
                  "material, such as those of cell 0 of block 1 and cell 0 of block 2 (on 0.125 "
                  "m^2)"),
        std::string::npos)
        << this->Messages->Text;
      const double onFloor = Lux * 0.25 * 8.0, onCarpet = Lux * 0.25 * 0.5;
      const double black =
        !carpetLast ? (whiteCarpet ? onFloor : 0.0) : (whiteCarpet ? onFloor - onCarpet : onCarpet);
      const double emitted = this->FieldValue("EmittedFlux");
      const double photons = this->FieldValue("PhotonsEmitted");
      const double share = black / emitted;
      // Four standard errors of a binomial number, which is more than that of Sobol's points.
      EXPECT_NEAR(this->FieldValue("PhotonsAbsorbed") / photons, share,
        4.0 * std::sqrt(share * (1.0 - share) / photons));
      EXPECT_NEAR(
        this->FieldValue("FluxOnFronts"), onFloor, 4.0 * emitted * std::sqrt(0.25 / photons));
    }
  }
  this->Measured("one warning with cells and area; absorbed flux within 4 standard errors");
}

// All light of a luminous polygon in the plane of a closed room's wall reaches the room, once.
TEST_F(FilterOverlaps, ALuminousPolygonInAWallShinesOnce)
{
  this->Filter->SetLampType(vtkIlluminationMap::EMITTING_FACETS);
  this->Filter->SetExitanceArray("rho");
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    Mesh room = RandomRoom(seed);
    Cell lamp{ {}, Lux };
    for (Cell& cell : room.polygons)
    {
      cell.reflectance = 0.0;
    }
    const std::vector<vtkIdType> wall = room.polygons[seed].corners;
    for (std::size_t i = 0; i < 3; ++i) // half as large as the triangle of three corners
    {
      const Point& p = room.points[static_cast<std::size_t>(wall[i])];
      const Point& q = room.points[static_cast<std::size_t>(wall[0])];
      lamp.corners.push_back(static_cast<vtkIdType>(room.points.size()));
      room.normals.push_back(room.normals[static_cast<std::size_t>(wall[i])]);
      room.points.push_back({ (p.x + q.x) / 2.0, (p.y + q.y) / 2.0, (p.z + q.z) / 2.0 });
    }
    double flux = 0.0;
    for (const std::size_t lamps : { 1, 2 }) // the second is a copy
    {
      room.polygons.insert(seed % 2 == 0 ? room.polygons.begin() : room.polygons.end(), lamp);
      this->Light(room.Data(false, true));
      flux = lamps == 1 ? this->FieldValue("EmittedFlux") : flux;
      EXPECT_NEAR(this->FieldValue("EmittedFlux"), flux, 1e-6 * flux);
      EXPECT_EQ(this->FieldValue("FluxEscaped") + this->FieldValue("FluxOnBacks"), 0.0);
      EXPECT_NEAR(this->FieldValue("FluxOnFronts"), flux, 1e-6 * flux);
    }
  }
  this->Measured("10 turned rooms: all light on fronts, and a copy adds none");
}

// Two that shine on the same place both do, and that is told.
TEST_F(FilterOverlaps, TwoLampsInOnePlaceAreTold)
{
  this->Filter->SetLampType(vtkIlluminationMap::EMITTING_FACETS);
  this->Filter->SetExitanceArray("lux");
  const Data one = Triangle(0.0, 0.0, 4.0), two = Triangle(0.25, 0.25, 1.0);
  SetCells(one, "lux", Lux);
  SetCells(two, "lux", 2.0 * Lux);
  const Data ceiling = Patch({ -9, -9, 1 }, { 0, 30, 0 }, { 30, 0, 0 }, 3, 3);
  SetCells(ceiling, "lux", 0.0);
  this->Light(Blocks({ one, two, ceiling }), 1);
  EXPECT_NE(
    this->Messages->Text.find("2 triangles shine where others shine that face the same way, "
                              "such as those of cell 0 of block 1 and cell 0 of block 2 "
                              "(on 0.5 m^2)"),
    std::string::npos)
    << this->Messages->Text;
  EXPECT_NEAR(this->FieldValue("EmittedFlux"), Lux * (8.0 + 2.0 * 0.5), 1e-6 * 9.0 * Lux);
  this->Measured("one warning with cells and area; the flux of both");
}

// A pane that is there twice lets light through as one does, and both read what arrives.
TEST_F(FilterOverlaps, APaneThatIsThereTwiceIsOne)
{
  const Data floor = Patch({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, 4, 4);
  const Data pane = Patch({ -2, -2, 1 }, { 4, 0, 0 }, { 0, 4, 0 }, 3, 3);
  const Data halves = Patch({ -2, -2, 1 }, { 4, 0, 0 }, { 0, 4, 0 }, 2, 5);
  SetCells(floor, "ClearTransmittance", 0.0);
  SetCells(pane, "ClearTransmittance", 0.8);
  SetCells(halves, "ClearTransmittance", 0.8);
  const std::vector<LightArrays> one = this->Light(Blocks({ floor, pane }));
  for (const std::vector<LightArrays>& light :
    { this->Light(Blocks({ floor, pane, pane })), this->Light(Blocks({ floor, pane, halves })) })
  {
    this->ExpectLightOf(one[0], light[0], RelativeNoise(one[0]));
    this->ExpectLightOf(one[1], light[1], RelativeNoise(one[1]));
    this->ExpectEverywhere(light[2], Lux / std::sqrt(1.05));
  }
  EXPECT_LT(RootMeanSquare(one[0].at("Illuminance")), 0.8 * Lux);
  this->Measured(
    "a pane, its copy and one of other squares: the floor reads the same but for noise");
}
