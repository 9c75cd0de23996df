// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

/// Shares of unpolarised light; the rest is absorbed.
struct ReflectedAndTransmitted
{
  float reflected;
  float transmitted;
};

/// Reflectances of the two polarisations at a boundary of two dielectrics (Born and Wolf,
/// "Principles of Optics", 1.5.2). Both are 1 where all light is reflected.
struct FresnelReflectances
{
  float perpendicular;
  float parallel;
  float cosine; ///< Of the refracted ray to the normal; 0 where there is none.

  /// @param cosIn Cosine of the arriving ray to the normal, [0, 1]. @param index Refractive index
  /// of the side that it enters relative to the side that it comes from, > 0.
  FresnelReflectances(float cosIn, float index)
  {
    // Snell's law, cos^2 = 1 - sin^2 / n^2, multiplied out. As it stands it would lose digits at
    // grazing incidence, and an index of 1 would reflect.
    const float cosine2 = (cosIn * cosIn + (index - 1.0f) * (index + 1.0f)) / (index * index);
    if (!(cosine2 > 0.0f))
    {
      this->perpendicular = this->parallel = 1.0f;
      this->cosine = 0.0f;
      return;
    }
    this->cosine = std::sqrt(cosine2);
    const float s = (cosIn - index * this->cosine) / (cosIn + index * this->cosine);
    const float p = (index * cosIn - this->cosine) / (index * cosIn + this->cosine);
    this->perpendicular = s * s;
    this->parallel = p * p;
  }

  float Mean() const { return 0.5f * (this->perpendicular + this->parallel); }
};

/// A thin pane with both its faces and all reflections between them, which do not interfere:
/// R = r + (1 - r)^2 r t^2 / (1 - r^2 t^2), T = (1 - r)^2 t / (1 - r^2 t^2) for each polarisation.
/// @param fresnel Of its face. @param internal Transmittance t of the pane's body at normal
/// incidence, [0, 1]; at a slant it is t^(1 / cosine of the refracted ray).
inline ReflectedAndTransmitted ThinPane(const FresnelReflectances& fresnel, float internal)
{
  const float body =
    internal < 1.0f && fresnel.cosine > 0.0f ? std::pow(internal, 1.0f / fresnel.cosine) : internal;
  ReflectedAndTransmitted sum{ 0.0f, 0.0f };
  for (const float r : { fresnel.perpendicular, fresnel.parallel })
  {
    const float away = (1.0f - r) * (1.0f - r) * body;
    const float rest = 1.0f - r * r * body * body;
    const float transmitted = rest > 0.0f ? away / rest : 0.0f;
    sum.reflected += 0.5f * (r + r * body * transmitted);
    sum.transmitted += 0.5f * transmitted;
  }
  return sum;
}

/// The refracted direction. @param direction Unit, of the arriving ray. @param normal Unit, on the
/// side it comes from. @param cosOut See FresnelReflectances::cosine, > 0.
inline glm::vec3 Refract(
  const glm::vec3& direction, const glm::vec3& normal, float cosIn, float index, float cosOut)
{
  return glm::normalize((direction + cosIn * normal) / index - cosOut * normal);
}

} // namespace PhotonTransport
