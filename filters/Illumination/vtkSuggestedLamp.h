// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSuggestedLamp
 * @brief   a lamp that lights a surface of which nothing else is known
 *
 * ParaView's window sets the lamp of a new vtkIlluminationMap by it, so that the first map of any
 * surface shows light. In a room, whose normals point inward, it is a point below the ceiling, by
 * 15 % of the height there. Around a body and above open surfaces it is parallel light: from +z,
 * or, where that would meet mostly backs, onto the side to which most normals point. Up is +z.
 *
 * The input is a vtkPolyData, or a composite data set of them. The output is empty. Read the lamp
 * after Update(). For input without triangles, or with bad cells, it is that of a new
 * vtkIlluminationMap.
 */

#ifndef vtkSuggestedLamp_h
#define vtkSuggestedLamp_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKILLUMINATION_EXPORT vtkSuggestedLamp : public vtkPolyDataAlgorithm
{
public:
  static vtkSuggestedLamp* New();
  vtkTypeMacro(vtkSuggestedLamp, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * vtkIlluminationMap::LampType: PARALLEL or POINT.
   */
  vtkGetMacro(LampType, int);

  /**
   * Where the point is, data's length. With parallel light, a place off the surface on its lit
   * side, for lamps of other types.
   */
  vtkGetVector3Macro(LampPosition, double);

  /**
   * In which the light travels, a unit vector.
   */
  vtkGetVector3Macro(LampDirection, double);

  /**
   * Size of a lamp that suits the surface, data's length: 5 % of the diagonal of its bounds.
   */
  vtkGetMacro(LampSize, double);

protected:
  vtkSuggestedLamp() = default;
  ~vtkSuggestedLamp() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int LampType = 0;
  double LampPosition[3] = { 0.0, 0.0, 1.0 };
  double LampDirection[3] = { 0.0, 0.0, -1.0 };
  double LampSize = 1.0;

private:
  vtkSuggestedLamp(const vtkSuggestedLamp&) = delete;
  void operator=(const vtkSuggestedLamp&) = delete;
};

#endif
