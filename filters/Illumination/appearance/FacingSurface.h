// SPDX-License-Identifier: BSD-3-Clause
#ifndef FacingSurface_h
#define FacingSurface_h

#include "Illumination/appearance/CellLooks.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <vector>

namespace Illumination
{

/// A surface whose points each have one look, and whose cells wind so that their lit side is their
/// front to a renderer.
struct FacingSurface
{
  vtkSmartPointer<vtkPolyData> data;
  std::vector<vtkIdType> original;        ///< [point] That of the input; the input's come first.
  std::vector<std::uint32_t> lookOfPoint; ///< [point] Index in CellLooks::looks, or NoLook.
};

/// Of points that no polygon or strip uses.
constexpr std::uint32_t NoLook = ~std::uint32_t{ 0 };

/// Where cells of different looks share a point, all but the first get copies of it. Cells whose
/// corners run clockwise as their point normals see them are turned; without point normals none is.
/// Cells keep their numbers and arrays, and copies of points those of their originals; they get
/// OriginalPointIds if any are copied. @param block Its cells must be valid.
FacingSurface FaceSurface(const NamedSurface& block, const CellLooks& looks);

} // namespace Illumination

#endif
