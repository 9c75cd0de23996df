// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaterialPresets_h
#define MaterialPresets_h

#include "PhotonTransport/materials/Material.h"

/// The material of a preset. @param preset One of vtkSurfaceMaterial::Presets, but not CUSTOM.
PhotonTransport::Material PresetMaterial(int preset);

#endif
