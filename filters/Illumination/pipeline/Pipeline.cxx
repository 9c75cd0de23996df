// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/pipeline/Pipeline.h"

#include "Illumination/pipeline/VtkVersion.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

namespace Illumination
{

bool MakeOutputLikeInput(vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataObject* in = vtkDataObject::GetData(input[0]);
  vtkDataObject* out = vtkDataObject::GetData(output);
  if (in && (!out || out->GetDataObjectType() != in->GetDataObjectType()))
  {
    auto fresh = vtk::TakeSmartPointer(in->NewInstance());
    output->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
  return in != nullptr;
}

void PassThrough(vtkDataObject* input, vtkDataObject* output)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    output->ShallowCopy(input);
    return;
  }
  auto* result = vtkCompositeDataSet::SafeDownCast(output);
  result->CopyStructure(composite);
  result->GetFieldData()->PassData(composite->GetFieldData());
  auto it = vtk::TakeSmartPointer(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto block = vtk::TakeSmartPointer(it->GetCurrentDataObject()->NewInstance());
    block->ShallowCopy(it->GetCurrentDataObject());
    result->SetDataSet(it, block);
  }
}

std::string ArrayName(const std::string& given)
{
  return given == "None" ? "" : given;
}

bool ProgressReport::operator()(double fraction, const std::string& text)
{
  const auto now = std::chrono::steady_clock::now();
  if (now - this->Last >= std::chrono::milliseconds(50))
  {
    this->Last = now;
    this->Algorithm->SetProgressText(text.c_str());
    this->Algorithm->UpdateProgress(fraction);
  }
  return !AbortRequested(this->Algorithm);
}

} // namespace Illumination
