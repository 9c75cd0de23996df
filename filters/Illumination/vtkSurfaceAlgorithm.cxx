// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceAlgorithm.h"

#include "Illumination/pipeline/OneRank.h"
#include "Illumination/pipeline/Pipeline.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <new>
#include <string>

using namespace Illumination;

int vtkSurfaceAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkSurfaceAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkSurfaceAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return MakeOutputLikeInput(input, output) ? 1 : 0;
  }
  return this->Superclass::ProcessRequest(request, input, output);
}

int vtkSurfaceAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  // An observer may disconnect the input.
  const vtkSmartPointer<vtkDataObject> in = vtkDataObject::GetData(input[0]);
  vtkDataObject* out = vtkDataObject::GetData(output);
  PassThrough(in, out);
  std::string error;
  try
  {
    const RankTask task = this->NeedsWholeSurface()
      ? TaskOfThisRank(in, this->GetNumberOfInputPorts() > 1 ? input[1] : nullptr)
      : RankTask();
    if (task.Works)
    {
      this->Execute(in, input, output);
      return 1;
    }
    error = task.Message;
  }
  catch (const std::bad_alloc&)
  {
    error = "out of memory for an input of " + std::to_string(in->GetActualMemorySize()) + " KiB";
  }
  catch (const std::exception& thrown)
  {
    error = thrown.what();
  }
  PassThrough(in, out); // without what was already there of the result
  this->WithoutResult(output);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return 1;
}

void vtkSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
