// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "OutputData.h"

#include "vtkIlluminationMap.h"
#include "vtkLuminaireSource.h"

#include "vtkNew.h"
#include "vtkReverseSense.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

/// A ball of radius 0.5 about the origin, with normals that look out.
/// @param startPhi Its top is cut off down to this angle from +z, degrees.
inline vtkSmartPointer<vtkPolyData> Ball(int resolution, double startPhi = 0.0)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->SetStartPhi(startPhi);
  sphere->Update();
  return sphere->GetOutput();
}

/// The same, seen from inside.
inline vtkSmartPointer<vtkPolyData> RoundRoom(int resolution, double startPhi = 0.0)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(Ball(resolution, startPhi));
  reverse->ReverseCellsOn();
  reverse->ReverseNormalsOn();
  reverse->Update();
  return reverse->GetOutput();
}

/// Final gathering in a surface that a point lamp lights from a place within the ball.
inline vtkSmartPointer<vtkIlluminationMap> Gathering(vtkPolyData* surface, vtkIdType photons)
{
  auto filter = vtkSmartPointer<vtkIlluminationMap>::New();
  filter->SetInputData(surface);
  filter->SetMethod(vtkIlluminationMap::FINAL_GATHERING);
  filter->SetLampType(vtkIlluminationMap::POINT);
  filter->SetLampPosition(0.1, 0.05, 0.15);
  filter->SetPhotons(photons);
  return filter;
}

inline vtkSmartPointer<vtkLuminaireSource> PointLamp(
  double x, double y, double z, double flux, const char* name)
{
  auto lamp = vtkSmartPointer<vtkLuminaireSource>::New();
  lamp->SetType(vtkLuminaireSource::POINT);
  lamp->SetPosition(x, y, z);
  lamp->SetLuminousFlux(flux);
  lamp->SetLuminaireName(name);
  return lamp;
}
