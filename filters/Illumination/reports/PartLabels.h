// SPDX-License-Identifier: BSD-3-Clause
#ifndef PartLabels_h
#define PartLabels_h

#include "vtkType.h"

#include <string>
#include <tuple>

class vtkDataArray;
class vtkPolyData;
class vtkStringArray;

namespace Illumination
{

/// Rows come in this order: blocks first, by number, then parts by number, then parts by name.
struct PartKey
{
  int kind;
  double number;
  std::string text;
  bool operator<(const PartKey& other) const
  {
    return std::tie(this->kind, this->number, this->text) <
      std::tie(other.kind, other.number, other.text);
  }
};

/// The part of a surface that each cell belongs to, by a cell array.
class PartLabels
{
public:
  /// Throws InputError unless the array is there with one number or text a cell.
  /// @param array Its name; empty if the surface is one part.
  PartLabels(vtkPolyData* data, const std::string& array, std::string where);

  bool IsOnePart() const { return !this->Numbers && !this->Texts; }
  /// Throws InputError for a value that is not finite.
  PartKey KeyOf(vtkIdType cell) const;
  std::string NameOf(vtkIdType cell) const;

private:
  std::string Where;
  vtkDataArray* Numbers = nullptr;
  vtkStringArray* Texts = nullptr;
};

} // namespace Illumination

#endif
