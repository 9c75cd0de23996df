// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/materials/OpeningCells.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/surface/GhostCells.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace Illumination
{
namespace
{

using PhotonTransport::OpeningMark;

constexpr const char* Name = "Opening";

float ValueOf(OpeningMark mark)
{
  switch (mark)
  {
    case OpeningMark::Opening:
      return 1.0f;
    case OpeningMark::NoOpening:
      return 0.0f;
    default:
      return -1.0f;
  }
}

OpeningMark MarkOf(double value, vtkPolyData* data, vtkIdType cell, const std::string& block)
{
  for (const OpeningMark mark : { OpeningMark::Opening, OpeningMark::NoOpening, OpeningMark::None })
  {
    if (value == static_cast<double>(ValueOf(mark)))
    {
      return mark;
    }
  }
  throw InputError(Text(NameOfCell(data, cell, block), ": ", Name, " is ", value,
    "; it must be 1 (an opening), 0 (none) or -1 (as found from the mesh)"));
}

bool HasMarks(vtkPolyData* data)
{
  return data->GetCellData()->HasArray(Name) != 0;
}

} // namespace

void DescribeOpenings(const std::vector<SceneBlock>& blocks, const SurfaceDescription& description,
  PhotonTransport::Surface& surface)
{
  const auto has = [](const SceneBlock& block) { return HasMarks(block.data); };
  if (!description.materialArrays || std::none_of(blocks.begin(), blocks.end(), has))
  {
    return;
  }
  for (const SceneBlock& block : blocks)
  {
    vtkDataArray* marks =
      has(block) ? CheckedCellArray(block.data, Name, block.name, false) : nullptr;
    for (const vtkIdType cell : block.cellOfFacet)
    {
      surface.openingOfFacet.push_back(marks
          ? MarkOf(marks->GetComponent(cell, 0), block.data, cell, block.name)
          : OpeningMark::None);
    }
  }
}

void WriteOpening(
  vtkPolyData* data, const std::string& block, const std::vector<bool>& chosen, OpeningMark mark)
{
  vtkDataArray* given = HasMarks(data) ? CheckedCellArray(data, Name, block, false) : nullptr;
  if (!given && mark == OpeningMark::None)
  {
    return;
  }
  vtkNew<vtkFloatArray> marks;
  marks->SetName(Name);
  marks->SetNumberOfTuples(data->GetNumberOfCells());
  const GhostCells ghosts(data, block);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const bool isChosen = chosen[static_cast<std::size_t>(cell)];
    const bool keeps = !isChosen && given != nullptr;
    const double kept = keeps ? given->GetComponent(cell, 0) : -1.0;
    if (keeps && !ghosts.IsGhost(cell))
    {
      MarkOf(kept, data, cell, block);
    }
    marks->SetValue(cell, isChosen ? ValueOf(mark) : static_cast<float>(kept));
  }
  data->GetCellData()->AddArray(marks);
}

} // namespace Illumination
