// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/appearance/SurfaceLuminance.h"

#include "Illumination/appearance/ArrivingLight.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/surface/GhostCells.h"
#include "Illumination/surface/InputChecks.h"
#include "Illumination/surface/SurfaceTriangles.h"

#include "PhotonTransport/geometry/Pi.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace Illumination
{
namespace
{

/// Reads the light of a block and tells how its points shine.
class BlockShine
{
public:
  BlockShine(const NamedSurface& block, const CellLooks& looks, const ArrivingLight& light,
    const FacingSurface& surface)
    : Block(block)
    , Looks(looks)
    , Light(light)
    , Surface(surface)
  {
  }

  /// cd/m² by channel; 0 for points that no polygon or strip uses.
  glm::dvec3 LuminanceOf(std::size_t point) const
  {
    const std::uint32_t own = this->Surface.lookOfPoint[point];
    if (own == NoLook)
    {
      return glm::dvec3(0.0);
    }
    const CellLook& look = this->Looks.looks[own];
    const vtkIdType given = this->Surface.original[point];
    return (glm::dvec3(look.reflectance) * this->Light.OnFront(given) +
             glm::dvec3(look.transmittance) * this->Light.OnBack(given) +
             glm::dvec3(look.exitance)) /
      PhotonTransport::Pi;
  }

  /// Adds the cells to those that shine or to the others.
  void Look(const std::vector<glm::dvec3>& luminance, SurfaceLuminance& seen) const
  {
    const GhostCells ghosts(this->Block.data, this->Block.name);
    std::size_t number = 0;
    for (vtkCellArray* cells : { this->Surface.data->GetPolys(), this->Surface.data->GetStrips() })
    {
      auto it = vtk::TakeSmartPointer(cells->NewIterator());
      for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++number)
      {
        const vtkIdType cell = this->Looks.first + static_cast<vtkIdType>(number);
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        it->GetCurrentCell(size, ids);
        if (size > 2 && !(ghosts.Any() && ghosts.IsGhost(cell)))
        {
          const bool shines = this->Looks.looks[this->Looks.lookOfCell[number]].Shines();
          (shines ? seen.shining : seen.others)
            .push_back(this->LookAt(size, ids, this->AreaOf(cells, size, ids), luminance));
        }
      }
    }
  }

private:
  glm::dvec3 At(vtkIdType point) const
  {
    glm::dvec3 x;
    this->Surface.data->GetPoint(point, &x.x);
    return x;
  }

  double AreaOf(vtkCellArray* cells, vtkIdType size, const vtkIdType* ids) const
  {
    const bool isStrip = cells == this->Surface.data->GetStrips();
    glm::dvec3 vector(0.0);
    double area = 0.0;
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      const glm::dvec3 first = this->At(isStrip ? ids[i - 1] : ids[0]);
      const glm::dvec3 part =
        0.5 * glm::cross(this->At(ids[i]) - first, this->At(ids[i + 1]) - first);
      vector += part;
      area += glm::length(part);
    }
    return isStrip ? area : glm::length(vector);
  }

  SeenCell LookAt(vtkIdType size, const vtkIdType* ids, double area,
    const std::vector<glm::dvec3>& luminance) const
  {
    SeenCell cell{ area, 0.0, 0.0, glm::dvec3(0.0) };
    for (vtkIdType i = 0; i < size; ++i)
    {
      const auto point = static_cast<std::size_t>(ids[i]);
      const double own = PhotonTransport::LuminousSum(luminance[point]);
      cell.luminance += own / static_cast<double>(size);
      cell.light += this->Light.OnFront(this->Surface.original[point]) / static_cast<double>(size);
      cell.brightest = std::max(cell.brightest, own);
    }
    return cell;
  }

  const NamedSurface& Block;
  const CellLooks& Looks;
  const ArrivingLight& Light;
  const FacingSurface& Surface;
};

bool HasColour(const CellLooks& looks)
{
  return std::any_of(looks.looks.begin(), looks.looks.end(),
    [](const CellLook& look)
    {
      using PhotonTransport::IsGrey;
      return !IsGrey(look.reflectance) || !IsGrey(look.transmittance) || !IsGrey(look.exitance);
    });
}

bool LetsLightPass(const CellLooks& looks)
{
  return std::any_of(looks.looks.begin(), looks.looks.end(),
    [](const CellLook& look) { return look.transmittance != PhotonTransport::Colour(0.0f); });
}

