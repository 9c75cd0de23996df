// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/OpeningEmitters.h"

#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/sampling/Warps.h"
#include "PhotonTransport/scene/SceneRecords.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace PhotonTransport
{
namespace
{

constexpr int Side = 64; ///< Cells along a side of the square of directions.
/// The sky is looked at in so many places along a side of a cell, from edge to edge. The cells at
/// the horizon are 14 degrees high, and skies are brightest at its edge or rise towards it.
constexpr int Looks = 3;
/// Just within the horizon.
constexpr float Inset = 1e-6f;
/// Of the bound over the largest radiance that is found in a cell and those around it: its steepest
/// rise is that of the light around the sun, by exp(-3 x) in radians, and places are 1.5 degrees
/// apart.
constexpr double Reserve = 1.05;

/// Chooses one of many, and what is left of the number.
struct Chosen
{
  std::size_t index;
  double place; ///< Within [0, 1), a fresh uniform number.
  double width; ///< Of the numbers that choose this one.
};

Chosen Choose(const FluxTable& table, double number)
{
  constexpr double Last = 1.0 - 0x1p-53;
  const std::size_t index = table.At(number);
  const double begin = table.Begin(index);
  const double width = table.End(index) - begin;
  return { index, std::clamp((number - begin) / width, 0.0, Last), width };
}

/// The largest radiance from anywhere, by a grid of a degree.
double LargestRadiance(const SkyRadiance& radiance)
{
  constexpr int Polar = 180, Azimuth = 360;
  double largest = 0.0;
  for (int p = 0; p < Polar; ++p)
  {
    const double polar = Pi * (p + 0.5) / Polar;
    for (int z = 0; z < Azimuth; ++z)
    {
      const double azimuth = 2.0 * Pi * (z + 0.5) / Azimuth;
      largest = std::max(largest,
        radiance(glm::vec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
          std::cos(polar))));
    }
  }
  return Reserve * largest;
}

/// A table of what openings let in, where that is not nothing.
FluxTable TableOf(const std::vector<double>& fluxes, double& sum)
{
  sum = 0.0;
  for (const double flux : fluxes)
  {
    sum += flux;
  }
  return sum > 0.0 ? FluxTable(fluxes) : FluxTable();
}

/// A little outside of the opening, lest the way out crosses it. Panes lie farther inside.
glm::vec3 PointOn(const Opening& opening, const PhotonSample& sample)
{
  const glm::vec3 point = opening.PointAt(sample.Emission(0), sample.Emission(1));
  const glm::vec3 size = glm::abs(point);
  const float reach = std::max({ size.x, size.y, size.z, opening.radius });
  return point - OriginOffset * reach * opening.normal;
}

const Ray NotKept{ glm::vec3(0.0f), glm::vec3(0.0f) };

} // namespace

SkyCells::SkyCells(const glm::vec3& outwards, const SkyRadiance& radiance)
  : Outwards(outwards)
  , Bounds(Side * Side, 0.0)
{
  std::vector<double> found(Side * Side, 0.0);
  for (int cell = 0; cell < Side * Side; ++cell)
  {
    for (int look = 0; look < Looks * Looks; ++look)
    {
      const auto at = [&](int cellIndex, int place)
      {
        const float number =
          static_cast<float>(cellIndex) + static_cast<float>(place) / static_cast<float>(Looks - 1);
        return std::clamp(number / Side, Inset, 1.0f - Inset);
      };
      const glm::vec3 local =
        CosineHemisphere(at(cell % Side, look % Looks), at(cell / Side, look / Looks));
      found[cell] = std::max(found[cell], radiance(this->Outwards.ToWorld(local)));
    }
  }
  std::vector<double> rows;
  for (int row = 0; row < Side; ++row)
  {
    for (int column = 0; column < Side; ++column)
    {
      double& bound = this->Bounds[row * Side + column];
      for (int y = std::max(0, row - 1); y <= std::min(Side - 1, row + 1); ++y)
      {
        for (int x = std::max(0, column - 1); x <= std::min(Side - 1, column + 1); ++x)
        {
          bound = std::max(bound, Reserve * found[y * Side + x]);
        }
      }
    }
    const auto begin = this->Bounds.begin() + row * Side;
    double sum = 0.0;
    this->Columns.push_back(TableOf(std::vector<double>(begin, begin + Side), sum));
    rows.push_back(sum);
  }
  double sum = 0.0;
  this->Rows = TableOf(rows, sum);
  this->Whole = Pi * sum / (Side * Side);
}

SkyCells::Sample SkyCells::At(double u, double v) const
{
  const Chosen row = Choose(this->Rows, v);
  const Chosen column = Choose(this->Columns[row.index], u);
  const auto x = static_cast<float>((static_cast<double>(column.index) + column.place) / Side);
  const auto y = static_cast<float>((static_cast<double>(row.index) + row.place) / Side);
  return { this->Outwards.ToWorld(CosineHemisphere(x, y)),
    this->Bounds[row.index * Side + column.index] };
}

