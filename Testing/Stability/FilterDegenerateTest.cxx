// SPDX-License-Identifier: BSD-3-Clause
// Facets without area, wherever they are put among those of a good mesh, change no bit of its map:
// no normal, no side, no place, no light.
#include "FilterTools.h"
#include "RoomMesh.h"

#include "vtkIlluminationMapSmoothing.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace
{

/// Puts facets without area into a mesh.
class Spoiler
{
public:
  Spoiler(Mesh& mesh, unsigned seed)
    : Spoilt(mesh)
    , Random(seed)
    , GoodPoints(mesh.points.size())
  {
  }

  void Add(int facets)
  {
    for (int i = 0; i < facets; ++i)
    {
      std::vector<vtkIdType> corners = this->OnALine();
      std::shuffle(corners.begin(), corners.end(), this->Random);
      std::vector<Cell>& cells = this->Below(4) == 0 ? this->Spoilt.strips : this->Spoilt.polygons;
      const auto place = cells.begin() + static_cast<std::ptrdiff_t>(this->Below(cells.size() + 1));
      cells.insert(place, { corners, 0.9 });
    }
  }

  /// Repeats corners of polygons, by id or by a new point in the same place.
  void Stutter()
  {
    for (Cell& cell : this->Spoilt.polygons)
    {
      const std::size_t at = this->Below(cell.corners.size());
      const vtkIdType corner = cell.corners[at];
      const vtkIdType again = this->Below(2) == 0
        ? corner
        : this->NewPoint(Point(this->Spoilt.points[static_cast<std::size_t>(corner)]));
      // After the corner: the first in a place is the one that counts.
      cell.corners.insert(cell.corners.begin() + static_cast<std::ptrdiff_t>(at) + 1, again);
    }
  }

private:
  std::size_t Below(std::size_t count)
  {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(this->Random);
  }
  vtkIdType AnyPoint() { return static_cast<vtkIdType>(this->Below(this->GoodPoints)); }
  vtkIdType NewPoint(const Point& point)
  {
    this->Spoilt.points.push_back(point);
    return static_cast<vtkIdType>(this->Spoilt.points.size()) - 1;
  }

  /// Three to six corners without an area between them.
  std::vector<vtkIdType> OnALine()
  {
    const vtkIdType a = this->AnyPoint();
    const vtkIdType b = this->AnyPoint();
    switch (this->Below(5))
    {
      case 0:
        return { a, a, b };
      case 1:
        return { a, this->NewPoint(Point(this->Spoilt.points[static_cast<std::size_t>(a)])), b };
      case 2: // far away, where it must not set the scale of the scene
      {
        const vtkIdType far = this->NewPoint({ 1e4, -2e4, 3e4 });
        return { far, far, far };
      }
      case 3: // points of the mesh in a row: what closes a gap between coarse and fine triangles
        return this->Spoilt.rows[this->Below(this->Spoilt.rows.size())];
      default:
      {
        std::vector<vtkIdType> corners = { a, b };
        const std::size_t between = 1 + this->Below(4);
        for (std::size_t i = 0; i < between; ++i)
        {
          const double t = std::uniform_real_distribution<>(0.0, 1.0)(this->Random);
          const Point from = this->Spoilt.points[static_cast<std::size_t>(a)];
          const Point to = this->Spoilt.points[static_cast<std::size_t>(b)];
          corners.push_back(this->NewPoint({ from.x + t * (to.x - from.x),
            from.y + t * (to.y - from.y), from.z + t * (to.z - from.z) }));
        }
        return corners;
      }
    }
  }

  Mesh& Spoilt;
  std::mt19937 Random;
  std::size_t GoodPoints;
};

class FilterDegenerate : public FilterTest
{
protected:
  FilterDegenerate()
    : FilterTest("facets without area that spoil computed normals and turn a room dark or patchy")
  {
  }

  void SetUp() override
  {
    this->FilterTest::SetUp();
    this->Filter->SetLampType(vtkIlluminationMap::POINT);
    this->Filter->SetLampPosition(0.3, 0.2, -0.1);
    this->Filter->SetReflectanceArray("rho");
    this->Filter->SetPhotons(8192);
  }

  vtkSmartPointer<vtkPolyData> MapOf(const Mesh& mesh, bool single, bool normals)
  {
    this->Filter->SetInputData(mesh.Data(single, normals));
    this->ExpectMap();
    auto map = vtkSmartPointer<vtkPolyData>::New();
    map->ShallowCopy(this->Filter->GetOutput());
    return map;
  }

  /// The same at the good mesh's points, nothing at those that were added.
  static void ExpectSame(vtkPolyData* spoilt, vtkPolyData* good, const char* name)
  {
    vtkDataArray* found = spoilt->GetPointData()->GetArray(name);
    vtkDataArray* expected = good->GetPointData()->GetArray(name);
    ASSERT_TRUE(found && expected);
    int different = 0;
    for (vtkIdType p = 0; p < found->GetNumberOfTuples(); ++p)
    {
      const double wanted = p < expected->GetNumberOfTuples() ? expected->GetTuple1(p) : 0.0;
      different += found->GetTuple1(p) != wanted; // no tolerance: to the bit
    }
    EXPECT_EQ(different, 0) << name << " of " << found->GetNumberOfTuples() << " points";
  }
};

} // namespace

