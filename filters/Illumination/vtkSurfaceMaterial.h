// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceMaterial
 * @brief   gives surfaces a material that vtkIlluminationMap understands
 *
 * Writes the material into cell arrays: for all cells, for the chosen blocks of a composite data
 * set, or for the cells where a cell array has a certain value. Several of these filters, one after
 * the other, give each part of a scene its own material. Cells that are not chosen keep the
 * material they have. If their block lacks one of the arrays, they get its value for a matt grey of
 * reflectance 0.5, so that every surface of the output has all arrays.
 *
 * Reflectances and transmittances are shares of the light that arrives, the same on both sides of
 * the surface, linear in the red, green and blue of ITU-R BT.709 (sRGB's primaries, without its
 * gamma), each in [0, 1] and together at most 1 in each channel; what is left is absorbed.
 *
 * The output is the input, untouched, with these cell arrays of type float, added or replaced:
 *  - DiffuseReflectance, SpecularReflectance, GlossyReflectance, DiffuseTransmittance and
 *    ClearTransmittance, always with 3 components. An input with 1 component is grey.
 *  - Roughness, RefractiveIndex and SolidBody, with 1.
 *  - Opening, with 1, if cells are marked or the input has it: 1 for an opening, 0 for none, -1
 *    where the mesh is to tell, as in cells that no filter has marked.
 *
 * Bad input or settings give one error that names the array, the cell and the value, and the input
 * passes through without new arrays.
 */

#ifndef vtkSurfaceMaterial_h
#define vtkSurfaceMaterial_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <set>    // for block numbers
#include <string> // for array names

