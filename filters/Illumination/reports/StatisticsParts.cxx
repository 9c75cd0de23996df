// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/reports/StatisticsParts.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/surface/SurfaceParts.h"
#include "Illumination/surface/SurfaceTriangles.h"

#include "vtkDataSet.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace Illumination
{
namespace
{

constexpr int KeyOfBlock = 0;

PartKey KeyOf(const NamedBlock& block)
{
  return { KeyOfBlock, block.number, "" };
}

/// A surface with its facets, by the parts that their cells belong to.
struct CutSurface
{
  std::vector<glm::dvec3> points;
  std::vector<glm::uvec3> facets;
  std::vector<vtkIdType> cellOfFacet;
  std::map<PartKey, std::vector<std::size_t>> facetsOf;
  std::map<PartKey, std::string> names;
};

CutSurface Cut(const NamedBlock& block, const std::string& partArray)
{
  auto* data = vtkPolyData::SafeDownCast(block.data);
  const SurfaceTriangles triangles = TrianglesOf(data, nullptr, block.where);
  CutSurface surface;
  surface.cellOfFacet = CellsOfTriangles(triangles.mesh);
  AppendPoints(triangles.mesh, surface.points);
  AppendFacets(triangles.mesh, 0, surface.facets);
  const PartLabels labels(data, partArray, block.where);
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
  {
    const vtkIdType cell = surface.cellOfFacet[f];
    const PartKey key = labels.IsOnePart() ? KeyOf(block) : labels.KeyOf(cell);
    std::vector<std::size_t>& facets = surface.facetsOf[key];
    if (facets.empty())
    {
      surface.names[key] = labels.IsOnePart() ? block.name : labels.NameOf(cell);
    }
    facets.push_back(f);
  }
  return surface;
}

/// Adds facets and their corners to a part, each corner once.
class PartFiller
{
public:
  PartFiller(const NamedBlock& block, const StatisticsArrays& names, const LightArrays& light,
    const CutSurface& surface)
    : Light(light)
    , Surface(surface)
    , Reflectance(vtkPolyData::SafeDownCast(block.data), names, block.where)
    , SquareMetres(names.metresPerUnit * names.metresPerUnit)
    , PlaceOf(surface.points.size(), None)
  {
  }

  void Fill(StatisticsPart& part, const std::vector<std::size_t>& facets)
  {
    for (const std::size_t f : facets)
    {
      const glm::uvec3& corners = this->Surface.facets[f];
      if (this->Light.IsValid(corners.x) && this->Light.IsValid(corners.y) &&
        this->Light.IsValid(corners.z))
      {
        this->Add(f, part);
      }
    }
    for (const std::size_t f : facets)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->PlaceOf[this->Surface.facets[f][c]] = None;
      }
    }
  }

private:
  static constexpr auto None = static_cast<unsigned>(-1);

  void Add(std::size_t f, StatisticsPart& part)
  {
    const glm::uvec3& corners = this->Surface.facets[f];
    glm::uvec3 places;
    for (int c = 0; c < 3; ++c)
    {
      unsigned& place = this->PlaceOf[corners[c]];
      if (place == None)
      {
        place = static_cast<unsigned>(part.light.values.size());
        this->Light.Append(corners[c], part.light);
      }
      places[c] = place;
    }
    const auto corner = [&](int c) { return this->Surface.points[corners[c]]; };
    const glm::dvec3 area = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    part.facets.corners.push_back(places);
    part.facets.areas.push_back(0.5 * glm::length(area) * this->SquareMetres);
    part.facets.reflectance.push_back(this->Reflectance.Of(this->Surface.cellOfFacet[f]));
  }

  const LightArrays& Light;
  const CutSurface& Surface;
  CellReflectance Reflectance;
  double SquareMetres;
  std::vector<unsigned> PlaceOf; ///< [point] In the part at hand.
};

} // namespace

StatisticsParts::StatisticsParts(
  const std::vector<vtkSmartPointer<vtkDataObject>>& pieces, const StatisticsArrays& arrays)
  : Arrays(arrays)
{
  for (std::size_t rank = 0; rank < pieces.size(); ++rank)
  {
    this->Input.Add(pieces[rank], rank);
  }
  this->Input.JoinSurfacesOfRanks();
  if (this->Input.blocks.empty())
  {
    throw InputError("the input has no points to summarise");
  }
  this->FindNoise();
  for (const NamedBlock& block : this->Input.blocks)
  {
    auto* surface = vtkPolyData::SafeDownCast(block.data);
    const bool isGrid = LightArrays(block, this->Arrays).HasAreas();
    surface&& HasSurface(surface) && !isGrid ? this->AddSurface(block) : this->AddPoints(block);
  }
}

/// Noise counts only if it is known in all blocks, since a row has all columns.
void StatisticsParts::FindNoise()
{
  const auto all = [&](const std::vector<std::string>& names)
  {
    return std::all_of(this->Input.blocks.begin(), this->Input.blocks.end(),
      [&](const NamedBlock& block)
      {
        return std::all_of(names.begin(), names.end(),
          [&](const std::string& name) { return HasPointArray(block.data, name); });
      });
  };
  const std::string& map = this->Arrays.illuminance;
  for (const auto& names : { std::vector<std::string>{ map + "Groups" },
         std::vector<std::string>{ map + "DirectGroups", map + "IndirectGroups" } })
  {
    if (all(names))
    {
      this->Arrays.groups = names;
      this->NoiseFrom = NoiseSource::Groups;
      break;
    }
  }
  if (!all({ this->Arrays.standardError }))
  {
    this->Arrays.standardError.clear();
  }
  else if (this->Arrays.groups.empty())
  {
    this->NoiseFrom = NoiseSource::StandardErrors;
  }
}

StatisticsPart& StatisticsParts::PartOf(const PartKey& key, const std::string& name)
{
  constexpr std::size_t MostParts = 10000;
  StatisticsPart& part = this->ByKey[key];
  if (key.kind != KeyOfBlock && this->ByKey.size() > MostParts)
  {
    throw InputError(Text("the cell array '", this->Arrays.part, "' has more than ", MostParts,
      " different values; it should name the parts of a surface"));
  }
  part.name = name;
  return part;
}

void StatisticsParts::AddPoints(const NamedBlock& block)
{
  const LightArrays arrays(block, this->Arrays);
  StatisticsPart& part = this->PartOf(KeyOf(block), block.name);
  for (vtkIdType p = 0; p < block.data->GetNumberOfPoints(); ++p)
  {
    if (arrays.IsGhost(p))
    {
      continue;
    }
    if (!arrays.IsValid(p))
    {
      ++this->Invalid;
      continue;
    }
    if (arrays.HasAreas())
    {
      // As a facet of one value, which does not reflect.
      part.facets.corners.emplace_back(static_cast<unsigned>(part.light.values.size()));
      part.facets.areas.push_back(arrays.AreaOf(p));
      part.facets.reflectance.push_back(0.0);
    }
    arrays.Append(p, part.light);
  }
}

void StatisticsParts::AddSurface(const NamedBlock& block)
{
  const LightArrays arrays(block, this->Arrays);
  const CutSurface surface = Cut(block, this->Arrays.part);
  for (vtkIdType p = 0; p < block.data->GetNumberOfPoints(); ++p)
  {
    this->Invalid += arrays.IsValid(p) ? 0 : 1;
  }
  PartFiller filler(block, this->Arrays, arrays, surface);
  for (const auto& [key, facets] : surface.facetsOf)
  {
    filler.Fill(this->PartOf(key, surface.names.at(key)), facets);
  }
}

} // namespace Illumination