TEST_F(FilterDegenerate, AnywhereInARandomRoomChangeNoBit)
{
  const int rooms = std::getenv("ILLUMINATION_LONG_TESTS") ? 2000 : 40;
  for (int room = 0; room < rooms; ++room)
  {
    SCOPED_TRACE(room);
    const auto seed = static_cast<unsigned>(room);
    const bool single = room % 2 == 0;
    const bool normals = room % 4 < 2;
    this->Filter->SetRegistration(room % 3);
    this->Filter->SetFeatureAngle(room % 8 < 4 ? 30.0 : 120.0);
    const Mesh good = RandomRoom(seed);
    Mesh spoilt = good;
    Spoiler(spoilt, seed).Add(1 + room % 40);
    const auto expected = this->MapOf(good, single, normals);
    const auto found = this->MapOf(spoilt, single, normals);
    for (const char* name : { "Illuminance", "StandardError", "PhotonHits" })
    {
      ExpectSame(found, expected, name);
    }
    EXPECT_NE(this->Notes().find("have no area and were left out"), std::string::npos);
    if (this->HasFailure())
    {
      return;
    }
  }
}

// In a text file with few digits a point of an edge does not lie on it, and a triangle of three
// such points has an area. It is the first cell, has no normals, and decides nothing for its
// neighbours.
TEST_F(FilterDegenerate, SliversOfRoundedPointsTurnNothing)
{
  double mostOnBacks = 0.0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    Mesh room = RandomRoom(seed);
    const double digits = std::pow(10.0, 3.0 + seed % 6);
    const auto rounded = [&](double x) { return std::round(x * digits) / digits; };
    const Cell wall = room.polygons[seed % room.polygons.size()];
    const Point a = room.points[static_cast<std::size_t>(wall.corners[0])];
    const Point b = room.points[static_cast<std::size_t>(wall.corners[1])];
    room.points.push_back({ 0.7 * a.x + 0.3 * b.x, 0.7 * a.y + 0.3 * b.y, 0.7 * a.z + 0.3 * b.z });
    for (Point& point : room.points)
    {
      point = { rounded(point.x), rounded(point.y), rounded(point.z) };
    }
    const auto between = static_cast<vtkIdType>(room.points.size() - 1);
    const bool turned = seed % 2 == 0;
    room.polygons.insert(room.polygons.begin(),
      { { wall.corners[turned ? 1 : 0], between, wall.corners[turned ? 0 : 1] }, 0.5 });
    const auto map = this->MapOf(room, false, false);
    const double onBacks = FieldValue(map, "FluxOnBacks");
    const double emitted = FieldValue(map, "EmittedFlux");
    // The sliver's own back is about its height, a digit's rounding, times its length.
    EXPECT_LE(onBacks, 0.01 * emitted);
    mostOnBacks = std::max(mostOnBacks, onBacks / emitted);
  }
  char text[96];
  std::snprintf(text, sizeof text, "at most %.1e of the light on backs in 40 rooms", mostOnBacks);
  this->Measured(text);
}

TEST_F(FilterDegenerate, RepeatedCornersOfPolygonsChangeNoBit)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh good = RandomRoom(seed);
    Mesh spoilt = good;
    Spoiler(spoilt, seed).Stutter();
    const auto expected = this->MapOf(good, seed % 2 == 0, seed % 4 < 2);
    const auto found = this->MapOf(spoilt, seed % 2 == 0, seed % 4 < 2);
    ExpectSame(found, expected, "Illuminance");
  }
}

TEST_F(FilterDegenerate, ARoomKeepsTheLightThatTheoryGivesIt)
{
  // Without openings every photon hits 1 / (1 - rho) times on the mean, with a variance of
  // rho / (1 - rho)^2, so sum A E = Phi / (1 - rho) to sqrt(rho / photons) of itself.
  constexpr double Reflectance = 0.5;
  this->Filter->SetReflectanceArray("");
  this->Filter->SetReflectance(Reflectance);
  this->Filter->SetPhotons(65536);
  this->Filter->SetLampPosition(0.0, 0.0, 0.0);
  Mesh room = RandomRoom(1);
  Spoiler(room, 7).Add(30);
  const auto map = this->MapOf(room, true, false);
  double flux = 0.0; // sum of hits is three times sum A E over the flux of a photon
  for (vtkIdType p = 0; p < map->GetNumberOfPoints(); ++p)
  {
    flux += map->GetPointData()->GetArray("PhotonHits")->GetTuple1(p) / 3.0;
  }
  const double photons = FieldValue(map, "PhotonsEmitted");
  const double ratio = flux / photons * (1.0 - Reflectance);
  const double error = std::sqrt(Reflectance / photons);
  EXPECT_NEAR(ratio, 1.0, 4.0 * error);
  char text[96];
  std::snprintf(
    text, sizeof text, "%.4f of the light in theory, standard error %.4f", ratio, error);
  this->Measured(text);
}

