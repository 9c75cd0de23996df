// SPDX-License-Identifier: BSD-3-Clause
// Any lamp anywhere in or about a closed room with any fault of its mesh: all flux is accounted
// for, and where surely less than nine tenths of it came to fronts there is a warning.
#include "FilterTools.h"
#include "RoomMesh.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace
{

class FilterMissingLight : public FilterTest
{
protected:
  FilterMissingLight()
    : FilterTest("light that goes missing without a word")
  {
  }

  double Lumens(const char* name) const { return FieldValue(this->Filter->GetOutput(), name); }

  double Uniform(double low, double high)
  {
    return std::uniform_real_distribution<>(low, high)(this->Random);
  }
  std::size_t Below(std::size_t count)
  {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(this->Random);
  }

  /// A room that may be seen from outside, with facets doubled or without area.
  Mesh Room(unsigned seed)
  {
    Mesh room = RandomRoom(seed);
    for (std::size_t i = this->Below(4); i > 0; --i)
    {
      room.polygons.push_back(room.polygons[this->Below(room.polygons.size())]);
    }
    for (std::size_t i = this->Below(4); i > 0; --i)
    {
      const auto a = static_cast<vtkIdType>(this->Below(room.points.size()));
      room.polygons.insert(room.polygons.begin(), { { a, a, 0 }, 0.5 });
    }
    this->SeenFromOutside = this->Below(3) == 0;
    if (this->SeenFromOutside)
    {
      for (Point& normal : room.normals)
      {
        normal = { -normal.x, -normal.y, -normal.z };
      }
    }
    return room;
  }

  /// Anywhere, at a point of the walls, or in the plane of one.
  Point LampPlace(const Mesh& room)
  {
    const auto corner = [&](const Cell& cell, std::size_t i)
    { return room.points[static_cast<std::size_t>(cell.corners[i])]; };
    switch (this->Below(4))
    {
      case 0:
        return room.points[this->Below(room.points.size())];
      case 1:
      {
        const Cell& cell = room.polygons.back();
        const Point a = corner(cell, 0), b = corner(cell, 1), c = corner(cell, 2);
        return { 0.5 * a.x + 0.3 * b.x + 0.2 * c.x, 0.5 * a.y + 0.3 * b.y + 0.2 * c.y,
          0.5 * a.z + 0.3 * b.z + 0.2 * c.z };
      }
      case 2:
        return { this->Uniform(-30, 30), this->Uniform(-30, 30), this->Uniform(-30, 30) };
      default:
        return { this->Uniform(-0.3, 0.3), this->Uniform(-0.3, 0.3), this->Uniform(-0.3, 0.3) };
    }
  }

  std::mt19937 Random{ 1 };
  bool SeenFromOutside = false; ///< Of such a body light may rightly pass by.
};

} // namespace

TEST_F(FilterMissingLight, IsAllAccountedForOrTold)
{
  const int scenes = std::getenv("ILLUMINATION_LONG_TESTS") ? 5000 : 300;
  int told = 0;
  this->Filter->SetPhotons(8192);
  for (int scene = 0; scene < scenes; ++scene)
  {
    SCOPED_TRACE(scene);
    const Mesh room = this->Room(static_cast<unsigned>(scene));
    const Point place = this->LampPlace(room);
    this->Filter->SetInputData(room.Data(scene % 2 == 0, true));
    this->Filter->SetLampType(
      vtkIlluminationMap::POINT + static_cast<int>(this->Below(5))); // all that have a place
    this->Filter->SetLampPosition(place.x, place.y, place.z);
    this->Filter->SetLampDirection(
      this->Uniform(-1, 1), this->Uniform(-1, 1), this->Uniform(-1, 1) + 1e-3);
    this->Filter->SetLampSize(this->Uniform(0, 0.1), this->Uniform(0, 0.1));
    this->Filter->SetReflectance(
      this->Uniform(0.3, 0.9)); // scattered light tells that it is closed
    this->Messages->Clear();
    this->Run();
    EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
    const double fronts = this->Lumens("FluxOnFronts");
    const double emitted = this->Lumens("EmittedFlux");
    EXPECT_NEAR(
      fronts + this->Lumens("FluxOnBacks") + this->Lumens("FluxEscaped"), emitted, 1e-9 * emitted);
    const double due = emitted - (this->SeenFromOutside ? this->Lumens("FluxEscaped") : 0.0);
    // Three standard errors of the 8192 photons.
    if (fronts < (0.9 - 3.0 * std::sqrt(0.1 * 0.9 / 8192.0)) * due)
    {
      EXPECT_GT(this->Messages->Warnings, 0)
        << fronts << " lm of " << due << " and " << this->Lumens("FluxEscaped") << " escaped"
        << ", lamp at " << place.x << ' ' << place.y << ' ' << place.z;
      ++told;
    }
    EXPECT_LE(this->Messages->Warnings, 1) << this->Messages->Text;
  }
  EXPECT_GT(told, scenes / 20);
  EXPECT_LT(told, scenes * 9 / 10);
  this->Messages->Clear();
  this->Measured(std::to_string(scenes) + " random scenes, " + std::to_string(told) +
    " of them short of light: all told");
}
