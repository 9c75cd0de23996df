// SPDX-License-Identifier: BSD-3-Clause
// The settings that a map remembers as field data, for filters that need the same scene and light.
#include "vtkIlluminationMap.h"

#include "Illumination/pipeline/FieldArrays.h"

#include "vtkFieldData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace Illumination;

namespace
{

constexpr const char* ArrayOfSettings = "IlluminationMapSettings";
constexpr const char* OwnLamp = "OwnLamp";

/// A property by its name, as text.
struct Setting
{
  std::string name;
  std::function<void(std::ostream&)> write;
  std::function<void(std::istream&)> read;
};

template <class Value, class Set>
Setting NumberSetting(const char* name, Value value, Set set)
{
  return { name, [=](std::ostream& out) { out << value; },
    [=](std::istream& in)
    {
      Value read{};
      if (in >> read)
      {
        set(read);
      }
    } };
}

/// @param get Gives `components` numbers.
template <class Get, class Set>
Setting VectorSetting(const char* name, int components, Get get, Set set)
{
  return { name,
    [=](std::ostream& out)
    {
      for (int c = 0; c < components; ++c)
      {
        out << (c > 0 ? " " : "") << get()[c];
      }
    },
    [=](std::istream& in)
    {
      std::vector<double> read(static_cast<std::size_t>(components));
      for (double& number : read)
      {
        in >> number;
      }
      if (in)
      {
        set(read.data());
      }
    } };
}

/// The rest of the line.
template <class Set>
Setting TextSetting(const char* name, const char* value, Set set)
{
  const std::string text = value ? value : "";
  return { name, [=](std::ostream& out) { out << text; },
    [=](std::istream& in)
    {
      std::string read;
      std::getline(in >> std::ws, read);
      set(read.c_str());
    } };
}

#define NUMBER(name)                                                                               \
  NumberSetting(#name, map->Get##name(), [map](auto value) { map->Set##name(value); })
#define VECTOR(name, components)                                                                   \
  VectorSetting(                                                                                   \
    #name, components, [map] { return map->Get##name(); },                                         \
    [map](double* value) { map->Set##name(value); })
#define TEXT(name)                                                                                 \
  TextSetting(#name, map->Get##name(), [map](const char* value) { map->Set##name(value); })

/// Those on which the scene and the light depend.
std::vector<Setting> SettingsOf(vtkIlluminationMap* map)
{
  return { NUMBER(LampType), VECTOR(LampPosition, 3), VECTOR(LampDirection, 3), VECTOR(LampSize, 2),
    NUMBER(SpotHalfAngle), NUMBER(SpotExponent), NUMBER(LuminousFlux), NUMBER(ParallelIlluminance),
    TEXT(ExitanceArray), NUMBER(Reflectance), TEXT(ReflectanceArray), NUMBER(SpecularReflectance),
    NUMBER(GlossyReflectance), NUMBER(DiffuseTransmittance), NUMBER(ClearTransmittance),
    NUMBER(Roughness), NUMBER(RefractiveIndex), NUMBER(SolidBody), NUMBER(UseMaterialArrays),
    NUMBER(Interreflection), NUMBER(SpecularReflection), NUMBER(GlossyReflection),
    NUMBER(DiffuseTransmission), NUMBER(ClearTransmission), NUMBER(Refraction), NUMBER(Colour),
    NUMBER(CurvedSurface), NUMBER(MetresPerUnit), NUMBER(FeatureAngle), NUMBER(MaximumPathLength) };
}

#undef NUMBER
#undef VECTOR
#undef TEXT

} // namespace

void vtkIlluminationMap::RememberSettings(vtkFieldData* output, bool ownLamp)
{
  std::vector<std::string> lines;
  for (const Setting& setting : SettingsOf(this))
  {
    std::ostringstream line;
    line.precision(std::numeric_limits<double>::max_digits10);
    line << setting.name << " ";
    setting.write(line);
    lines.push_back(line.str());
  }
  lines.push_back(std::string(OwnLamp) + (ownLamp ? " 1" : " 0"));
  AddArray(output, ArrayOfSettings, lines);
}

bool vtkIlluminationMap::RecallSettings(vtkFieldData* output, bool& ownLamp)
{
  auto* lines = vtkStringArray::SafeDownCast(output->GetAbstractArray(ArrayOfSettings));
  for (vtkIdType i = 0; lines && i < lines->GetNumberOfValues(); ++i)
  {
    std::istringstream line(lines->GetValue(i));
    std::string name;
    line >> name;
    if (name == OwnLamp)
    {
      line >> ownLamp;
    }
    for (const Setting& setting : SettingsOf(this))
    {
      if (setting.name == name)
      {
        setting.read(line);
      }
    }
  }
  return lines != nullptr;
}