TEST_F(FilterDegenerate, ABlockOfNothingElseIsAsUnlitAsItLooks)
{
  const Mesh good = RandomRoom(3);
  Mesh none;
  none.points = good.points;
  none.polygons = { { { 0, 1, 1 }, 0.5 }, { { 2, 2, 2 }, 0.5 } };
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, none.Data(true, false));
  blocks->SetBlock(1, good.Data(true, false));
  const auto expected = this->MapOf(good, true, false);
  this->Filter->SetInputData(blocks);
  this->Run();
  EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  ExpectSame(vtkPolyData::SafeDownCast(output->GetBlock(1)), expected, "Illuminance");
  vtkDataArray* unlit = vtkPolyData::SafeDownCast(output->GetBlock(0))
                          ->GetPointData()
                          ->GetArray("Illuminance"); // the output has no array in part
  ASSERT_TRUE(unlit);
  EXPECT_EQ(unlit->GetRange()[1], 0.0);
  this->Filter->SetInputData(none.Data(true, false));
  this->ExpectError("no polygons or triangle strips with an area");
}

TEST_F(FilterDegenerate, SmoothingDoesNotSeeThem)
{
  this->Filter->SetGroupMeans(true);
  for (const bool normals : { true, false })
  {
    const Mesh good = RandomRoom(5);
    Mesh spoilt = good;
    for (int i = 0; i < 6; ++i) // no points of their own
    {
      const auto place = static_cast<std::ptrdiff_t>(i) * 7;
      spoilt.polygons.insert(spoilt.polygons.begin() + place,
        { good.rows[static_cast<std::size_t>(i) * 5 % good.rows.size()], 0.9 });
      spoilt.polygons.insert(spoilt.polygons.begin() + place, { { i, i, i + 1 }, 0.9 });
    }
    vtkNew<vtkIlluminationMapSmoothing> smoothing;
    smoothing->SetInputData(this->MapOf(good, true, normals));
    smoothing->Update();
    vtkNew<vtkPolyData> expected;
    expected->ShallowCopy(smoothing->GetOutput());
    smoothing->SetInputData(this->MapOf(spoilt, true, normals));
    smoothing->Update();
    for (const char* name : { "IlluminanceSmoothed", "StandardErrorSmoothed" })
    {
      ExpectSame(vtkPolyData::SafeDownCast(smoothing->GetOutput()), expected, name);
    }
  }
}

TEST_F(FilterDegenerate, ALuminousMeshShinesAsWithoutThem)
{
  const auto fluxOf = [&](const Mesh& mesh)
  {
    const vtkSmartPointer<vtkPolyData> lamp = mesh.Data(true, false);
    vtkNew<vtkDoubleArray> exitance;
    exitance->SetName("Exitance");
    exitance->SetNumberOfTuples(lamp->GetNumberOfCells());
    exitance->Fill(10.0);
    lamp->GetCellData()->AddArray(exitance);
    this->Filter->RemoveAllLuminaires();
    this->Filter->SetInputData(1, lamp);
    this->Filter->SetInputData(0, RandomRoom(2).Data(true, true));
    this->ExpectMap();
    return FieldValue(this->Filter->GetOutput(), "EmittedFlux");
  };
  const Mesh good = RandomRoom(2);
  Mesh spoilt = good;
  Spoiler(spoilt, 3).Add(20);
  EXPECT_EQ(fluxOf(spoilt), fluxOf(good));
}

TEST_F(FilterDegenerate, SmallFacetsFarFromTheOriginAreNone)
{
  // Squares of 0.4 m, 500 km from the origin in single precision, which rounds by 16 mm there.
  Mesh far;
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < 6; ++j)
    {
      far.points.push_back({ 5e5 + 0.4 * i, 5e5 + 0.4 * j, 0.0 });
    }
  }
  for (vtkIdType i = 0; i < 5; ++i)
  {
    for (vtkIdType j = 0; j < 5; ++j)
    {
      const vtkIdType a = 6 * i + j;
      far.polygons.push_back({ { a, a + 6, a + 7, a + 1 }, 0.5 });
    }
  }
  this->Filter->SetLampType(vtkIlluminationMap::PARALLEL);
  this->Filter->SetInputData(far.Data(true, false));
  this->ExpectMap();
  EXPECT_EQ(this->Notes(), "the points had no normals; they were computed\n");
}
