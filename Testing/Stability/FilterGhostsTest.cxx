// SPDX-License-Identifier: BSD-3-Clause
// Pieces of a surface with copies of each other's cells, and cells that are hidden: light falls as
// if neither were there, and every copy of a point reads what its owner does.
#include "FilterTools.h"

#include "vtkIlluminationMapSmoothing.h"
#include "vtkSurfaceMaterial.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace
{

constexpr int Duplicate = vtkDataSetAttributes::DUPLICATECELL;
constexpr int Hidden = vtkDataSetAttributes::HIDDENCELL;
constexpr int Refined = vtkDataSetAttributes::REFINEDCELL;
constexpr double CellsPerUnit = 10.0;

/// A strip of squares over x in [first, last] tenths and y in [0, 1]; what is not in
/// [ownFirst, ownLast] belongs to another piece.
struct Piece
{
  int first, last, ownFirst, ownLast;
};

vtkSmartPointer<vtkUnsignedCharArray> Flags(vtkIdType count)
{
  auto flags = vtkSmartPointer<vtkUnsignedCharArray>::New();
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  flags->SetNumberOfTuples(count);
  flags->Fill(0);
  return flags;
}

/// Whether a piece has its ghosts, and its normals.
struct Kind
{
  bool ghosts = true;
  bool normals = true;
  double height = 0.0; ///< It is folded upwards with this slope beyond x = 1.
};

vtkSmartPointer<vtkPolyData> Strip(const Piece& piece, const Kind& kind)
{
  const int first = kind.ghosts ? piece.first : piece.ownFirst;
  const int last = kind.ghosts ? piece.last : piece.ownLast;
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  for (int i = first; i <= last; ++i)
  {
    for (int j = 0; j <= 10; ++j)
    {
      points->InsertNextPoint(
        i / CellsPerUnit, j / CellsPerUnit, kind.height * std::max(0, i - 10) / CellsPerUnit);
      normals->InsertNextTuple3(0.0, 0.0, 1.0);
    }
  }
  vtkNew<vtkCellArray> squares;
  const vtkSmartPointer<vtkUnsignedCharArray> flags = Flags(10 * (last - first));
  for (int i = first; i < last; ++i)
  {
    for (int j = 0; j < 10; ++j)
    {
      const vtkIdType a = 11 * (i - first) + j;
      const vtkIdType square[] = { a, a + 11, a + 12, a + 1 };
      const bool own = i >= piece.ownFirst && i < piece.ownLast;
      flags->SetValue(
        squares->InsertNextCell(4, square), static_cast<unsigned char>(own ? 0 : Duplicate));
    }
  }
  data->SetPoints(points);
  data->SetPolys(squares);
  if (kind.normals)
  {
    data->GetPointData()->SetNormals(normals);
  }
  if (kind.ghosts)
  {
    data->GetCellData()->AddArray(flags);
  }
  return data;
}

class FilterGhosts : public FilterTest
{
protected:
  FilterGhosts()
    : FilterTest("ghost cells: the light of a cell that another block owns, the shadow of a hidden")
  {
  }

  void SetUp() override
  {
    this->FilterTest::SetUp();
    this->Filter->SetReflectance(0.0);
    this->Filter->SetPhotons(16384);
  }

  /// The map of both pieces; Illuminance must be everywhere.
  vtkSmartPointer<vtkMultiBlockDataSet> MapOf(vtkPolyData* a, vtkPolyData* b)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, a);
    blocks->SetBlock(1, b);
    this->Filter->SetInputData(blocks);
    this->Run();
    EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
    auto map = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    map->ShallowCopy(this->Filter->GetOutputDataObject(0));
    return map;
  }

  static vtkPolyData* Block(vtkMultiBlockDataSet* blocks, unsigned block)
  {
    return vtkPolyData::SafeDownCast(blocks->GetBlock(block));
  }

  /// The values of a piece's points by place in tenths, x * 100 + y.
  static std::map<long, double> ByPlace(vtkPolyData* data, const char* name)
  {
    std::map<long, double> values;
    vtkDataArray* array = data->GetPointData()->GetArray(name);
    EXPECT_TRUE(array) << name;
    for (vtkIdType p = 0; array && p < data->GetNumberOfPoints(); ++p)
    {
      double x[3];
      data->GetPoint(p, x);
      values[100 * std::lround(x[0] * CellsPerUnit) + std::lround(x[1] * CellsPerUnit)] =
        array->GetTuple1(p);
    }
    return values;
  }

  const Piece Left{ 0, 12, 0, 10 };
  const Piece Right{ 8, 20, 10, 20 };
};

} // namespace

