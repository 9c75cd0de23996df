// SPDX-License-Identifier: BSD-3-Clause
#ifndef PhotometricSurface_h
#define PhotometricSurface_h

namespace PhotonTransport
{
struct PhotometricSolid;
}
class vtkPolyData;

/// Draws a solid as a closed surface whose facets look outwards: in every direction a point at a
/// distance in proportion to the intensity, with point array LuminousIntensity (cd). Where the
/// angles end, the surface goes on to the origin; all dark directions are that one point.
/// @param size Distance of the largest intensity.
void DrawPhotometricSolid(
  const PhotonTransport::PhotometricSolid& solid, double size, vtkPolyData* surface);

#endif
