// SPDX-License-Identifier: BSD-3-Clause
// Copies of facets that face the same way: every one of them reads the light that it would read
// alone. Facets that overlap in part are in FilterOverlapsTest, those that face opposite ways in
// FilterSheetsTest.
#include "FilterLightTools.h"

#include "vtkLuminaireSource.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <array>
#include <random>
#include <sstream>

namespace
{

using Data = vtkSmartPointer<vtkPolyData>;

/// A hit's barycentric coordinates carry the rounding of single precision, 2^-24 of a scene in [-1,
/// 1], over the height of its facet, here more than 1/16 of the scene, and a few operations.
constexpr double Rounding = 0x1p-17;

/// The triangles of a surface anew, the six orders of their corners in turn.
vtkSmartPointer<vtkCellArray> InOtherOrders(vtkPolyData* surface)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    surface->GetCellPoints(c, size, ids);
    std::array<vtkIdType, 3> corners = { ids[0], ids[1], ids[2] };
    std::rotate(corners.begin(), corners.begin() + c % 3, corners.end());
    if (c % 6 >= 3)
    {
      std::swap(corners[0], corners[1]);
    }
    cells->InsertNextCell(3, corners.data());
  }
  return cells;
}

/// A surface of triangles and a copy of each, whose points are the same or copies too.
Data WithCopies(vtkPolyData* surface, bool ownPoints, bool copiesFirst)
{
  auto copies = Data::New();
  copies->SetPoints(surface->GetPoints());
  copies->GetPointData()->SetNormals(surface->GetPointData()->GetNormals());
  copies->SetPolys(InOtherOrders(surface));
  if (ownPoints)
  {
    vtkNew<vtkAppendPolyData> append;
    append->AddInputData(copiesFirst ? copies.Get() : surface);
    append->AddInputData(copiesFirst ? surface : copies.Get());
    append->Update();
    return append->GetOutput();
  }
  vtkNew<vtkCellArray> both;
  both->DeepCopy(copiesFirst ? copies->GetPolys() : surface->GetPolys());
  both->Append(copiesFirst ? surface->GetPolys() : copies->GetPolys());
  copies->SetPolys(both);
  return copies;
}

class FilterSharedPlaces : public FilterLightTest
{
protected:
  FilterSharedPlaces()
    : FilterLightTest("copies of facets: part of the light on each")
  {
  }

  void ExpectNote(const std::string& words)
  {
    EXPECT_NE(this->Notes().find(words), std::string::npos) << this->Notes();
  }

  void MeasuredCopies()
  {
    std::ostringstream text;
    text.precision(1);
    text << this->Compared << " surfaces read what they read alone, up to " << this->LargestShare
         << " of it";
    this->Measured(text.str());
  }
};

} // namespace

TEST_F(FilterSharedPlaces, CopiesInAnyOrderReadTheLightOfOne)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(12);
  sphere->Update();
  for (const int registration : { 0, 1, 2 })
  {
    this->Filter->SetRegistration(registration);
    const LightArrays alone = this->Light(sphere->GetOutput())[0];
    for (const bool ownPoints : { false, true })
    {
      for (const bool copiesFirst : { false, true })
      {
        SCOPED_TRACE(testing::Message() << registration << ownPoints << copiesFirst);
        const Data both = WithCopies(sphere->GetOutput(), ownPoints, copiesFirst);
        this->ExpectLightOf(alone, this->Light(both)[0], Rounding);
        this->ExpectNote(std::to_string(sphere->GetOutput()->GetNumberOfCells()) +
          " triangles are copies of others");
      }
    }
  }
  this->MeasuredCopies();
}

// With reflected light, colours, the parts of several lamps and means of groups. The photons are
// the same but for rounding at edges, so differences stay below the noise.
TEST_F(FilterSharedPlaces, BlocksThatAreCopiesReadTheLightOfOneInEveryArray)
{
  const Data room = RandomRoom(3).Data(false, true);
  this->Filter->SetReflectanceArray("rho");
  this->Filter->SetLampContributions(true);
  this->Filter->SetGroupMeans(true);
  this->Filter->SetRegisterBackSide(true);
  std::vector<vtkSmartPointer<vtkLuminaireSource>> lamps;
  for (const int type : { vtkLuminaireSource::POINT, vtkLuminaireSource::DISK })
  {
    auto& lamp = lamps.emplace_back(vtkSmartPointer<vtkLuminaireSource>::New());
    lamp->SetType(type);
    lamp->SetPosition(0.1 * type, 0.2, -0.1);
    lamp->SetSize(0.1, 0.0);
    lamp->SetLightColour(1.0, 0.5, 0.1 * type);
    this->Filter->AddLuminaireConnection(lamp->GetOutputPort());
  }
  for (const int registration : { 0, 1, 2 })
  {
    SCOPED_TRACE(registration);
    this->Filter->SetRegistration(registration);
    const LightArrays alone = this->Light(Blocks({ room }))[0];
    for (const char* name : { "Illuminance_Lamp 1", "Illuminance_Lamp 2", "IlluminanceRGB",
           "IlluminanceDirectGroups", "IlluminanceIndirectGroups", "IlluminanceBack" })
    {
      EXPECT_EQ(alone.count(name), 1u) << name;
    }
    for (const std::size_t copies : { 2, 3 })
    {
      for (const LightArrays& light : this->Light(Blocks(std::vector<Data>(copies, room))))
      {
        this->ExpectLightOf(alone, light, RelativeNoise(alone));
      }
    }
  }
  this->MeasuredCopies();
}

