// SPDX-License-Identifier: BSD-3-Clause
// From luminance to the colours of a display.
#pragma once

#include "PhotonTransport/materials/Colour.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The one number that stands for a light of three channels: its luminance, illuminance and so on.
inline double LuminousSum(const glm::dvec3& light)
{
  const bool isWhite = light.x == light.y && light.y == light.z;
  return isWhite ? light.x : glm::dot(glm::dvec3(LuminousWeights), light);
}

/// What the adaptation luminance is shown as, a share of the display's white: mid grey. Reinhard et
/// al., "Photographic tone reproduction for digital images", 2002, section 2.1.
constexpr double MidGrey = 0.18;

struct DisplaySettings
{
  double adaptationLuminance = 1.0;  ///< cd/m², > 0: shown as mid grey.
  double compensation = 0.0;         ///< Stops: each doubles what is shown.
  double highlightCompression = 1.0; ///< [0, 1], see ToneCurve.
  double whiteLuminance = 1.0;       ///< cd/m², > 0: shown as white.
  Colour white{ 1.0f, 1.0f, 1.0f };  ///< Light of this colour looks white; >= 0, not all 0.
};

/// How light values, in shares of what an uncompressed picture shows as white, become light values
/// of a display, [0, 1]. Up to the share 1 - compression they stay as they are, so that places keep
/// their ratios. What is brighter is compressed by Reinhard's equation (4), with the same slope
/// where the two meet, so that `white` and all above become 1. Compression 0 just cuts off.
class ToneCurve
{
public:
  /// @param compression [0, 1]. @param white > 0; nothing is compressed if it is at most 1.
  ToneCurve(double compression, double white);
  double operator()(double value) const;

private:
  double Knee;
  double White; ///< In units of Reinhard's curve.
};

/// The value of a display that shows a share of its white, both [0, 1]; IEC 61966-2-1, 5.2.
double SrgbEncoded(double linear);

/// Makes light of a colour look white: von Kries' adaptation by Bradford's cone responses (Lam,
/// 1985), which keeps the luminance of that light. For linear red, green and blue.
glm::dmat3 WhiteAdaptation(const Colour& white);

/// A colour of the same luminance within [0, 1] of each channel: mixed with its grey as little as
/// possible, so that it keeps its hue. @param colour Its luminance must be within [0, 1].
glm::dvec3 WithinDisplay(const glm::dvec3& colour);

/// All of it: white balance, exposure, compression by luminance, the limits of the display, sRGB.
class DisplayTransform
{
public:
  explicit DisplayTransform(const DisplaySettings& settings);
  /// @param luminance cd/m² by channel, >= 0.
  std::array<std::uint8_t, 3> operator()(const glm::dvec3& luminance) const;

private:
  glm::dmat3 ToShares; ///< White balance and exposure.
  ToneCurve Curve;
};

/// A part of a surface and the luminance that it has, cd/m².
struct LuminousArea
{
  double area;
  double luminance;
};

/// The luminance to which the eye is taken to adapt, cd/m²: the mean of the logarithm, by area.
/// What is below a thousandth of the mean counts as that, so that dark places do not decide. 0 if
/// all is dark.
double LogMeanLuminance(const std::vector<LuminousArea>& areas);

} // namespace PhotonTransport