SkyThroughOpenings::SkyThroughOpenings(const Openings& openings, SkyRadiance radiance)
  : All(openings.List())
  , Radiance(std::move(radiance))
{
  std::vector<double> fluxes;
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    const auto same =
      std::find_if(this->All.begin(), this->All.begin() + static_cast<std::ptrdiff_t>(i),
        [&](const Opening& other) { return other.normal == this->All[i].normal; });
    const auto place = static_cast<std::size_t>(same - this->All.begin());
    this->Cells.push_back(place < i
        ? this->Cells[place]
        : std::make_shared<const SkyCells>(-this->All[i].normal, this->Radiance));
    fluxes.push_back(double{ this->All[i].Area() } * this->Cells.back()->Integral());
  }
  this->Choice = TableOf(fluxes, this->Flux);
}

Ray SkyThroughOpenings::Emit(const PhotonSample& sample, const Share& share) const
{
  const Chosen opening = Choose(this->Choice, share.PlaceOf(sample));
  const SkyCells::Sample sky =
    this->Cells[opening.index]->At(double{ sample.Emission(2) }, double{ sample.Emission(3) });
  // What is left of the choice decides, since it is as well spread as place and direction are. A
  // random number stands for the digits that it has no more.
  const double digit = 0x1p-32 / (share.width * opening.width);
  const double number = opening.place + digit * double{ sample.KeepingNumber() };
  const bool kept = number * sky.bound < this->Radiance(sky.direction);
  return kept ? Ray{ PointOn(this->All[opening.index], sample), sky.direction } : NotKept;
}

ScatteredThroughOpenings::ScatteredThroughOpenings(const Openings& openings, SkyRadiance radiance)
  : All(openings.List())
  , Radiance(std::move(radiance))
  , Largest(LargestRadiance(this->Radiance))
{
  std::vector<double> fluxes;
  for (const Opening& opening : this->All)
  {
    fluxes.push_back(Pi * double{ opening.Area() } * this->Largest);
  }
  this->Choice = TableOf(fluxes, this->Flux);
}

Ray ScatteredThroughOpenings::Emit(const PhotonSample& sample, const Share& share) const
{
  const Opening& opening = this->All[this->Choice.At(share.PlaceOf(sample))];
  const glm::vec3 local = CosineHemisphereAbove(sample.OnDisk(1));
  return { PointOn(opening, sample), Frame(-opening.normal).ToWorld(local) };
}

float ScatteredThroughOpenings::KeptFrom(const glm::vec3& towards) const
{
  return static_cast<float>(this->Radiance(towards) / this->Largest);
}

ParallelThroughOpenings::ParallelThroughOpenings(
  const Openings& openings, const ParallelEmitter& light)
  : All(openings.List())
  , Towards(-light.direction)
{
  std::vector<double> fluxes;
  for (const Opening& opening : this->All)
  {
    const double cosine = -glm::dot(glm::dvec3(opening.normal), glm::dvec3(this->Towards));
    fluxes.push_back(std::max(0.0, cosine) * double{ opening.Area() } / light.area);
  }
  this->Choice = TableOf(fluxes, this->Flux);
}

Ray ParallelThroughOpenings::Emit(const PhotonSample& sample, const Share& share) const
{
  return { PointOn(this->All[this->Choice.At(share.PlaceOf(sample))], sample), this->Towards };
}

std::shared_ptr<const OpeningEmitter> EmitterThroughOpenings(
  const Openings& openings, const LampEmitter& lamp, LightPart part)
{
  std::shared_ptr<const OpeningEmitter> through;
  std::visit(
    [&](const auto& emitter)
    {
      using Kind = std::decay_t<decltype(emitter)>;
      if constexpr (std::is_same_v<Kind, SkyEmitter> || std::is_same_v<Kind, TableSkyEmitter>)
      {
        const SkyRadiance radiance = [emitter](const glm::vec3& towards)
        { return emitter.RadiancePerLumen(towards); };
        through = part == LightPart::Straight
          ? std::shared_ptr<const OpeningEmitter>(
              std::make_shared<SkyThroughOpenings>(openings, radiance))
          : std::make_shared<ScatteredThroughOpenings>(openings, radiance);
      }
      else if constexpr (std::is_same_v<Kind, ParallelEmitter>)
      {
        if (part == LightPart::Straight)
        {
          through = std::make_shared<ParallelThroughOpenings>(openings, emitter);
        }
      }
    },
    lamp);
  return through && through->FluxPerLumen() > 0.0 ? through : nullptr;
}

} // namespace PhotonTransport