TEST_F(FilterSharedPlaces, CopiesAnywhereInARandomRoomChangeNoLight)
{
  this->Filter->SetReflectanceArray("rho");
  this->Filter->SetLampType(vtkIlluminationMap::POINT);
  this->Filter->SetLampPosition(0.2, 0.1, -0.1);
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    SCOPED_TRACE(seed);
    Mesh room = RandomRoom(seed);
    this->Filter->SetRegistration(static_cast<int>(seed % 3));
    const bool single = seed % 2 == 0, withNormals = seed % 5 > 1;
    const LightArrays alone = this->Light(room.Data(single, withNormals))[0];
    std::mt19937 random(seed);
    const std::size_t copies = 1 + 3 * seed;
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < copies; ++i)
    {
      Cell copy = room.polygons[random() % room.polygons.size()];
      if (copy.corners.size() == 3 || !withNormals) // else a square may be cut the other way
      {
        std::rotate(copy.corners.begin(),
          copy.corners.begin() + static_cast<std::ptrdiff_t>(random() % copy.corners.size()),
          copy.corners.end());
      }
      if (copy.corners.size() == 3 && withNormals && random() % 2 == 0)
      {
        std::swap(copy.corners[0], copy.corners[1]); // the normals tell the front, not the winding
      }
      triangles += copy.corners.size() - 2;
      // The first of several squares decides along which diagonal they are cut.
      const std::size_t first = copy.corners.size() == 3 ? 0 : room.polygons.size();
      const std::size_t place = first + random() % (room.polygons.size() + 1 - first);
      room.polygons.insert(room.polygons.begin() + static_cast<std::ptrdiff_t>(place), copy);
    }
    this->ExpectLightOf(
      alone, this->Light(room.Data(single, withNormals))[0], RelativeNoise(alone));
    this->ExpectNote(std::to_string(triangles) +
      (triangles == 1 ? " triangle is a copy of another" : " triangles are copies of others"));
  }
  this->MeasuredCopies();
}

// Compensation goes by a vertex's own normal, so two sheets with other normals read other light.
TEST_F(FilterSharedPlaces, CopiesWithOtherNormalsKeepTheirOwn)
{
  std::vector<Data> plates;
  for (const double tilt : { 0.0, 0.5, -0.3 })
  {
    Data plate = Patch({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 3, 3);
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < plate->GetNumberOfPoints(); ++i)
    {
      normals->InsertNextTuple3(tilt * plate->GetPoint(i)[0], tilt, 1.0);
    }
    plate->GetPointData()->SetNormals(normals);
    plates.push_back(plate);
  }
  for (const int registration : { 0, 1, 2 })
  {
    SCOPED_TRACE(registration);
    this->Filter->SetRegistration(registration);
    const std::vector<LightArrays> light = this->Light(Blocks(plates));
    for (std::size_t i = 0; i < plates.size(); ++i)
    {
      this->ExpectLightOf(this->Light(plates[i])[0], light[i], Rounding);
    }
  }
  this->MeasuredCopies();
}

// Two sheets that face up and one that faces down, in any order, in light from above and from
// below; without the one that faces down, light from below is on the backs of the others.
TEST_F(FilterSharedPlaces, CopiesOfOneSideOfADoubleSheet)
{
  this->Filter->SetRegisterBackSide(true);
  const Data up = Patch({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 4, 3);
  const Data down = Patch({ 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, 3, 4);
  for (const bool fromAbove : { true, false })
  {
    this->Filter->SetLampDirection(0.2, 0.1, fromAbove ? -1.0 : 1.0);
    const LightArrays one = this->Light(up)[0];
    for (const LightArrays& light : this->Light(Blocks({ up, up })))
    {
      this->ExpectLightOf(one, light, Rounding);
    }
    const LightArrays lit = this->Light(fromAbove ? up : down)[0];
    for (const std::size_t place : { 0, 1, 2 })
    {
      for (const int registration : { 0, 1, 2 })
      {
        SCOPED_TRACE(testing::Message() << fromAbove << place << registration);
        this->Filter->SetRegistration(registration); // the plates are flat, so all give the same
        std::vector<Data> sheets(3, up);
        sheets[place] = down;
        const std::vector<LightArrays> light = this->Light(Blocks(sheets));
        for (std::size_t i = 0; i < 3; ++i)
        {
          if ((i == place) != fromAbove)
          {
            this->ExpectLightOf(lit, light[i], Rounding);
            continue;
          }
          EXPECT_EQ(RootMeanSquare(light[i].at("Illuminance")), 0.0);
          EXPECT_EQ(RootMeanSquare(light[i].at("IlluminanceBack")), 0.0);
        }
      }
    }
  }
  this->MeasuredCopies();
}
