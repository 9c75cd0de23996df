// SPDX-License-Identifier: BSD-3-Clause
// What the filters share of their dealings with the pipeline.
#ifndef Pipeline_h
#define Pipeline_h

#include <chrono>
#include <string>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

/// Puts a new data object of the input's type on output port 0 unless it has one.
/// @return Whether there is an input.
bool MakeOutputLikeInput(vtkInformationVector** input, vtkInformationVector* output);

/// Makes the output refer to the input's data, block by block: arrays added to it stay its own.
void PassThrough(vtkDataObject* input, vtkDataObject* output);

/// ParaView's lists of arrays send the word "None" for no array.
std::string ArrayName(const std::string& given);

/// Passes progress on, but not more often than a person can see.
class ProgressReport
{
public:
  explicit ProgressReport(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
  }

  /// @param fraction [0, 1]. @return False once the user wants to stop.
  bool operator()(double fraction, const std::string& text);

private:
  vtkAlgorithm* Algorithm;
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};

#endif
