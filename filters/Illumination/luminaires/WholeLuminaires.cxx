// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/WholeLuminaires.h"

#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/ranks/WholeSurface.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace Illumination
{

vtkSmartPointer<vtkInformationVector> WholeLuminaires(
  ControllerRanks& ranks, vtkInformationVector* port)
{
  auto whole = vtkSmartPointer<vtkInformationVector>::New();
  for (int i = 0; i < port->GetNumberOfInformationObjects(); ++i)
  {
    const WholeSurface data(ranks, vtkDataObject::GetData(port, i),
      [](vtkPolyData* block) { return HasLuminaireFields(block->GetFieldData()); });
    vtkNew<vtkInformation> information;
    information->Set(vtkDataObject::DATA_OBJECT(), data.Data());
    whole->Append(information);
  }
  return whole;
}

} // namespace Illumination
