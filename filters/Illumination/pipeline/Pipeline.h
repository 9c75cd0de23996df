// SPDX-License-Identifier: BSD-3-Clause
// What the filters have in common in how they deal with the pipeline.
#ifndef Pipeline_h
#define Pipeline_h

#include <chrono>
#include <string>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

namespace Illumination
{

/// Puts a new data object of the input's type on output port 0 unless there is one of that type.
/// @return Whether there is an input.
bool MakeOutputLikeInput(vtkInformationVector** input, vtkInformationVector* output);

/// Makes the output refer to the input's data, block by block. Arrays that are added to the output
/// do not get into the input.
void PassThrough(vtkDataObject* input, vtkDataObject* output);

/// ParaView's lists of arrays send the word "None" for no array.
std::string ArrayName(const std::string& given);

/// Reports the progress of an algorithm, at most every 50 ms.
class ProgressReport
{
public:
  explicit ProgressReport(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
  }

  /// @param fraction [0, 1]. @return False if the user wants to stop.
  bool operator()(double fraction, const std::string& text);

private:
  vtkAlgorithm* Algorithm;
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};

} // namespace Illumination

#endif
