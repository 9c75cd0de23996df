// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/SolidSymmetry.h"

#include <algorithm>
#include <iterator>

namespace PhotonTransport
{

namespace
{

void AddPlane(PhotometricSolid& solid, double azimuth, std::size_t like)
{
  solid.azimuth.push_back(azimuth);
  for (std::size_t j = 0; j < solid.polar.size(); ++j)
  {
    solid.candela.push_back(solid.candela[like * solid.polar.size() + j]);
  }
}

} // namespace

void MirrorAtLastAzimuth(PhotometricSolid& solid)
{
  const double mirror = solid.azimuth.back();
  for (std::size_t i = solid.azimuth.size() - 1; i-- > 0;)
  {
    AddPlane(solid, 2.0 * mirror - solid.azimuth[i], i);
  }
}

void MirrorAtFirstAzimuth(PhotometricSolid& solid)
{
  const double mirror = solid.azimuth.front();
  std::vector<double> azimuth;
  std::vector<double> candela;
  const auto size = static_cast<std::ptrdiff_t>(solid.polar.size());
  for (std::size_t i = solid.azimuth.size(); i-- > 1;)
  {
    azimuth.push_back(2.0 * mirror - solid.azimuth[i]);
    const auto plane = solid.candela.begin() + static_cast<std::ptrdiff_t>(i) * size;
    std::copy(plane, plane + size, std::back_inserter(candela));
  }
  solid.azimuth.insert(solid.azimuth.begin(), azimuth.begin(), azimuth.end());
  solid.candela.insert(solid.candela.begin(), candela.begin(), candela.end());
}

void MirrorAtEquator(PhotometricSolid& solid)
{
  const std::size_t size = solid.polar.size();
  std::vector<double> candela;
  for (std::size_t i = 0; i < solid.azimuth.size(); ++i)
  {
    const auto plane = solid.candela.begin() + static_cast<std::ptrdiff_t>(i * size);
    const auto equator = plane + static_cast<std::ptrdiff_t>(size);
    std::copy(plane, equator, std::back_inserter(candela));
    std::reverse_copy(plane, equator - 1, std::back_inserter(candela));
  }
  solid.candela = std::move(candela);
  for (std::size_t j = size - 1; j-- > 0;)
  {
    solid.polar.push_back(180.0 - solid.polar[j]);
  }
}

void CloseCircle(PhotometricSolid& solid)
{
  if (solid.azimuth.back() - solid.azimuth.front() < 360.0)
  {
    AddPlane(solid, solid.azimuth.front() + 360.0, 0);
  }
}

bool GapIsOneStep(const std::vector<double>& azimuth)
{
  double widest = 0.0;
  for (std::size_t i = 0; i + 1 < azimuth.size(); ++i)
  {
    widest = std::max(widest, azimuth[i + 1] - azimuth[i]);
  }
  // Steps such as 22.857 do not fill the circle to the last digit.
  constexpr double rounding = 0.01;
  return azimuth.front() + 360.0 - azimuth.back() <= widest * (1.0 + rounding);
}

} // namespace PhotonTransport
