// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFile.h"

#include <array>
#include <fstream>
#include <map>
#include <stdexcept>

namespace
{

/// Gives facets their materials by reflectance.
class MattMaterials
{
public:
  explicit MattMaterials(PhotonTransport::Surface& surface)
    : Owner(surface)
  {
  }
  void AddFacet(float reflectance)
  {
    const auto [known, isNew] =
      this->Known.emplace(reflectance, static_cast<std::uint32_t>(this->Known.size()));
    if (isNew)
    {
      this->Owner.materials.emplace_back().diffuseReflectance =
        PhotonTransport::Colour(reflectance);
    }
    this->Owner.materialOfFacet.push_back(known->second);
  }

private:
  PhotonTransport::Surface& Owner;
  std::map<float, std::uint32_t> Known;
};

template <typename T>
std::vector<T> ReadValues(std::ifstream& file, std::uint64_t count)
{
  std::vector<T> values(count);
  file.read(
    reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(sizeof(T) * count));
  return values;
}

} // namespace

PhotonTransport::Surface ReadPlainMesh(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  const auto size = file ? static_cast<std::uint64_t>(file.tellg()) : 0;
  file.seekg(0);
  std::array<std::uint64_t, 2> counts{};
  file.read(reinterpret_cast<char*>(counts.data()), sizeof(counts));
  const auto [points, facets] = counts;
  if (!file || points > size || facets > size || size != 16 + 24 * points + 20 * facets)
  {
    throw std::runtime_error(fileName + ": no mesh; make it by cabin_mesh.py");
  }
  PhotonTransport::Surface surface;
  for (const glm::vec3& p : ReadValues<glm::vec3>(file, points))
  {
    surface.points.emplace_back(p);
  }
  for (const glm::vec3& n : ReadValues<glm::vec3>(file, points))
  {
    surface.normals.emplace_back(n);
  }
  surface.facets = ReadValues<glm::uvec3>(file, facets);
  MattMaterials materials(surface);
  for (const float reflectance : ReadValues<float>(file, facets))
  {
    materials.AddFacet(reflectance);
  }
  for (const float exitance : ReadValues<float>(file, facets))
  {
    surface.exitance.emplace_back(exitance);
  }
  surface.rounding = 0x1p-24;
  return surface;
}

#ifdef ILLUMINATION_BENCHMARKS_READ_VTP

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

PhotonTransport::Surface ReadMesh(const std::string& fileName)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(fileName.c_str());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* mesh = triangles->GetOutput();
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (mesh->GetNumberOfPolys() == 0 || !normals)
  {
    throw std::runtime_error(fileName + ": no triangles with point normals");
  }
  PhotonTransport::Surface surface;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const double* x = mesh->GetPoint(p);
    surface.points.emplace_back(x[0], x[1], x[2]);
    const double* n = normals->GetTuple(p);
    surface.normals.emplace_back(n[0], n[1], n[2]);
  }
  vtkDataArray* reflectance = mesh->GetCellData()->GetArray("Reflectance");
  vtkDataArray* exitance = mesh->GetCellData()->GetArray("Exitance");
  MattMaterials materials(surface);
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    mesh->GetPolys()->GetCellAtId(f, corners);
    surface.facets.emplace_back(corners->GetId(0), corners->GetId(1), corners->GetId(2));
    materials.AddFacet(reflectance ? static_cast<float>(reflectance->GetComponent(f, 0)) : 0.5f);
    if (exitance)
    {
      surface.exitance.emplace_back(exitance->GetComponent(f, 0));
    }
  }
  return surface;
}

#else

PhotonTransport::Surface ReadMesh(const std::string& fileName)
{
  throw std::runtime_error(fileName + ": mesh files can be read in a build with VTK only");
}

#endif