void NoteWhatIsNotShown(const NamedSurface& block, const CellLooks& looks,
  const ArrivingLight& light, std::vector<std::string>& notes)
{
  if (LetsLightPass(looks) && !light.HasBack())
  {
    notes.push_back("light that passes through cells with DiffuseTransmittance" + block.name +
      " is not shown, since there is no point array IlluminanceBack: switch RegisterBackSide of "
      "Illumination Map on");
  }
  for (const char* share : { "SpecularReflectance", "GlossyReflectance", "ClearTransmittance" })
  {
    vtkDataArray* array = block.data->GetCellData()->GetArray(share);
    if (array && array->GetMaxNorm() > 0.0)
    {
      notes.push_back("what is seen in mirrors and gloss and through glass is not shown: cells" +
        block.name + " with " + share + " look as their diffuse reflectance says");
    }
  }
}

/// In an order that does not depend on the ranks, so that sums do not.
std::vector<SeenCell> CellsOfAllRanks(ControllerRanks& ranks, const std::vector<SeenCell>& own)
{
  std::vector<SeenCell> all;
  for (const std::vector<SeenCell>& part : ranks.GatherValues(own))
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  const auto values = [](const SeenCell& cell)
  { return std::tie(cell.luminance, cell.area, cell.light.x, cell.light.y, cell.light.z); };
  std::sort(all.begin(), all.end(),
    [&](const SeenCell& a, const SeenCell& b) { return values(a) < values(b); });
  return all;
}

double Brightest(const std::vector<SeenCell>& cells)
{
  double brightest = 0.0;
  for (const SeenCell& cell : cells)
  {
    brightest = std::max(brightest, cell.brightest);
  }
  return brightest;
}

/// Those of the first rank first; none twice.
std::vector<std::string> NotesOfAllRanks(
  ControllerRanks& ranks, const std::vector<std::string>& own)
{
  std::vector<char> text;
  for (const std::string& note : own)
  {
    text.insert(text.end(), note.begin(), note.end());
    text.push_back('\n');
  }
  std::vector<std::string> all;
  for (const std::vector<char>& part : ranks.Gather(text))
  {
    std::istringstream lines(std::string(part.begin(), part.end()));
    for (std::string note; std::getline(lines, note);)
    {
      if (std::find(all.begin(), all.end(), note) == all.end())
      {
        all.push_back(note);
      }
    }
  }
  return all;
}

} // namespace

SurfaceLuminance LuminanceOf(vtkDataObject* data, const std::string& illuminance,
  const LookDescription& description, const std::function<void(double)>& report)
{
  SurfaceLuminance result;
  const SurfaceParts parts = PartsOf(data);
  for (std::size_t b = 0; b < parts.surfaces.size(); ++b)
  {
    const NamedSurface& block = parts.surfaces[b];
    RequireValidCells(block.data, block.name);
    if (!HasSurface(block.data))
    {
      continue;
    }
    const auto done = [&](double share)
    { report((static_cast<double>(b) + share) / static_cast<double>(parts.surfaces.size())); };
    const CellLooks looks = LooksOf(block, description);
    const ArrivingLight light(block, illuminance);
    done(0.2);
    LuminousBlock luminous{ block, FaceSurface(block, looks), {} };
    done(0.5);
    const BlockShine shine(block, looks, light, luminous.surface);
    for (std::size_t p = 0; p < luminous.surface.original.size(); ++p)
    {
      luminous.luminance.push_back(shine.LuminanceOf(p));
    }
    done(0.7);
    shine.Look(luminous.luminance, result);
    done(1.0);
    result.isColoured = result.isColoured || light.HasColour() || HasColour(looks);
    NoteWhatIsNotShown(block, looks, light, result.notes);
    result.blocks.push_back(std::move(luminous));
  }
  return result;
}

void Adapt(ControllerRanks& ranks, SurfaceLuminance& luminance)
{
  if (!ranks.Any(!luminance.blocks.empty()))
  {
    throw InputError("the input has no polygons or triangle strips to show");
  }
  luminance.isColoured = ranks.Any(luminance.isColoured);
  luminance.notes = NotesOfAllRanks(ranks, luminance.notes);
  std::vector<SeenCell> seen = CellsOfAllRanks(ranks, luminance.others);
  if (Brightest(seen) == 0.0)
  {
    seen = CellsOfAllRanks(ranks, luminance.shining);
  }
  luminance.brightest = Brightest(seen);
  std::vector<PhotonTransport::LuminousArea> areas;
  double area = 0.0;
  glm::dvec3 light(0.0);
  for (const SeenCell& cell : seen)
  {
    areas.push_back({ cell.area, cell.luminance });
    area += cell.area;
    light += cell.area * cell.light;
  }
  luminance.adaptation = PhotonTransport::LogMeanLuminance(areas);
  luminance.light = area > 0.0 ? light / area : glm::dvec3(0.0);
}

} // namespace Illumination
