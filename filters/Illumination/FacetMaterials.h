// SPDX-License-Identifier: BSD-3-Clause
#ifndef FacetMaterials_h
#define FacetMaterials_h

#include "SceneBlocks.h"

#include <vector>

/// Gives the facets of all blocks their materials, from cell arrays and properties. Where these
/// describe nothing but diffuse reflection without colour, the result is Surface::reflectance
/// alone. Throws InputError that names the array, the cell and the value.
void DescribeMaterials(const std::vector<SceneBlock>& blocks, const SurfaceDescription& description,
  PhotonTransport::Surface& surface);

#endif
