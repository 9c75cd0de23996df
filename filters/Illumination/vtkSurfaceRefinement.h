// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceRefinement
 * @brief   divides the facets of a surface along the curved surface that its normals tell of
 *
 * Each edge of the surface is taken for a curve that is normal to the point normals at its ends: a
 * parabola, exact at the middle of circular arcs (T. Nagata, "Simple local interpolation of
 * surfaces using normal vectors", Computer Aided Geometric Design 22, 2005). Edges are halved until
 * they keep to the limits below, and the facets with them, by red-green subdivision. Where nothing
 * is curved or too long, facets stay whole. An edge is divided alike for all its facets, whether
 * they share points or only places, in one block or in several. So no gap opens that was not there.
 * An edge on which another facet has a corner (a T-junction) stays straight. So do the edges of
 * facets that noisy normals would turn over.
 *
 * The input is one vtkPolyData or a composite data set, whose blocks are refined as one surface.
 * Polygons and strips come out as triangles. Vertices and lines pass through, and so do cells
 * that are hidden or replaced by finer ones (vtkGhostType) and facets without area. Duplicates of
 * other blocks' cells are divided as those are. Where a block has no point normals they are
 * computed, as vtkIlluminationMap does: points at edges sharper than FeatureAngle are split.
 *
 * The output has the input's points first, unmoved, then copies of points that were split, then new
 * ones, in double precision if any block has it, with these arrays:
 *  - Point arrays of numbers with a fraction, and colours of 8 bits, interpolated linearly between
 *    the corners of the facet. Normals then get unit length. Whole numbers and text are those of
 *    the nearest corner. New points have the ghost flags that all corners have, and are duplicates
 *    if only duplicate cells use them.
 *  - Normals, where they were computed.
 *  - OriginalPointIds: the point of the input, or -1 for a new one.
 *  - Cell arrays, copied to each part of a cell.
 *  - OriginalCellIds: the cell of the input.
 * Global ids are left out.
 *
 * Bad input or settings give one error that names the array, the cell and the value, and the input
 * passes through.
 */

#ifndef vtkSurfaceRefinement_h
#define vtkSurfaceRefinement_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkSmartPointer.h"       // for Refine
#include "vtkSurfaceAlgorithm.h"

#include <vector> // for Refine

class vtkPolyData;

namespace Illumination
{
class RefinementBlocks;
}

class VTKILLUMINATION_EXPORT vtkSurfaceRefinement : public vtkSurfaceAlgorithm
{
public:
  static vtkSurfaceRefinement* New();
  vtkTypeMacro(vtkSurfaceRefinement, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Angle at most by which the surface turns from end to end of a curved edge, degrees, [0, 180]; 0
   * is no limit. It needs no length and so suits data of any size. An arc's middle is then within
   * 1 - cos(MaximumTurn / 2) of its radius, 0.19 % by default. Default: 7.
   */
  vtkSetMacro(MaximumTurn, double);
  vtkGetMacro(MaximumTurn, double);
  ///@}

  ///@{
  /**
   * Distance at most between the middle of an edge and the curve it stands for, data's length,
   * >= 0; 0 is no limit. Default: 0.
   */
  vtkSetMacro(CurvatureTolerance, double);
  vtkGetMacro(CurvatureTolerance, double);
  ///@}

  ///@{
  /**
   * Length of an edge at most, data's length, >= 0; 0 is no limit. It also divides what is flat.
   * Default: 0.
   */
  vtkSetMacro(MaximumEdgeLength, double);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * Where the input has no point normals: edges at which facets meet at a greater angle than this
   * stay sharp, degrees, [0, 180]. Default: 30.
   */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Triangles at most, 1 to 10^9. If the limits above ask for more, they are widened, and a warning
   * tells which served. The input's own facets all stay. Default: 5 million.
   */
  vtkSetMacro(MaximumCells, int);
  vtkGetMacro(MaximumCells, int);
  ///@}

protected:
  vtkSurfaceRefinement() = default;
  ~vtkSurfaceRefinement() override = default;

  void Execute(
    vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  double MaximumTurn = 7.0;
  double CurvatureTolerance = 0.0;
  double MaximumEdgeLength = 0.0;
  double FeatureAngle = 30.0;
  int MaximumCells = 5000000;

private:
  /// Empty if it was stopped.
  std::vector<vtkSmartPointer<vtkPolyData>> Refine(const Illumination::RefinementBlocks& blocks);

  vtkSurfaceRefinement(const vtkSurfaceRefinement&) = delete;
  void operator=(const vtkSurfaceRefinement&) = delete;
};

#endif
