// SPDX-License-Identifier: BSD-3-Clause
// The presets are what their sources say.
#include "MaterialTools.h"

#include <array>
#include <cmath>

namespace
{

struct Pane
{
  double transmittance;
  double reflectance;
};

/// A thin pane by Fresnel's formulae, all inner reflections, mean of the two polarisations; M. Born
/// and E. Wolf, Principles of Optics, 1.5.3 and 7.6.1 (sums of intensities).
Pane PaneAt(double cosine, double index, double internal)
{
  const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
  const double t = std::pow(internal, 1.0 / inside);
  const double s = std::pow((cosine - index * inside) / (cosine + index * inside), 2);
  const double p = std::pow((index * cosine - inside) / (index * cosine + inside), 2);
  Pane pane{ 0.0, 0.0 };
  for (const double r : { s, p })
  {
    const double through = (1.0 - r) * (1.0 - r) * t / (1.0 - r * r * t * t);
    pane.transmittance += through / 2.0;
    pane.reflectance += (r + through * r * t) / 2.0;
  }
  return pane;
}

} // namespace

TEST(SurfaceMaterialPresets, AreMaterialsWithTheirNumbers)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(Plane());
  const auto is = [&](int preset, const std::string& array, double expected)
  {
    filter->SetPreset(preset);
    filter->Update();
    // half a float's step
    EXPECT_LT(std::abs(Value(filter->GetOutput(), array) - expected), 1e-7)
      << array << " of preset " << preset;
  };
  is(vtkSurfaceMaterial::WHITE_PAINT, "DiffuseReflectance", 0.85);
  is(vtkSurfaceMaterial::MID_GREY, "DiffuseReflectance", 0.5);
  is(vtkSurfaceMaterial::PLASTER, "DiffuseReflectance", 0.75);
  is(vtkSurfaceMaterial::CONCRETE, "DiffuseReflectance", 0.25);
  is(vtkSurfaceMaterial::BLACK_PAINT, "DiffuseReflectance", 0.05);
  is(vtkSurfaceMaterial::FABRIC, "DiffuseTransmittance", 0.4);
  is(vtkSurfaceMaterial::ALUMINIUM, "GlossyReflectance", 0.85);
  is(vtkSurfaceMaterial::MIRROR, "SpecularReflectance", 0.9);
  is(vtkSurfaceMaterial::MIRROR, "DiffuseReflectance", 0.0);
  is(vtkSurfaceMaterial::CLEAR_GLASS, "SolidBody", 0.0);
  is(vtkSurfaceMaterial::OPENING, "ClearTransmittance", 1.0);
  is(vtkSurfaceMaterial::OPENING, "RefractiveIndex", 1.0);
  is(vtkSurfaceMaterial::OPENING, "Opening", 1.0);

  // The custom values are out of range and must not matter.
  filter->SetDiffuseReflectance(2.0, 2.0, 2.0);
  for (int p = vtkSurfaceMaterial::WHITE_PAINT; p <= vtkSurfaceMaterial::OPENING; ++p)
  {
    filter->SetPreset(p);
    EXPECT_TRUE(ErrorOf(filter).empty() && HasMaterial(filter->GetOutput()))
      << "preset " << p << " is a material";
  }
}

// Wood is the measured colour in CIELAB, by ISO/CIE 11664-4 and IEC 61966-2-1, to two digits.
TEST(SurfaceMaterialPresets, WoodHasItsMeasuredColour)
{
  const double f = (65.5 + 16.0) / 116.0;
  const double x = 0.95047 * std::pow(f + 8.8 / 500.0, 3);
  const double y = std::pow(f, 3);
  const double z = 1.08883 * std::pow(f - 20.7 / 200.0, 3);
  const std::array<double, 3> rgb{ 3.2406 * x - 1.5372 * y - 0.4986 * z,
    -0.9689 * x + 1.8758 * y + 0.0415 * z, 0.0557 * x - 0.2040 * y + 1.0570 * z };
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(Plane());
  filter->SetPreset(vtkSurfaceMaterial::WOOD);
  filter->Update();
  for (int c = 0; c < 3; ++c)
  {
    const double value = Value(filter->GetOutput(), "DiffuseReflectance", 0, c);
    EXPECT_TRUE(std::abs(value - rgb[static_cast<std::size_t>(c)]) < 0.005) << "wood is oak";
  }
}

TEST(SurfaceMaterialPresets, GlassTransmitsWhatItsSourceSays)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(Plane());
  filter->SetPreset(vtkSurfaceMaterial::CLEAR_GLASS);
  filter->Update();
  const double index = Value(filter->GetOutput(), "RefractiveIndex");
  const double internal = Value(filter->GetOutput(), "ClearTransmittance");
  // EnergyPlus, CLEAR 6MM: 0.881 and 0.080; the internal transmittance has two digits, so 0.005.
  const Pane straight = PaneAt(1.0, index, internal);
  EXPECT_LT(std::abs(straight.transmittance - 0.881), 0.005) << "clear glass transmits 0.881";
  EXPECT_LT(std::abs(straight.reflectance - 0.080), 0.005) << "clear glass reflects 0.080";

  Pane diffuse{ 0.0, 0.0 };
  const int steps = 1000; // midpoint rule in cosine^2, far finer than two digits
  for (int i = 0; i < steps; ++i)
  {
    const Pane pane = PaneAt(std::sqrt((i + 0.5) / steps), index, internal);
    diffuse.transmittance += pane.transmittance / steps;
    diffuse.reflectance += pane.reflectance / steps;
  }
  filter->SetPreset(vtkSurfaceMaterial::FROSTED_GLASS);
  filter->Update();
  vtkPolyData* frosted = filter->GetOutput();
  EXPECT_TRUE(std::abs(Value(frosted, "DiffuseTransmittance") - diffuse.transmittance) < 0.005 &&
    std::abs(Value(frosted, "DiffuseReflectance") - diffuse.reflectance) < 0.005)
    << "frosted glass is clear glass without direction";
}
