// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/ranks/MergedArrays.h"

#include "Illumination/pipeline/InputError.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <cstring>

namespace Illumination
{
namespace
{

bool IsMerged(vtkAbstractArray* array)
{
  return array->GetName() &&
    std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) != 0;
}

} // namespace

std::string NameOf(const Piece& piece)
{
  return piece.name + " on rank " + std::to_string(piece.rank);
}

void MergedArrays::Add(std::size_t piece, vtkDataSetAttributes* arrays, const TuplePlaces& places)
{
  if (places.from.empty())
  {
    return;
  }
  if (!this->HasFirst)
  {
    this->First = piece;
    this->HasFirst = true;
    this->Begin(arrays);
  }
  vtkNew<vtkIdList> fromIds, toIds;
  for (std::size_t i = 0; i < places.from.size(); ++i)
  {
    fromIds->InsertNextId(places.from[i]);
    toIds->InsertNextId(places.to[i]);
  }
  this->RequireNoOthers(piece, arrays);
  for (int i = 0; i < this->Result->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = this->Result->GetAbstractArray(i);
    vtkAbstractArray* given = arrays->GetAbstractArray(array->GetName());
    this->RequireAlike(piece, array, given);
    array->InsertTuples(toIds, fromIds, given);
  }
}

void MergedArrays::Begin(vtkDataSetAttributes* arrays)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* given = arrays->GetAbstractArray(i);
    if (IsMerged(given))
    {
      auto array = vtk::TakeSmartPointer(given->NewInstance());
      array->SetName(given->GetName());
      array->SetNumberOfComponents(given->GetNumberOfComponents());
      array->CopyComponentNames(given);
      array->SetNumberOfTuples(this->Tuples);
      this->Result->AddArray(array);
      const int attribute = arrays->IsArrayAnAttribute(i);
      if (attribute >= 0)
      {
        this->Result->SetActiveAttribute(given->GetName(), attribute);
      }
    }
  }
}

std::string MergedArrays::NameOfArray(const char* array) const
{
  return std::string(this->Kind) + " array '" + array + "'";
}

void MergedArrays::RequireNoOthers(std::size_t piece, vtkDataSetAttributes* arrays) const
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* given = arrays->GetAbstractArray(i);
    if (IsMerged(given) && !this->Result->HasArray(given->GetName()))
    {
      this->RefuseMissing(given->GetName(), piece, this->First);
    }
  }
}

void MergedArrays::RequireAlike(
  std::size_t piece, vtkAbstractArray* array, vtkAbstractArray* given) const
{
  if (!given)
  {
    this->RefuseMissing(array->GetName(), this->First, piece);
  }
  if (given->GetDataType() != array->GetDataType() ||
    given->GetNumberOfComponents() != array->GetNumberOfComponents())
  {
    throw InputError(this->NameOfArray(array->GetName()) + NameOf(this->Pieces[piece]) + " is a " +
      given->GetClassName() + " of " + std::to_string(given->GetNumberOfComponents()) +
      " components, but" + NameOf(this->Pieces[this->First]) + " it is a " + array->GetClassName() +
      " of " + std::to_string(array->GetNumberOfComponents()) +
      ": the pieces of a surface must have the same arrays");
  }
}

void MergedArrays::RefuseMissing(const char* array, std::size_t has, std::size_t hasNot) const
{
  throw InputError("the surface" + NameOf(this->Pieces[hasNot]) + " has no " +
    this->NameOfArray(array) + ", which the part" + NameOf(this->Pieces[has]) +
    " has: the pieces of a surface must have the same arrays");
}

} // namespace Illumination
