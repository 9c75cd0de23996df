// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/appearance/DisplayTransform.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Linear red, green and blue to CIE XYZ; IEC 61966-2-1, 5.2. By rows, as printed there.
const glm::dmat3 ToXyz = glm::transpose(
  glm::dmat3(0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505));

/// CIE XYZ to Bradford's cone responses; Lam, "Metamerism and colour constancy", 1985. By rows.
const glm::dmat3 ToCones = glm::transpose(
  glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));

} // namespace

ToneCurve::ToneCurve(double compression, double white)
  : Knee(white > 1.0 ? 1.0 - compression : 1.0)
  , White(this->Knee < 1.0 ? (white - this->Knee) / (1.0 - this->Knee) : 1.0)
{
}

double ToneCurve::operator()(double value) const
{
  if (value <= this->Knee)
  {
    return value;
  }
  if (!(this->Knee < 1.0))
  {
    return 1.0;
  }
  const double u = std::min((value - this->Knee) / (1.0 - this->Knee), this->White);
  const double compressed = u * (1.0 + u / (this->White * this->White)) / (1.0 + u); // eq. (4)
  return std::min(this->Knee + (1.0 - this->Knee) * compressed, 1.0);
}

double SrgbEncoded(double linear)
{
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

glm::dmat3 WhiteAdaptation(const Colour& white)
{
  if (IsGrey(white))
  {
    return glm::dmat3(1.0);
  }
  const glm::dmat3 toCones = ToCones * ToXyz;
  const glm::dvec3 light = glm::dvec3(white) / LuminousSum(white);
  // All cone responses to the primaries are above 0, so those to the light are.
  const glm::dvec3 gain = (toCones * glm::dvec3(1.0)) / (toCones * light);
  glm::dmat3 adapted = toCones;
  for (int c = 0; c < 3; ++c)
  {
    adapted[c] *= gain;
  }
  return glm::inverse(toCones) * adapted;
}

glm::dvec3 WithinDisplay(const glm::dvec3& colour)
{
  const double grey = std::clamp(LuminousSum(colour), 0.0, 1.0);
  double kept = 1.0;
  for (int c = 0; c < 3; ++c)
  {
    if (colour[c] > 1.0)
    {
      kept = std::min(kept, (1.0 - grey) / (colour[c] - grey));
    }
    else if (colour[c] < 0.0)
    {
      kept = std::min(kept, grey / (grey - colour[c]));
    }
  }
  return kept < 1.0 ? grey + kept * (colour - grey) : colour;
}

DisplayTransform::DisplayTransform(const DisplaySettings& settings)
  : ToShares(WhiteAdaptation(settings.white) *
      (MidGrey * std::exp2(settings.compensation) / settings.adaptationLuminance))
  , Curve(settings.highlightCompression,
      MidGrey * std::exp2(settings.compensation) * settings.whiteLuminance /
        settings.adaptationLuminance)
{
}

std::array<std::uint8_t, 3> DisplayTransform::operator()(const glm::dvec3& luminance) const
{
  glm::dvec3 shares = this->ToShares * luminance;
  const double total = LuminousSum(shares);
  if (!(total > 0.0))
  {
    return { 0, 0, 0 };
  }
  shares = WithinDisplay(shares * (this->Curve(total) / total));
  std::array<std::uint8_t, 3> colour{};
  for (int c = 0; c < 3; ++c)
  {
    const double share = std::clamp(shares[c], 0.0, 1.0); // beyond by rounding alone
    colour[static_cast<std::size_t>(c)] =
      static_cast<std::uint8_t>(std::lround(255.0 * SrgbEncoded(share)));
  }
  return colour;
}

double LogMeanLuminance(const std::vector<LuminousArea>& areas)
{
  double total = 0.0;
  double mean = 0.0;
  for (const LuminousArea& part : areas)
  {
    total += part.area;
    mean += part.area * part.luminance;
  }
  if (!(mean > 0.0))
  {
    return 0.0;
  }
  const double least = 1e-3 * mean / total;
  double logarithms = 0.0;
  for (const LuminousArea& part : areas)
  {
    logarithms += part.area * std::log(std::max(part.luminance, least));
  }
  return std::exp(logarithms / total);
}

} // namespace PhotonTransport
