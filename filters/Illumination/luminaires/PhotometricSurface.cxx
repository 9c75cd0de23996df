// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/PhotometricSurface.h"

#include "Illumination/pipeline/FieldArrays.h"

#include "PhotonTransport/photometry/PhotometricSolid.h"

#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>
#include <vector>

namespace Illumination
{
namespace
{

using PhotonTransport::PhotometricSolid;

/// Degrees between neighbouring points. The file's angles are subdivided, so that a solid of three
/// angles looks round.
constexpr double LargestStep = 3.0;

std::vector<double> Subdivided(const std::vector<double>& angles)
{
  std::vector<double> fine{ angles.front() };
  for (std::size_t i = 1; i < angles.size(); ++i)
  {
    const double step = angles[i] - angles[i - 1];
    const int parts = static_cast<int>(std::ceil(step / LargestStep));
    for (int k = 1; k < parts; ++k)
    {
      fine.push_back(angles[i - 1] + step * k / parts);
    }
    fine.push_back(angles[i]);
  }
  return fine;
}

class Surface
{
public:
  Surface(const PhotometricSolid& solid, double size);
  void Draw();
  void Give(vtkPolyData* surface);

private:
  vtkIdType AddPoint(double polar, double azimuth, double candela);
  /// A point for each azimuth; the same one for all at a pole, where they are one direction.
  std::vector<vtkIdType> AddRing(double polar);
  void AddFacet(std::initializer_list<vtkIdType> corners);

  const PhotometricSolid& Solid;
  const double Size;
  const double Largest;
  const std::vector<double> Polar;
  const std::vector<double> Azimuth;
  const bool IsFullTurn;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Facets;
  std::vector<double> Candela;
};

Surface::Surface(const PhotometricSolid& solid, double size)
  : Solid(solid)
  , Size(size)
  , Largest(*std::max_element(solid.candela.begin(), solid.candela.end()))
  , Polar(Subdivided(solid.polar))
  , Azimuth(Subdivided(solid.azimuth))
  , IsFullTurn(solid.azimuth.back() - solid.azimuth.front() >= 360.0)
{
  this->Points->SetDataTypeToDouble();
  this->Points->InsertNextPoint(0.0, 0.0, 0.0); // stands for all dark directions
  this->Candela.push_back(0.0);
}

vtkIdType Surface::AddPoint(double polar, double azimuth, double candela)
{
  const double distance = candela / this->Largest * this->Size;
  if (!(distance > 0.0))
  {
    return 0;
  }
  const glm::dvec3 point =
    distance * PhotonTransport::PhotometricDirection(this->Solid.type, polar, azimuth);
  this->Candela.push_back(candela);
  return this->Points->InsertNextPoint(point.x, point.y, point.z);
}

std::vector<vtkIdType> Surface::AddRing(double polar)
{
  std::vector<double> candela;
  double sum = 0.0;
  for (const double azimuth : this->Azimuth)
  {
    // A full turn leads to the first plane, of which the last one is a copy.
    candela.push_back(PhotonTransport::Intensity(this->Solid, polar, azimuth));
    sum += candela.back();
  }
  std::vector<vtkIdType> ring;
  const bool isPole = polar == 0.0 || polar == 180.0;
  const double mean = sum / static_cast<double>(candela.size());
  for (std::size_t i = 0; i < candela.size(); ++i)
  {
    const bool isFirst = i == 0 || (!isPole && (i + 1 < candela.size() || !this->IsFullTurn));
    ring.push_back(
      isFirst ? this->AddPoint(polar, this->Azimuth[i], isPole ? mean : candela[i]) : ring.front());
  }
  return ring;
}

void Surface::AddFacet(std::initializer_list<vtkIdType> corners)
{
  std::vector<vtkIdType> loop;
  for (const vtkIdType corner : corners)
  {
    if (loop.empty() || corner != loop.back())
    {
      loop.push_back(corner);
    }
  }
  while (loop.size() > 1 && loop.front() == loop.back())
  {
    loop.pop_back();
  }
  // A facet with two corners at the origin is folded flat and not needed: its neighbours meet
  // there.
  if (loop.size() < 3 || std::set<vtkIdType>(loop.begin(), loop.end()).size() < loop.size())
  {
    return;
  }
  if (this->Solid.type != PhotometricSolid::Type::B)
  {
    // The pole, azimuth 0 and azimuth 90 are a left-handed frame for C and A, right-handed for B.
    std::reverse(loop.begin(), loop.end());
  }
  this->Facets->InsertNextCell(static_cast<vtkIdType>(loop.size()), loop.data());
}

void Surface::Draw()
{
  std::vector<vtkIdType> last;
  for (const double polar : this->Polar)
  {
    const std::vector<vtkIdType> ring = this->AddRing(polar);
    const bool isFirst = last.empty();
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    {
      if (isFirst)
      {
        this->AddFacet({ 0, ring[i], ring[i + 1] });
      }
      else
      {
        this->AddFacet({ last[i], ring[i], ring[i + 1], last[i + 1] });
      }
    }
    if (!isFirst && !this->IsFullTurn)
    {
      this->AddFacet({ 0, ring.front(), last.front() });
      this->AddFacet({ 0, last.back(), ring.back() });
    }
    last = ring;
  }
  for (std::size_t i = 0; i + 1 < last.size(); ++i)
  {
    this->AddFacet({ 0, last[i + 1], last[i] });
  }
}

void Surface::Give(vtkPolyData* surface)
{
  surface->SetPoints(this->Points);
  surface->SetPolys(this->Facets);
  AddArray(surface->GetPointData(), "LuminousIntensity", this->Candela);
  surface->GetPointData()->SetActiveScalars("LuminousIntensity");
}

} // namespace

void DrawPhotometricSolid(const PhotometricSolid& solid, double size, vtkPolyData* surface)
{
  Surface drawing(solid, size);
  drawing.Draw();
  drawing.Give(surface);
}

} // namespace Illumination