TEST_F(FilterGhosts, LightFallsAsIfCopiesWereNotThereAndTheyReadTheirOwners)
{
  double sum = 0.0, points = 0.0;
  for (const bool normals : { true, false })
  {
    for (const double height : { 0.0, 0.3 })
    {
      SCOPED_TRACE(testing::Message() << normals << " " << height);
      const auto bare = this->MapOf(Strip(this->Left, { false, normals, height }),
        Strip(this->Right, { false, normals, height }));
      const auto found = this->MapOf(Strip(this->Left, { true, normals, height }),
        Strip(this->Right, { true, normals, height }));
      EXPECT_EQ(this->Notes().find("owners are not in the input"), std::string::npos)
        << this->Notes();
      for (const char* name : { "Illuminance", "StandardError", "PhotonHits" })
      {
        const std::map<long, double> left = ByPlace(Block(bare, 0), name);
        const std::map<long, double> right = ByPlace(Block(bare, 1), name);
        for (unsigned block : { 0u, 1u })
        {
          const std::map<long, double>& own = block == 0 ? left : right;
          const std::map<long, double>& other = block == 0 ? right : left;
          for (const auto& [place, value] : ByPlace(Block(found, block), name))
          {
            const auto there = own.find(place);
            EXPECT_EQ(value, there != own.end() ? there->second : other.at(place)) << place;
            sum += name == std::string("Illuminance") && height == 0.0 ? value : 0.0;
            points += name == std::string("Illuminance") && height == 0.0;
          }
        }
      }
    }
  }
  // 1000 lx fall on the plane. Each photon lands on three points, so their mean has the error of
  // all photons that meet the plane: a fifth of them, or more.
  const double mean = sum / points;
  EXPECT_NEAR(mean, 1000.0, 4.0 * 1000.0 / std::sqrt(16384.0 / 5.0));
  char text[64];
  std::snprintf(text, sizeof text, "%.0f lx on the mean for 1000", mean);
  this->Measured(text);
}

TEST_F(FilterGhosts, CopiesWithoutAnOwnerAreSaid)
{
  this->Filter->SetInputData(Strip(this->Left, {}));
  this->ExpectMap();
  const std::map<long, double> map = ByPlace(this->Filter->GetOutput(), "Illuminance");
  for (const auto& [place, value] : map)
  {
    EXPECT_EQ(value > 0.0, place < 1100) << place; // owned up to x = 1
  }
  EXPECT_NE(this->Notes().find("22 points, the first being point 121, belong to duplicate cells"),
    std::string::npos)
    << this->Notes();
}

TEST_F(FilterGhosts, MarkedPointsGetTheirOwnersValueWithoutGhostCells)
{
  for (const int array : { 0, 1 }) // the owner's place, and beside it a sheet that faces away
  {
    auto left = Strip(this->Left, { false, true, 0.0 });
    auto right = Strip(this->Right, { false, true, 0.0 });
    const vtkSmartPointer<vtkUnsignedCharArray> marked = Flags(right->GetNumberOfPoints());
    for (vtkIdType p = 0; p < 11; ++p)
    {
      marked->SetValue(p, vtkDataSetAttributes::DUPLICATEPOINT);
    }
    right->GetPointData()->AddArray(marked);
    if (array == 1)
    {
      left->GetPointData()->GetNormals()->FillComponent(2, -1.0);
    }
    const auto map = this->MapOf(left, right);
    const std::map<long, double> owners = ByPlace(Block(map, 0), "Illuminance");
    for (const auto& [place, value] : ByPlace(Block(map, 1), "Illuminance"))
    {
      EXPECT_GT(value, 0.0); // it has cells of its own, whoever owns it
      if (place <= 1010 && array == 0)
      {
        EXPECT_EQ(value, owners.at(place));
      }
    }
    EXPECT_EQ(this->Notes().find("owners"), std::string::npos) << this->Notes();
  }
}

