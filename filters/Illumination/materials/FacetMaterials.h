// SPDX-License-Identifier: BSD-3-Clause
#ifndef FacetMaterials_h
#define FacetMaterials_h

#include "Illumination/surface/SceneBlock.h"
#include "Illumination/surface/SurfaceDescription.h"

#include "PhotonTransport/scene/Surface.h"

#include <vector>

namespace Illumination
{

/// Gives the facets of all blocks their materials, from cell arrays and properties. Throws
/// InputError that names array or property, cell and value.
void DescribeMaterials(const std::vector<SceneBlock>& blocks, const SurfaceDescription& description,
  PhotonTransport::Surface& surface);

} // namespace Illumination

#endif
