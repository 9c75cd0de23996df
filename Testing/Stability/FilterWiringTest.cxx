// SPDX-License-Identifier: BSD-3-Clause
// Luminaires that are turned, moved, scaled and mirrored at random, any number of times, through
// filters, one by one and in groups: each lights a closed room as one does that was made where it
// ends, and where one of them was damaged there is one error and no map. Each case is a function of
// its number, which a failure tells. Twenty times as many with ILLUMINATION_LONG_TESTS=1.
#include "FilterTools.h"

#include "vtkLuminaireSource.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkClipPolyData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkReverseSense.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"
#include "vtkTrivialProducer.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace
{

using Data = vtkSmartPointer<vtkPolyData>;

constexpr int Photons = 16384;
constexpr double Half = 4.0; ///< Of the room's edge, about the origin.

/// One that was moved, and one that was made where that went.
struct Twins
{
  Data moved;
  Data made;
};

class FilterWiring : public FilterTest
{
protected:
  FilterWiring()
    : FilterTest("luminaires that were moved, grouped, appended or cut: light in the wrong place, "
                 "lamps that are missing")
  {
  }

  void SetUp() override
  {
    FilterTest::SetUp();
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(2.0 * Half);
    cube->SetYLength(2.0 * Half);
    cube->SetZLength(2.0 * Half);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(cube->GetOutputPort());
    vtkNew<vtkReverseSense> inward;
    inward->ReverseNormalsOn();
    inward->SetInputConnection(triangles->GetOutputPort());
    inward->Update();
    this->Surface = inward->GetOutput();
    this->Filter->SetInputData(this->Surface);
    this->Filter->SetReflectance(0.0);
    this->Filter->SetLampContributions(true);
    this->Filter->SetPhotons(Photons);
  }

  int Below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(this->Random); }
  double Within(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }

  static Data Through(vtkPolyData* data, vtkPolyDataAlgorithm* filter)
  {
    filter->SetInputData(data);
    filter->Update();
    return filter->GetOutput();
  }

  static Data Transformed(vtkPolyData* data, vtkTransform* transform)
  {
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetTransform(transform);
    return Through(data, filter);
  }

  /// Any of the kinds that a source can make in any place.
  Twins Draw()
  {
    const int types[] = { vtkLuminaireSource::POINT, vtkLuminaireSource::LAMBERTIAN_POINT,
      vtkLuminaireSource::SPOT, vtkLuminaireSource::DISK, vtkLuminaireSource::SPHERE,
      vtkLuminaireSource::LINE };
    vtkNew<vtkLuminaireSource> source;
    source->SetType(types[this->Below(6)]);
    source->SetSpotHalfAngle(this->Within(10.0, 120.0));
    source->SetSize(this->Below(5) == 0 ? 0.0 : this->Within(0.1, 0.5), 1.0);
    source->SetLuminousFlux(this->Within(500.0, 1000.0));
    source->SetPosition(this->Within(-9.0, 9.0), this->Within(-9.0, 9.0), this->Within(-9.0, 9.0));
    source->SetDirection(this->Within(-1.0, 1.0), this->Within(-1.0, 1.0), this->Within(0.1, 1.0));
    source->Update();
    Twins twins{ Data::New(), Data::New() };
    twins.moved->ShallowCopy(source->GetOutput());

    const double scale = this->Move(source, twins.moved);
    source->SetSize(source->GetSize()[0] * scale, 1.0);
    source->Update();
    twins.made->ShallowCopy(source->GetOutput());
    return twins;
  }

  /// Moves the geometry by VTK's filters and the source by its properties, into the room.
  /// @return The scale.
  double Move(vtkLuminaireSource* source, Data& moved)
  {
    double whole = 1.0;
    for (int step = this->Below(4); step >= 0; --step)
    {
      vtkNew<vtkTransform> transform;
      if (step == 0) // the last one puts it into the room
      {
        const double* at = source->GetPosition();
        transform->Translate(this->Within(-2.0, 2.0) - at[0], this->Within(-2.0, 2.0) - at[1],
          this->Within(-2.0, 2.0) - at[2]);
      }
      else
      {
        const double scale = this->Within(0.6, 1.4);
        whole *= scale;
        transform->Translate(this->Within(-9.0, 9.0), 0.0, this->Within(-9.0, 9.0));
        transform->RotateWXYZ(this->Below(2) == 0 ? 180.0 : this->Within(0.0, 360.0),
          this->Within(-1.0, 1.0), this->Within(-1.0, 1.0), this->Within(0.1, 1.0));
        transform->Scale(this->Below(2) == 0 ? -scale : scale, scale, scale);
      }
      moved = this->Filtered(Transformed(moved, transform));
      std::array<double, 3> position{}, direction{};
      transform->TransformPoint(source->GetPosition(), position.data());
      transform->TransformVector(source->GetDirection(), direction.data());
      source->SetPosition(position.data());
      source->SetDirection(direction.data());
    }
    return whole;
  }

  /// Through a filter that leaves a luminaire as it is, or none.
  Data Filtered(Data data)
  {
    switch (this->Below(4))
    {
      case 0:
        return Through(data, vtkNew<vtkCleanPolyData>());
      case 1:
        return Through(data, vtkNew<vtkTriangleFilter>());
      default:
        return data;
    }
  }

  /// In a way that loses a lamp, or leaves it undefined.
  Data Damaged(vtkPolyData* data)
  {
    const int kind = this->Below(4);
    if (kind == 0)
    {
      vtkNew<vtkTransform> uneven;
      uneven->Scale(1.0, 1.1, 1.3);
      uneven->RotateY(30.0);
      return Transformed(data, uneven);
    }
    if (kind == 1)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(data->GetCenter());
      plane->SetNormal(0.6, 0.5, 0.7);
      vtkNew<vtkClipPolyData> clip;
      clip->SetClipFunction(plane);
      return Through(data, clip);
    }
    vtkNew<vtkAppendPolyData> append;
    append->AddInputData(data);
    append->AddInputData(kind == 2 ? this->Draw().moved.Get() : data);
    append->Update();
    return append->GetOutput();
  }

  /// One by one or in groups, nested and with empty blocks.
  void Connect(const std::vector<Data>& lamps)
  {
    this->Filter->RemoveAllLuminaires();
    for (std::size_t i = 0; i < lamps.size();)
    {
      vtkSmartPointer<vtkDataObject> connected = lamps[i++];
      if (this->Below(2) == 0)
      {
        auto group = vtkSmartPointer<vtkMultiBlockDataSet>::New();
        group->SetBlock(static_cast<unsigned>(this->Below(2)), connected);
        while (i < lamps.size() && this->Below(2) == 0)
        {
          vtkNew<vtkMultiBlockDataSet> inner;
          inner->SetBlock(0, lamps[i++]);
          inner->SetBlock(1, Data::New());
          group->SetBlock(group->GetNumberOfBlocks(), inner);
        }
        connected = group;
      }
      vtkNew<vtkTrivialProducer> producer;
      producer->SetOutput(connected);
      this->Filter->AddLuminaireConnection(producer->GetOutputPort());
    }
  }

  /// Where the light of each lamp falls in the mean, and how much it is: x, y, z in m and lm.
  std::vector<std::array<double, 4>> Moments(std::size_t lamps)
  {
    std::vector<std::array<double, 4>> moments(lamps);
    vtkPolyData* map = this->Filter->GetOutput();
    for (std::size_t lamp = 0; lamp < lamps; ++lamp)
    {
      vtkDataArray* values =
        this->OutputArray(("Illuminance_Lamp " + std::to_string(lamp + 1)).c_str());
      for (vtkIdType c = 0; values && c < map->GetNumberOfCells(); ++c)
      {
        vtkIdList* corners = map->GetCell(c)->GetPointIds();
        for (int i = 0; i < 3; ++i)
        {
          const double third = Half * Half * 2.0 / 3.0; // of each of the twelve triangles
          const double flux = third * values->GetTuple1(corners->GetId(i));
          const double* point = map->GetPoint(corners->GetId(i));
          moments[lamp][0] += flux * point[0];
          moments[lamp][1] += flux * point[1];
          moments[lamp][2] += flux * point[2];
          moments[lamp][3] += flux;
        }
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        moments[lamp][static_cast<std::size_t>(axis)] /= moments[lamp][3];
      }
    }
    return moments;
  }

  void ExpectSameLight(const std::vector<Twins>& lamps)
  {
    std::vector<Data> moved, made;
    for (const Twins& twins : lamps)
    {
      moved.push_back(twins.moved);
      made.push_back(twins.made);
    }
    this->Connect(moved);
    this->Run();
    EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
    const auto found = this->Moments(lamps.size());
    this->Connect(made);
    this->Run();
    const auto expected = this->Moments(lamps.size());
    // A lamp has an eighth of the photons at least. A coordinate of the place where one falls has
    // at most the deviation of two walls, half an edge; registered at corners, it is a corner's.
    // Two independent means of these, and the flux, which is a binomial number of photons.
    const double photons = Photons / (2.0 * static_cast<double>(lamps.size()));
    const double error = Half * std::sqrt(2.0 / photons);
    for (std::size_t i = 0; i < lamps.size(); ++i)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(found[i][axis], expected[i][axis], 5.0 * error) << "lamp " << i;
      }
      EXPECT_NEAR(found[i][3] / expected[i][3], 1.0, 5.0 * std::sqrt(2.0 / photons));
    }
  }

  void ExpectOneError(const std::vector<Twins>& lamps)
  {
    std::vector<Data> damaged;
    for (const Twins& twins : lamps)
    {
      damaged.push_back(twins.moved);
    }
    Data& chosen = damaged[static_cast<std::size_t>(this->Below(static_cast<int>(lamps.size())))];
    if (chosen->GetNumberOfPoints() > 2) // any two points are a line, which only grows
    {
      chosen = this->Damaged(chosen);
      this->Connect(damaged);
      this->Run();
      EXPECT_EQ(this->Messages->Errors, 1) << this->Messages->Text;
      EXPECT_EQ(this->OutputArray("Illuminance"), nullptr);
    }
  }

  std::mt19937 Random;
};

} // namespace

TEST_F(FilterWiring, MovedLuminairesLightWhatTheyShow)
{
  const char* longTests = std::getenv("ILLUMINATION_LONG_TESTS");
  const unsigned number = longTests && std::string(longTests) == "1" ? 4000 : 200;
  for (unsigned i = 0; i < number && !this->HasFailure(); ++i)
  {
    SCOPED_TRACE("wiring " + std::to_string(i));
    this->Random.seed(i);
    std::vector<Twins> lamps(static_cast<std::size_t>(1 + this->Below(4)));
    for (Twins& twins : lamps)
    {
      twins = this->Draw();
    }
    this->ExpectSameLight(lamps);
    this->ExpectOneError(lamps);
  }
  this->Measured(std::to_string(number) +
    " wirings light as lamps made in place do, and are refused "
    "once one lamp is damaged");
}
