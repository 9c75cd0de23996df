// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceAlgorithm.h"

#include "Illumination/luminaires/WholeLuminaires.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/ranks/WholeSurface.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

using namespace Illumination;

vtkSurfaceAlgorithm::vtkSurfaceAlgorithm() = default;
vtkSurfaceAlgorithm::~vtkSurfaceAlgorithm() = default;

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
  auto outer =
    std::move(this->Sharing); // Of an execution in which an observer has started this one.
  const std::string error = this->WorkOnRanks() == RankWork::Alone
    ? MessageOf([&] { this->Execute(in, input, output); })
    : this->ExecuteOnRanks(in, input, output);
  const bool tells = !this->Sharing || this->Sharing->Index() == 0;
  this->Sharing = std::move(outer); // Together on all ranks, and before MPI ends.
  if (error.empty())
  {
    return 1;
  }
  PassThrough(in, out); // without what was already there of the result
  this->WithoutResult(output);
  if (tells)
  {
    vtkErrorMacro(<< (error == OutOfMemory ? error + " for an input of " +
                        std::to_string(in->GetActualMemorySize()) + " KiB"
                                           : error));
  }
  return 1;
}

std::string vtkSurfaceAlgorithm::ExecuteOnRanks(
  vtkDataObject* in, vtkInformationVector** input, vtkInformationVector* output)
{
  this->Sharing = std::make_unique<ControllerRanks>();
  ControllerRanks& ranks = *this->Sharing;
  if (!ranks.AreSeveral())
  {
    return MessageOf([&] { this->Execute(in, input, output); });
  }
  if (this->WorkOnRanks() == RankWork::OwnParts)
  {
    return ranks.Together([&] { this->Execute(in, input, output); });
  }
  return ranks.Together(
    [&]
    {
      const WholeSurface whole(ranks, in);
      // Vectors of our own, since the pipeline's hold what is on this rank.
      vtkNew<vtkInformationVector> outputs;
      outputs->Copy(output, 1);
      outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), whole.Data());
      std::vector<vtkSmartPointer<vtkInformationVector>> others;
      std::vector<vtkInformationVector*> inputs{ input[0] };
      for (int port = 1; port < this->GetNumberOfInputPorts(); ++port)
      {
        others.push_back(WholeLuminaires(ranks, input[port]));
        inputs.push_back(others.back());
      }
      this->Execute(in, inputs.data(), outputs);
      whole.PutResults(vtkDataObject::GetData(output), static_cast<std::size_t>(ranks.Index()));
    });
}

void vtkSurfaceAlgorithm::Warn(const std::string& text)
{
  if (!this->Sharing || this->Sharing->Index() == 0)
  {
    vtkWarningMacro(<< text);
  }
}

void vtkSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