TEST_F(FilterGhosts, ACopyAtASharpEdgeFindsItsOwnSide)
{
  // A floor and a wall that rises from it at 45 degrees, their points apart; then copies of each.
  const auto sheet = [&](bool wall, bool copies)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    for (const double x : { 0.0, wall ? 1.0 : -1.0 })
    {
      for (const double y : { 0.0, 1.0 })
      {
        points->InsertNextPoint(x, y, wall ? x : 0.0);
        normals->InsertNextTuple3(wall ? -1.0 : 0.0, 0.0, 1.0);
      }
    }
    vtkNew<vtkCellArray> square;
    square->InsertNextCell({ 0, 1, 3, 2 });
    data->SetPoints(points);
    data->SetPolys(square);
    data->GetPointData()->SetNormals(normals);
    if (copies)
    {
      const vtkSmartPointer<vtkUnsignedCharArray> flags = Flags(1);
      flags->SetValue(0, Duplicate);
      data->GetCellData()->AddArray(flags);
    }
    return data;
  };
  vtkNew<vtkMultiBlockDataSet> blocks;
  const bool walls[] = { false, true, false, true };
  for (unsigned i = 0; i < 4; ++i)
  {
    blocks->SetBlock(i, sheet(walls[i], i >= 2));
  }
  const auto read = [&]()
  {
    this->Filter->SetInputData(blocks);
    this->Run();
    EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
    auto* map = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
    std::vector<double> values;
    for (unsigned i = 0; i < map->GetNumberOfBlocks(); ++i)
    {
      vtkPolyData* block = Block(map, i);
      for (vtkIdType p = 0; block && p < 4; ++p)
      {
        values.push_back(block->GetPointData()->GetArray("Illuminance")->GetTuple1(p));
      }
    }
    return values;
  };
  const std::vector<double> all = read();
  ASSERT_EQ(all.size(), 16u);
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_GT(all[i], 0.0);
    EXPECT_EQ(all[i], all[i + 8]) << i;
  }
  blocks->SetBlock(0, nullptr); // the floor's copy is left with the wall at the edge
  const std::vector<double> without = read();
  ASSERT_EQ(without.size(), 12u);
  EXPECT_EQ(
    std::vector<double>(without.begin() + 4, without.begin() + 8), std::vector<double>(4, 0.0));
  EXPECT_NE(this->Notes().find("4 points, the first being point 0 of block 3, belong to duplicate"),
    std::string::npos)
    << this->Notes();
}

TEST_F(FilterGhosts, HiddenAndRefinedCellsShadeNothing)
{
  for (const int flag : { Duplicate, Hidden, Refined, Hidden | Duplicate })
  {
    SCOPED_TRACE(flag);
    auto roof = Strip({ 0, 10, 0, 10 }, { false, true, 0.0 });
    for (vtkIdType p = 0; p < roof->GetNumberOfPoints(); ++p)
    {
      double x[3];
      roof->GetPoint(p, x);
      roof->GetPoints()->SetPoint(p, x[0], x[1], 1.0);
    }
    const vtkSmartPointer<vtkUnsignedCharArray> flags = Flags(roof->GetNumberOfCells());
    flags->Fill(static_cast<unsigned char>(flag));
    roof->GetCellData()->AddArray(flags);
    roof->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0); // no matter what a ghost holds
    const auto map = this->MapOf(roof, Strip({ 0, 10, 0, 10 }, { false, true, 0.0 }));
    this->Filter->SetInputData(Strip({ 0, 10, 0, 10 }, { false, true, 0.0 }));
    const std::string notes = this->Notes();
    this->ExpectMap();
    EXPECT_EQ(
      ByPlace(Block(map, 1), "Illuminance"), ByPlace(this->Filter->GetOutput(), "Illuminance"));
    vtkDataArray* unlit = Block(map, 0)->GetPointData()->GetArray("Illuminance");
    ASSERT_TRUE(unlit);
    EXPECT_EQ(unlit->GetRange()[1], 0.0);
    EXPECT_EQ(notes.find("owners") != std::string::npos, flag == Duplicate) << notes;
    this->Filter->SetInputData(roof);
    this->ExpectError("vtkGhostType marks 100 cells");
  }
}