class VTKILLUMINATION_EXPORT vtkSurfaceMaterial : public vtkSurfaceAlgorithm
{
public:
  static vtkSurfaceMaterial* New();
  vtkTypeMacro(vtkSurfaceMaterial, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// MaterialPresets.cxx says where the values come from.
  enum Presets
  {
    CUSTOM = 0,       ///< The values of the properties below, which no other preset uses.
    WHITE_PAINT = 1,  ///< Matt, 0.85.
    MID_GREY = 2,     ///< Matt, 0.5.
    PLASTER = 3,      ///< Gypsum, matt, 0.75.
    CONCRETE = 4,     ///< Untreated, matt, 0.25.
    WOOD = 5,         ///< Oak, matt, (0.50, 0.32, 0.20): 0.35 of white light.
    FABRIC = 6,       ///< Curtain or lamp shade: reflects 0.5 and lets 0.4 through, both diffusely.
    BLACK_PAINT = 7,  ///< Matt, 0.05.
    ALUMINIUM = 8,    ///< Brushed reflector, glossy, 0.85, roughness 0.33.
    MIRROR = 9,       ///< Specular, 0.9.
    CLEAR_GLASS = 10, ///< Pane of 6 mm float glass: index 1.52; 0.88 pass at right angles.
    FROSTED_GLASS = 11, ///< Pane that lets 0.81 through and reflects 0.15, both diffusely.
    OPENING = 12        ///< Lets all light through, and is marked as an opening.
  };

  ///@{
  /**
   * A ready material, see Presets. Default: CUSTOM.
   */
  vtkSetClampMacro(Preset, int, CUSTOM, OPENING);
  vtkGetMacro(Preset, int);
  ///@}

  ///@{
  /**
   * Share of the light that is reflected by Lambert's law, red, green and blue, [0, 1]. Default:
   * 0.5 each.
   */
  vtkSetVector3Macro(DiffuseReflectance, double);
  vtkGetVector3Macro(DiffuseReflectance, double);
  ///@}

  ///@{
  /**
   * Share of the light that is reflected as by a mirror, red, green and blue, [0, 1]. Default: 0
   * each.
   */
  vtkSetVector3Macro(SpecularReflectance, double);
  vtkGetVector3Macro(SpecularReflectance, double);
  ///@}

  ///@{
  /**
   * Share of the light that is reflected about the mirror direction, spread by Roughness, red,
   * green and blue, [0, 1]. Default: 0 each.
   */
  vtkSetVector3Macro(GlossyReflectance, double);
  vtkGetVector3Macro(GlossyReflectance, double);
  ///@}

  ///@{
  /**
   * Roughness of glossy reflection, (0, 1]. Its square is alpha of the GGX distribution. Default:
   * 0.3.
   */
  vtkSetMacro(Roughness, double);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{
  /**
   * Share of the light that leaves on the other side by Lambert's law, red, green and blue, [0, 1].
   * Default: 0 each.
   */
  vtkSetVector3Macro(DiffuseTransmittance, double);
  vtkGetVector3Macro(DiffuseTransmittance, double);
  ///@}

  ///@{
  /**
   * Share of the light that passes as through clear glass, red, green and blue, [0, 1]: what would
   * pass at right angles if nothing were reflected. The reflection by RefractiveIndex lessens it.
   * Default: 0 each.
   */
  vtkSetVector3Macro(ClearTransmittance, double);
  vtkGetVector3Macro(ClearTransmittance, double);
  ///@}

  ///@{
  /**
   * Refractive index of clear material relative to its surroundings, [1, 4]; with 1 nothing is
   * reflected. It has no effect where ClearTransmittance is 0 in all three. Default: 1.5, as of
   * glass and clear plastics.
   */
  vtkSetMacro(RefractiveIndex, double);
  vtkGetMacro(RefractiveIndex, double);
  ///@}

  ///@{
  /**
   * Whether clear material is the surface of a body that bends light; its outside is the side of
   * the normals. Otherwise it is a thin pane with both its faces, which does not bend light.
   * Default: off.
   */
  vtkSetMacro(SolidBody, bool);
  vtkGetMacro(SolidBody, bool);
  vtkBooleanMacro(SolidBody, bool);
  ///@}

  /// The values of the cell array Opening.
  enum Openings
  {
    AS_FOUND = -1,  ///< The mesh tells.
    NO_OPENING = 0, ///< It is none, nor is a hole beside it or around it.
    IS_OPENING = 1  ///< It is one.
  };

  ///@{
  /**
   * Whether the cells are an opening through which outdoor light enters, such as a window, see
   * Openings; whichever the preset, but for OPENING, which is one. Without a mark, holes of the
   * mesh with a flat border are openings, and panes (ClearTransmittance above 0, no SolidBody),
   * where the sky is seen from one side more than from the other. A mark lets no light through: an
   * opening needs ClearTransmittance. Default: AS_FOUND.
   */
  vtkSetClampMacro(Opening, int, AS_FOUND, IS_OPENING);
  vtkGetMacro(Opening, int);
  ///@}

  ///@{
  /**
   * Flat indices of the blocks of a composite data set that get the material, each with all blocks
   * below it. If none is added, every block gets it. Each index must exist, and at least one of the
   * chosen blocks must be a surface. They are not used for a single surface. Default: none.
   */
  void AddBlock(int flatIndex);
  void RemoveAllBlocks();
  int GetNumberOfBlocks() const { return static_cast<int>(this->Blocks.size()); }
  bool HasBlock(int flatIndex) const { return this->Blocks.count(flatIndex) != 0; }
  ///@}

  ///@{
  /**
   * Name of a cell array with one component, which all chosen blocks must have: only their cells in
   * which it has the value CellValue get the material. Empty or "None": all cells. Default: empty.
   */
  vtkSetStdStringFromCharMacro(CellArray);
  vtkGetCharFromStdStringMacro(CellArray);
  ///@}

  ///@{
  /**
   * The exact value of CellArray in the cells that get the material; at least one cell must have
   * it. Default: 0.
   */
  vtkSetMacro(CellValue, double);
  vtkGetMacro(CellValue, double);
  ///@}

protected:
  vtkSurfaceMaterial() = default;
  ~vtkSurfaceMaterial() override = default;

  void Execute(
    vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  RankWork WorkOnRanks() const override { return RankWork::Alone; }

  int Preset = CUSTOM;
  double DiffuseReflectance[3] = { 0.5, 0.5, 0.5 };
  double SpecularReflectance[3] = { 0.0, 0.0, 0.0 };
  double GlossyReflectance[3] = { 0.0, 0.0, 0.0 };
  double Roughness = 0.3;
  double DiffuseTransmittance[3] = { 0.0, 0.0, 0.0 };
  double ClearTransmittance[3] = { 0.0, 0.0, 0.0 };
  double RefractiveIndex = 1.5;
  bool SolidBody = false;
  int Opening = AS_FOUND;
  std::set<int> Blocks;
  std::string CellArray;
  double CellValue = 0.0;

private:
  vtkSurfaceMaterial(const vtkSurfaceMaterial&) = delete;
  void operator=(const vtkSurfaceMaterial&) = delete;
};

#endif
