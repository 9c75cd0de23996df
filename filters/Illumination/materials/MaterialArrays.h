// SPDX-License-Identifier: BSD-3-Clause
// The cell arrays that describe a surface's materials: vtkSurfaceMaterial writes them,
// vtkIlluminationMap reads them.
#ifndef MaterialArrays_h
#define MaterialArrays_h

namespace MaterialArrays
{

// 1 component, or 3 (linear RGB); see PhotonTransport::Material.
constexpr const char* DiffuseReflectance = "DiffuseReflectance";
constexpr const char* SpecularReflectance = "SpecularReflectance";
constexpr const char* GlossyReflectance = "GlossyReflectance";
constexpr const char* DiffuseTransmittance = "DiffuseTransmittance";
constexpr const char* ClearTransmittance = "ClearTransmittance";
// 1 component.
constexpr const char* Roughness = "Roughness";
constexpr const char* RefractiveIndex = "RefractiveIndex";
constexpr const char* SolidBody = "SolidBody"; ///< 0: a thin pane; 1: bends light.

} // namespace MaterialArrays

#endif
