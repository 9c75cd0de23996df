// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/Relighting.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>

namespace PhotonTransport
{
namespace
{

/// A lamp as two lists: the amount of its light, and all else that describes it.
struct Description
{
  std::vector<double> amounts; ///< One; of a mesh one for each facet.
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// Takes the values of a lamp down; see LampKind.h.
class DescriptionWriter
{
public:
  explicit DescriptionWriter(Description& description)
    : Written(description)
  {
  }

  void operator()(const char* name, double number) const
  {
    const std::string field = name;
    const bool isAmount = field == "LuminousFlux" || field == "LuminaireIlluminance" ||
      field == "SkyLuminance" || field == "PhotometricScale";
    (isAmount ? this->Written.amounts : this->Written.numbers).push_back(number);
  }
  void operator()(const char*, int number, int, int) const
  {
    this->Written.numbers.push_back(static_cast<double>(number));
  }
  void operator()(const char*, bool is) const { this->Written.numbers.push_back(is ? 1.0 : 0.0); }
  void operator()(const char*, const glm::dvec2& v) const
  {
    this->Written.numbers.insert(this->Written.numbers.end(), { v.x, v.y });
  }
  void operator()(const char*, const glm::dvec3& v) const
  {
    this->Written.numbers.insert(this->Written.numbers.end(), { v.x, v.y, v.z });
  }
  void operator()(const char*, const std::vector<double>& values) const
  {
    this->Written.numbers.push_back(static_cast<double>(values.size()));
    this->Written.numbers.insert(this->Written.numbers.end(), values.begin(), values.end());
  }
  void operator()(const char*, const std::string& text) const
  {
    this->Written.texts.push_back(text);
  }
  void operator()(const char*, const std::vector<std::string>&) const {} // remarks
  void operator()(const char*, PhotometricSolid& solid) const { DescribeFields(*this, solid); }
  [[noreturn]] static void Refuse(const char* name, const std::string& message)
  {
    throw InvalidInput(InvalidInput::Where::LampSettings, 0, name + (" " + message));
  }

private:
  Description& Written;
};

// What Describe leaves out.
template <typename AnyLamp>
void AddRest(const AnyLamp&, Description&)
{
}
void AddRest(const RectangleLamp& lamp, Description& description)
{
  DescriptionWriter{ description }("", lamp.across);
}
void AddRest(const EmittingFacets&, Description& description)
{
  description.amounts.push_back(1.0); // the surface has it
}
void AddRest(const EmittingMesh& mesh, Description& description)
{
  const DescriptionWriter writer(description);
  for (const glm::dvec3& point : mesh.points)
  {
    writer("", point);
  }
  for (const glm::uvec3& facet : mesh.facets)
  {
    writer("", glm::dvec3(facet));
  }
  description.amounts.assign(mesh.exitance.begin(), mesh.exitance.end());
}

Description DescriptionOf(Lamp lamp)
{
  Description description;
  std::visit(
    [&](auto& l)
    {
      l.Describe(DescriptionWriter(description));
      AddRest(l, description);
    },
    lamp);
  return description;
}

/// By which all amounts are multiplied; nothing if by different factors, or if there is none.
std::optional<double> FactorOf(const std::vector<double>& other, const std::vector<double>& wanted)
{
  constexpr double Rounding = 0x1p-22; // of two numbers of single precision
  double before = 0.0;
  double after = 0.0;
  for (std::size_t i = 0; i < other.size(); ++i)
  {
    before += other[i];
    after += wanted[i];
  }
  if (other == wanted)
  {
    return 1.0;
  }
  const double factor = after / before;
  if (!(before > 0.0 && factor >= 0.0) || !std::isfinite(factor))
  {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < other.size(); ++i)
  {
    if (!(std::fabs(wanted[i] - factor * other[i]) <= Rounding * wanted[i]))
    {
      return std::nullopt;
    }
  }
  return factor;
}

std::optional<double> FactorOf(const Luminaire& other, const Luminaire& wanted)
{
  if (other.lamp.index() != wanted.lamp.index())
  {
    return std::nullopt;
  }
  const Description before = DescriptionOf(other.lamp);
  const Description after = DescriptionOf(wanted.lamp);
  if (before.numbers != after.numbers || before.texts != after.texts ||
    before.amounts.size() != after.amounts.size())
  {
    return std::nullopt;
  }
  const std::optional<double> factor = FactorOf(before.amounts, after.amounts);
  if (!factor || other.dimming == wanted.dimming)
  {
    return factor;
  }
  const double dimmed = *factor * wanted.dimming / other.dimming;
  return dimmed >= 0.0 && std::isfinite(dimmed) ? std::optional(dimmed) : std::nullopt;
}

} // namespace

bool Relighting::IsNone() const
{
  return this->sameColours &&
    std::all_of(this->factors.begin(), this->factors.end(), [](double f) { return f == 1.0; });
}

std::optional<Relighting> RelightingOf(const Lighting& other, const Lighting& wanted)
{
  if (other.luminaires.size() != wanted.luminaires.size())
  {
    return std::nullopt;
  }
  Relighting relighting;
  for (std::size_t l = 0; l < other.luminaires.size(); ++l)
  {
    const std::optional<double> factor = FactorOf(other.luminaires[l], wanted.luminaires[l]);
    if (!factor)
    {
      return std::nullopt;
    }
    relighting.factors.push_back(*factor);
    if (other.luminaires[l].colour != wanted.luminaires[l].colour)
    {
      relighting.sameColours = false;
    }
  }
  return relighting;
}

} // namespace PhotonTransport
