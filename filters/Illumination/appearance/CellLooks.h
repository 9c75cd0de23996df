// SPDX-License-Identifier: BSD-3-Clause
// What the cells of a lit surface do with its light, as far as it is seen.
#ifndef CellLooks_h
#define CellLooks_h

#include "Illumination/surface/SurfaceParts.h"

#include "PhotonTransport/materials/Colour.h"

#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Illumination
{

/// Shares of the light that leave a cell in all directions alike, and what it shines with itself.
struct CellLook
{
  PhotonTransport::Colour reflectance{ 0.0f };   ///< Of light on the front.
  PhotonTransport::Colour transmittance{ 0.0f }; ///< Of light on the back.
  PhotonTransport::Colour exitance{ 0.0f };      ///< lm/m².

  bool Shines() const { return this->exitance != PhotonTransport::Colour(0.0f); }
};

/// Which arrays and values say how cells look.
struct LookDescription
{
  std::string reflectanceArray; ///< Cell array; where it is missing: reflectance.
  bool reflectanceArrayIsNamed; ///< By the user, so that it must be in all blocks.
  double reflectance;           ///< [0, 1].
  std::string exitanceArray;    ///< Cell array; where it is missing: nothing shines.
  bool exitanceArrayIsNamed;    ///< By the user, so that it must be in all blocks.
};

/// The looks of a block's polygons and strips.
struct CellLooks
{
  std::vector<CellLook> looks;           ///< Each once.
  std::vector<std::uint32_t> lookOfCell; ///< [cell - first] Index in looks.
  vtkIdType first;                       ///< Cell id of the first polygon or strip.
};

/// Throws InputError that names array, cell and value.
CellLooks LooksOf(const NamedSurface& block, const LookDescription& description);

} // namespace Illumination

#endif
