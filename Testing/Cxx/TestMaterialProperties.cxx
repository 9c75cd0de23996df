// SPDX-License-Identifier: BSD-3-Clause
// The properties of Surface Material and Illumination Map in ParaView agree with the core's table
// of material properties: names, numbers of components, ranges and defaults.
#include "TestTools.h"

#include "PhotonTransport/materials/MaterialProperties.h"

#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <cmath>

namespace
{

using namespace PhotonTransport;

vtkXMLDataElement* PropertyNamed(vtkXMLDataElement* element, const std::string& name)
{
  vtkXMLDataElement* found = nullptr;
  for (int i = 0; i < element->GetNumberOfNestedElements() && !found; ++i)
  {
    vtkXMLDataElement* child = element->GetNestedElement(i);
    const std::string kind = child->GetName();
    const bool isProperty = kind == "DoubleVectorProperty" || kind == "IntVectorProperty";
    found = isProperty && child->GetAttribute("name") == name ? child : PropertyNamed(child, name);
  }
  return found;
}

void CheckRange(vtkXMLDataElement* xml, const MaterialProperty& property, Checks& check)
{
  vtkXMLDataElement* range = xml->FindNestedElementWithName("DoubleRangeDomain");
  if (!range)
  {
    check(xml->FindNestedElementWithName("BooleanDomain") && RangeOf(property) == "0 or 1",
      std::string(property.name) + " has a range or is a flag");
    return;
  }
  double least = -1.0;
  double largest = -1.0;
  range->GetScalarAttribute("min", least);
  range->GetScalarAttribute("max", largest);
  check((property.aboveLeast ? least > property.least : least == property.least) &&
      largest == property.largest,
    std::string(property.name) + " has the range that its help in ParaView offers");
}

/// @param name Of the property in the file. @param preset What the file's default stands for.
void CheckProperty(vtkXMLDataElement* file, const std::string& name,
  const MaterialProperty& property, const float* preset, Checks& check)
{
  vtkXMLDataElement* xml = PropertyNamed(file, name);
  check(xml != nullptr, name + " is a property");
  if (!xml)
  {
    return;
  }
  CheckRange(xml, property, check);
  std::vector<double> defaults(3, -1.0);
  const int count = xml->GetVectorAttribute("default_values", 3, defaults.data());
  check(count == 1 || count == ComponentsOf(property), name + " has as many values as its array");
  for (int c = 0; c < count; ++c)
  {
    check(static_cast<float>(defaults[static_cast<std::size_t>(c)]) == preset[c],
      name + " has the default of the filter");
  }
}

vtkXMLDataElement* Parsed(vtkXMLDataParser* parser, const char* file)
{
  parser->SetFileName((std::string(ILLUMINATION_XML) + "/" + file).c_str());
  return parser->Parse() ? parser->GetRootElement() : nullptr;
}

} // namespace

int TestMaterialProperties(int, char*[])
{
  Checks check;
  // What both filters start with: grey, and glass where something is clear.
  Material start;
  start.diffuseReflectance = Colour(0.5f);
  start.refractiveIndex = 1.5f;
  const MaterialValues values = ValuesOf(start);
  check(ValuesOf(MaterialOf(values)) == values, "values make the material that they are of");
  check(ProblemOf(start).empty(), "the default is a material");
  for (const char* file : { "SurfaceMaterial.xml", "IlluminationMap.xml" })
  {
    vtkNew<vtkXMLDataParser> parser;
    vtkXMLDataElement* root = Parsed(parser, file);
    check(root != nullptr, std::string(file) + " can be read");
    for (std::size_t p = 0; root && p < MaterialProperties.size(); ++p)
    {
      const bool shorter = p == 0 && std::string(file) == "IlluminationMap.xml";
      CheckProperty(root, shorter ? "Reflectance" : MaterialProperties[p].name,
        MaterialProperties[p], &values[3 * p], check);
    }
  }
  return check.Failures();
}