TEST_F(FilterGhosts, FlagsThatDoNotFitAreRefused)
{
  auto strip = Strip(this->Left, {});
  strip->GetCellData()->AddArray(Flags(7));
  this->Filter->SetInputData(strip);
  this->ExpectError("cell array 'vtkGhostType' has 7 values for 120 cells");
  strip = Strip(this->Left, {});
  strip->GetPointData()->AddArray(Flags(7));
  this->Filter->SetInputData(strip);
  this->ExpectError("point array 'vtkGhostType' has 7 values for 143 points");
}

TEST_F(FilterGhosts, NeitherValuesNorMaterialsOfGhostsMatter)
{
  auto left = Strip(this->Left, {});
  auto right = Strip(this->Right, {});
  for (vtkPolyData* piece : { left.Get(), right.Get() })
  {
    vtkNew<vtkDoubleArray> rho;
    rho->SetName("DiffuseReflectance");
    rho->SetNumberOfTuples(piece->GetNumberOfCells());
    rho->Fill(0.25);
    auto* flags = vtkUnsignedCharArray::SafeDownCast(
      piece->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
    for (vtkIdType cell = 0; cell < rho->GetNumberOfTuples(); ++cell)
    {
      if (flags->GetValue(cell) != 0)
      {
        rho->SetValue(cell, std::numeric_limits<double>::quiet_NaN());
      }
    }
    piece->GetCellData()->AddArray(rho);
  }
  this->MapOf(left, right);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, left);
  blocks->SetBlock(1, right);
  vtkNew<vtkSurfaceMaterial> material;
  material->SetInputData(blocks);
  material->AddBlock(1);
  this->Messages->Clear();
  material->Update();
  EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
}

TEST_F(FilterGhosts, SmoothingGoesAcrossOwnersOnly)
{
  this->Filter->SetGroupMeans(true);
  this->Filter->SetSampling(vtkIlluminationMap::RANDOM);
  const auto smoothed = [&](bool ghosts)
  {
    vtkNew<vtkIlluminationMapSmoothing> smoothing;
    smoothing->SetInputData(this->MapOf(
      Strip(this->Left, { ghosts, true, 0.0 }), Strip(this->Right, { ghosts, true, 0.0 })));
    smoothing->Update();
    auto map = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    map->ShallowCopy(smoothing->GetOutputDataObject(0));
    return map;
  };
  const auto bare = smoothed(false);
  const auto found = smoothed(true);
  const std::map<long, double> left = ByPlace(Block(bare, 0), "IlluminanceSmoothed");
  const std::map<long, double> right = ByPlace(Block(bare, 1), "IlluminanceSmoothed");
  for (unsigned block : { 0u, 1u })
  {
    const std::map<long, double>& own = block == 0 ? left : right;
    const std::map<long, double>& other = block == 0 ? right : left;
    for (const auto& [place, value] : ByPlace(Block(found, block), "IlluminanceSmoothed"))
    {
      const auto there = own.find(place);
      const double expected = there != own.end() ? there->second : other.at(place);
      EXPECT_NEAR(value, expected, 1e-5 * expected) << place; // kernels are in single precision
    }
  }
}
