// SPDX-License-Identifier: BSD-3-Clause
#ifndef PhotometricSurface_h
#define PhotometricSurface_h

class vtkPolyData;

namespace PhotonTransport
{
struct PhotometricSolid;
}

namespace Illumination
{

/// Draws a solid about the origin as a closed surface whose facets look outwards. The distance of
/// the surface from the origin is in proportion to the intensity in that direction, which the point
/// array LuminousIntensity (cd) holds. Where the angles end the surface goes on to the origin; the
/// point there stands for all dark directions. @param size Distance of the largest intensity, > 0.
void DrawPhotometricSolid(
  const PhotonTransport::PhotometricSolid& solid, double size, vtkPolyData* surface);

} // namespace Illumination

#endif
