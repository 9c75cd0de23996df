// SPDX-License-Identifier: BSD-3-Clause
// Where a source gives a range, the preset is its mean unless it says otherwise. The sources:
//  DIAL    DIAL, DIALux knowledge base, "Photometric material properties": absorption, reflection,
//          transmission.
//  OSRAM   OSRAM, Encyclopedia of Light, "Reflection".
//  LRC     Lighting Research Center, Rensselaer, Terminology, "Reflectance".
//  LR      lightrechner.de, glossary, "Reflexionsgrad": values by EN 12464-1 and from practice.
//  E+      U.S. Department of Energy, EnergyPlus, data sets WindowGlassMaterials.idf and
//          WindowShadeMaterials.idf.
#include "Illumination/materials/MaterialPresets.h"

namespace Illumination
{
namespace
{

using PhotonTransport::Colour;
using PhotonTransport::Material;

Material Matt(const Colour& reflectance)
{
  Material material;
  material.diffuseReflectance = reflectance;
  return material;
}

Material Matt(float reflectance)
{
  return Matt(Colour(reflectance));
}

/// Lets light through to all sides.
Material Translucent(float reflectance, float transmittance)
{
  Material material = Matt(reflectance);
  material.diffuseTransmittance = Colour(transmittance);
  return material;
}

/// A reflector of aluminium: 0.85, LRC (highly reflective aluminium). Its roughness is that of
/// lightly brushed aluminium in G. Ward, "Measuring and Modeling Anisotropic Reflection" (SIGGRAPH
/// 1992), table 1: the mean slope sqrt(0.088 * 0.130) is alpha, of which roughness is the root.
Material Aluminium()
{
  Material material;
  material.glossyReflectance = Colour(0.85f);
  material.roughness = 0.33f;
  return material;
}

/// 0.85 to 0.95, LR; that is also what a film of silver (0.95, LRC) leaves behind 4 mm of glass.
Material Mirror()
{
  Material material;
  material.specularReflectance = Colour(0.9f);
  return material;
}

/// 6 mm of float glass: visible transmittance 0.881 and reflectance 0.080 at normal incidence, E+
/// (CLEAR 6MM). With r = ((n - 1) / (n + 1))^2, n = 1.52, a pane of internal transmittance t passes
/// T = (1 - r)^2 t / (1 - r^2 t^2), and t = 0.96 gives T = 0.881, reflectance 0.079.
Material ClearGlass()
{
  Material material;
  material.clearTransmittance = Colour(0.96f);
  material.refractiveIndex = 1.52f;
  return material;
}

/// Lets all light through, as if nothing were there.
Material Nothing()
{
  Material material;
  material.clearTransmittance = Colour(1.0f);
  material.refractiveIndex = 1.0f;
  return material;
}

} // namespace

Material MaterialOf(MaterialPreset preset)
{
  switch (preset)
  {
    case MaterialPreset::WhitePaint: // 0.80 to 0.90, LR; 0.80, OSRAM; 0.90, LRC
      return Matt(0.85f);
    case MaterialPreset::Plaster: // 0.70 to 0.80, DIAL (gypsum)
      return Matt(0.75f);
    case MaterialPreset::Concrete: // 0.20 to 0.30, DIAL (untreated); 0.30, OSRAM
      return Matt(0.25f);
    case MaterialPreset::Wood:
      // Oak, L* 65.5, a* 8.8, b* 20.7 (D65): L. Dzurenda, BioResources 13 (2018) 1525, mildly
      // steamed. Luminous reflectance 0.35; light wood has 0.30 to 0.60, DIAL.
      return Matt(Colour(0.50f, 0.32f, 0.20f));
    case MaterialPreset::Fabric: // curtains and lamp shades: E+ (medium reflect, medium trans)
      return Translucent(0.5f, 0.4f);
    case MaterialPreset::BlackPaint: // 0.03 to 0.10, LR; the geometric mean, rounded
      return Matt(0.05f);
    case MaterialPreset::Aluminium:
      return Aluminium();
    case MaterialPreset::Mirror:
      return Mirror();
    case MaterialPreset::ClearGlass:
      return ClearGlass();
    case MaterialPreset::FrostedGlass:
      // What the pane of clear glass does to light from all sides by Fresnel's formulae, now
      // without direction; prismatic glass transmits 0.70 to 0.90 and reflects 0.05 to 0.20, DIAL.
      return Translucent(0.15f, 0.81f);
    case MaterialPreset::Opening:
      return Nothing();
    default: // MID_GREY: custom of lighting design for walls (ceiling 0.7, walls 0.5, floor 0.2)
      return Matt(0.5f);
  }
}

} // namespace Illumination
