// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaterialPresets_h
#define MaterialPresets_h

#include "PhotonTransport/materials/Material.h"

namespace Illumination
{

/// Numbered as vtkSurfaceMaterial::Presets.
enum class MaterialPreset
{
  WhitePaint = 1,
  MidGrey,
  Plaster,
  Concrete,
  Wood,
  Fabric,
  BlackPaint,
  Aluminium,
  Mirror,
  ClearGlass,
  FrostedGlass,
  Opening
};

PhotonTransport::Material MaterialOf(MaterialPreset preset);

} // namespace Illumination

#endif
