// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFile.h"

#include <map>
#include <stdexcept>

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
  std::map<float, std::uint32_t> materials;
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    mesh->GetPolys()->GetCellAtId(f, corners);
    surface.facets.emplace_back(corners->GetId(0), corners->GetId(1), corners->GetId(2));
    const float share = reflectance ? static_cast<float>(reflectance->GetComponent(f, 0)) : 0.5f;
    const auto [known, isNew] =
      materials.emplace(share, static_cast<std::uint32_t>(materials.size()));
    if (isNew)
    {
      surface.materials.emplace_back().diffuseReflectance = PhotonTransport::Colour(share);
    }
    surface.materialOfFacet.push_back(known->second);
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
