// SPDX-License-Identifier: BSD-3-Clause
#include "RoomMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace
{

using Step = std::array<int, 3>;

/// A box of Steps cells along each edge; its points are numbered as they are met.
class BoxBuilder
{
public:
  explicit BoxBuilder(Mesh& mesh)
    : Built(mesh)
  {
  }

  void AddWalls()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int side : { 0, Steps })
      {
        this->AddWall(axis, side);
      }
    }
  }

private:
  static constexpr int Steps = 4;

  vtkIdType PointAt(const Step& step)
  {
    const auto [place, isNew] =
      this->Known.emplace(step, static_cast<vtkIdType>(this->Built.points.size()));
    if (isNew)
    {
      const auto coordinate = [&](std::size_t i) { return 2.0 * step[i] / Steps - 1.0; };
      this->Built.points.push_back({ 2.0 * coordinate(0), 1.5 * coordinate(1), coordinate(2) });
    }
    return place->second;
  }

  void AddWall(int axis, int side)
  {
    const auto at = [&](int i, int j)
    {
      Step step{};
      step[static_cast<std::size_t>(axis)] = side;
      step[static_cast<std::size_t>((axis + 1) % 3)] = i;
      step[static_cast<std::size_t>((axis + 2) % 3)] = j;
      return this->PointAt(step);
    };
    for (int i = 0; i < Steps; ++i)
    {
      for (int j = 0; j < Steps; ++j)
      {
        // Counter-clockwise as seen from inside.
        std::vector<vtkIdType> square = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
        if (side != 0)
        {
          std::reverse(square.begin(), square.end());
        }
        this->AddSquare(square, (i + j) % 3 == 0);
      }
      this->Built.rows.push_back({ at(i, 0), at(i, 1), at(i, Steps) });
      this->Built.rows.push_back({ at(0, i), at(2, i), at(3, i), at(Steps, i) });
    }
  }

  void AddSquare(const std::vector<vtkIdType>& c, bool whole)
  {
    const double reflectance = 0.1 * static_cast<double>(c[0] % 7);
    if (whole)
    {
      this->Built.polygons.push_back({ c, reflectance });
      return;
    }
    this->Built.polygons.push_back({ { c[0], c[1], c[2] }, reflectance });
    this->Built.polygons.push_back({ { c[0], c[2], c[3] }, reflectance });
  }

  Mesh& Built;
  std::map<Step, vtkIdType> Known;
};

/// A rotation of a point, by random angles about x, y and z one after the other.
class Rotation
{
public:
  explicit Rotation(std::mt19937& random)
  {
    for (double& angle : this->Angles)
    {
      angle = std::uniform_real_distribution<>(0.0, 6.0)(random);
    }
  }

  Point operator()(Point p) const
  {
    p = { p.x, p.y * std::cos(Angles[0]) - p.z * std::sin(Angles[0]),
      p.y * std::sin(Angles[0]) + p.z * std::cos(Angles[0]) };
    p = { p.z * std::sin(Angles[1]) + p.x * std::cos(Angles[1]), p.y,
      p.z * std::cos(Angles[1]) - p.x * std::sin(Angles[1]) };
    return { p.x * std::cos(Angles[2]) - p.y * std::sin(Angles[2]),
      p.x * std::sin(Angles[2]) + p.y * std::cos(Angles[2]), p.z };
  }

private:
  std::array<double, 3> Angles{};
};

vtkSmartPointer<vtkCellArray> CellsOf(const std::vector<Cell>& cells, vtkDoubleArray* reflectance)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const Cell& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.corners.size()), cell.corners.data());
    reflectance->InsertNextValue(cell.reflectance);
  }
  return array;
}

} // namespace

vtkSmartPointer<vtkPolyData> Mesh::Data(bool single, bool withNormals) const
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> places;
  places->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  for (const Point& p : this->points)
  {
    places->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkDoubleArray> reflectance;
  reflectance->SetName("rho");
  data->SetPoints(places);
  data->SetPolys(CellsOf(this->polygons, reflectance));
  data->SetStrips(CellsOf(this->strips, reflectance));
  data->GetCellData()->AddArray(reflectance);
  if (withNormals)
  {
    vtkNew<vtkDoubleArray> directions;
    directions->SetName("Normals");
    directions->SetNumberOfComponents(3);
    for (std::size_t p = 0; p < this->points.size(); ++p)
    {
      const Point& n = this->normals[std::min(p, this->normals.size() - 1)];
      directions->InsertNextTuple3(n.x, n.y, n.z);
    }
    data->GetPointData()->SetNormals(directions);
  }
  return data;
}

Mesh RandomRoom(unsigned seed)
{
  std::mt19937 random(seed);
  Mesh room;
  BoxBuilder(room).AddWalls();
  const Rotation turned(random);
  for (Point& point : room.points)
  {
    room.normals.push_back(turned({ -point.x / 2.0, -point.y / 1.5, -point.z })); // inwards
    point = turned(point);
  }
  std::shuffle(room.polygons.begin(), room.polygons.end(), random);
  return room;
}
