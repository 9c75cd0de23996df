// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceAlgorithm
 * @brief   base class of the filters that work on a surface as a whole
 *
 * The input on port 0 is a vtkPolyData, or a composite data set whose vtkPolyData blocks are one
 * surface together; taking composite data itself keeps the pipeline from running a filter block by
 * block. The output on port 0 is of the same type: the input, untouched, with what the filter adds.
 *
 * Under MPI ranks may each have a part of the surface. As a rule all ranks then execute together,
 * each on the whole surface, and give their own parts what belongs there.
 *
 * An error is told once, by the first rank, and the input then passes through alone. RequestData
 * returns 1 all the same, since the executive would add an error of its own to 0.
 */

#ifndef vtkSurfaceAlgorithm_h
#define vtkSurfaceAlgorithm_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for Sharing
#include <string> // for ExecuteOnRanks

namespace Illumination
{
class ControllerRanks;
}

class VTKILLUMINATION_EXPORT vtkSurfaceAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkSurfaceAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSurfaceAlgorithm();
  ~vtkSurfaceAlgorithm() override;

  int ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /**
   * Adds to the output, which is the input passed through. What it throws is told as an error.
   *
   * With RankWork::Whole the output on port 0, and the inputs on all ports but port 0, are of all
   * ranks together, and the same on each rank; `input` is that of this rank.
   */
  virtual void Execute(
    vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;

  /**
   * Called where there is no result: after an error, or on a rank that does not work.
   */
  virtual void WithoutResult(vtkInformationVector*) {}

  /**
   * What several ranks do.
   */
  enum class RankWork
  {
    Alone,    ///< Each executes on its own part, whatever the others do.
    OwnParts, ///< Each executes on its own part. All call GetRanks() in the same order.
    Whole     ///< All execute on the whole surface and share the work.
  };
  virtual RankWork WorkOnRanks() const { return RankWork::Whole; }

  /**
   * The ranks that execute together, while they do; none with RankWork::Alone.
   */
  Illumination::ControllerRanks& GetRanks() const { return *this->Sharing; }

  /**
   * Warns once, on the first rank.
   */
  void Warn(const std::string& text);

private:
  vtkSurfaceAlgorithm(const vtkSurfaceAlgorithm&) = delete;
  void operator=(const vtkSurfaceAlgorithm&) = delete;

  /// @return Why it failed; empty if it did not.
  std::string ExecuteOnRanks(
    vtkDataObject* in, vtkInformationVector** input, vtkInformationVector* output);

  std::unique_ptr<Illumination::ControllerRanks> Sharing;
};

#endif
