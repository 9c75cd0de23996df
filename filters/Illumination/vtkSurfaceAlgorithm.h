// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceAlgorithm
 * @brief   base class of the filters that work on a surface as a whole
 *
 * The input on port 0 is a vtkPolyData, or a composite data set whose vtkPolyData blocks are one
 * surface together; taking composite data itself keeps the pipeline from running a filter block by
 * block. The output on port 0 is of the same type: the input, untouched, with what the filter adds.
 *
 * An error is told once, and the input then passes through alone. RequestData returns 1 all the
 * same, since the executive would add an error of its own to 0.
 */

#ifndef vtkSurfaceAlgorithm_h
#define vtkSurfaceAlgorithm_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKILLUMINATION_EXPORT vtkSurfaceAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkSurfaceAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSurfaceAlgorithm() = default;
  ~vtkSurfaceAlgorithm() override = default;

  int ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /**
   * Adds to the output, which is the input passed through. What it throws is told as an error.
   */
  virtual void Execute(
    vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;

  /**
   * Called where there is no result: after an error, or on a rank that does not work.
   */
  virtual void WithoutResult(vtkInformationVector*) {}

  /**
   * Whether the filter needs all of the surface: under MPI the rank that has it works, and an error
   * is told where several ranks have parts of it.
   */
  virtual bool NeedsWholeSurface() const { return true; }

private:
  vtkSurfaceAlgorithm(const vtkSurfaceAlgorithm&) = delete;
  void operator=(const vtkSurfaceAlgorithm&) = delete;
};

#endif
