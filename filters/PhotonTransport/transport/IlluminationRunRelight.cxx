// SPDX-License-Identifier: BSD-3-Clause
// How a run becomes that of another lighting without tracing.
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/lights/Relighting.h"
#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// RelightingOf has checked the fluxes. What an Emitter would refuse is left to a run of its own.
bool HaveValidColours(const Lighting& lighting)
{
  return std::all_of(lighting.luminaires.begin(), lighting.luminaires.end(),
    [](const Luminaire& luminaire)
    {
      const Colour& colour = luminaire.colour;
      const float sum = colour.x + colour.y + colour.z;
      return colour.x >= 0.0f && colour.y >= 0.0f && colour.z >= 0.0f && sum > 0.0f &&
        std::isfinite(sum);
    });
}

/// The factor of all lamps, if it is the same up to rounding and leaves light.
std::optional<double> FactorOfAll(const LampFactors& factors)
{
  constexpr double Rounding = 0x1p-50;
  const double first = factors.empty() ? 1.0 : factors.front();
  const bool same = std::all_of(factors.begin(), factors.end(),
    [&](double factor) { return std::fabs(factor - first) <= Rounding * first; });
  return same && first > 0.0 ? std::optional(first) : std::nullopt;
}

double FluxBy(const LampFactors& factors, const Emitter& source)
{
  double flux = 0.0;
  for (std::size_t lamp = 0; lamp < factors.size(); ++lamp)
  {
    flux += factors[lamp] * source.Flux(lamp);
  }
  return flux;
}

} // namespace

bool IlluminationRun::Relight(const Lighting& wanted)
{
  const std::optional<Relighting> relighting = RelightingOf(this->Traced, wanted);
  const std::optional<double> ofAll =
    relighting ? FactorOfAll(relighting->factors) : std::optional<double>();
  const bool isPossible = relighting && HaveValidColours(wanted) &&
    (ofAll || CanBeRelit(this->Settings)) &&
    (relighting->sameColours || this->Tracer.LampsTellColours());
  if (!isPossible)
  {
    return false;
  }
  const std::optional<Relighting> change = RelightingOf(this->Now, wanted);
  if (change && change->IsNone())
  {
    return true;
  }
  this->Tracer.RequireIlluminanceInRange(FluxBy(relighting->factors, this->Tracer.Source()));
  this->LightFactor = ofAll.value_or(1.0);
  this->Factors = ofAll ? LampFactors() : relighting->factors;
  this->HasOtherColours = !relighting->sameColours;
  this->Now = wanted;
  this->EffectsNow = AnalyseEffects(this->LitScene, wanted, this->Settings);
  if (!this->Rows.empty())
  {
    this->Rows.erase(this->Rows.begin(), this->Rows.end() - 1); // their maps were of other light
    this->MeasureErrorsOf(this->Rows.back());
  }
  return true;
}

double IlluminationRun::Flux() const
{
  return this->Factors.empty() ? this->Scale().flux : FluxBy(this->Factors, this->Tracer.Source());
}

/// By which light of each lamp counts in a channel, as an illuminance where white light has three
/// equal channels.
LampFactors IlluminationRun::FactorsOfChannel(std::size_t channel) const
{
  LampFactors factors;
  const auto c = static_cast<int>(channel);
  for (std::size_t lamp = 0; lamp < this->Now.luminaires.size(); ++lamp)
  {
    const glm::dvec3 colour(this->Now.luminaires[lamp].colour);
    const double luminance = glm::dot(glm::dvec3(LuminousWeights), colour);
    factors.push_back(this->FactorOf(lamp) * colour[c] / luminance);
  }
  return factors;
}

IlluminationMap IlluminationRun::MapOfLamp(std::size_t lamp) const
{
  LampFactors factors(this->Tracer.Source().Lamps(), 0.0);
  factors[lamp] = this->FactorOf(lamp);
  return this->Sums.Map(&ReplicateSums::front, this->Scale(), factors);
}

std::vector<std::array<double, 3>> IlluminationRun::ColoursOfLamps(
  const std::function<double(const IlluminationMap& map, std::size_t vertex)>& value) const
{
  std::vector<std::array<double, 3>> colours(this->LitScene.VertexAreas().size());
  for (std::size_t c = 0; c < 3; ++c)
  {
    const IlluminationMap map =
      this->Sums.Map(&ReplicateSums::front, this->Scale(), this->FactorsOfChannel(c));
    for (std::size_t v = 0; v < colours.size(); ++v)
    {
      colours[v][c] = value(map, v);
    }
  }
  return colours;
}

} // namespace PhotonTransport
