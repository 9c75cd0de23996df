// SPDX-License-Identifier: BSD-3-Clause
// The properties of Surface Material and Illumination Map in ParaView agree with the core's table
// of material properties: names, numbers of components, ranges and defaults.
#include "PhotonTransport/materials/MaterialProperties.h"

#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <gtest/gtest.h>

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

void CheckRange(vtkXMLDataElement* xml, const MaterialProperty& property)
{
  vtkXMLDataElement* range = xml->FindNestedElementWithName("DoubleRangeDomain");
  if (!range)
  {
    EXPECT_TRUE(xml->FindNestedElementWithName("BooleanDomain") && RangeOf(property) == "0 or 1")
      << property.name << " has a range or is a flag";
    return;
  }
  double least = -1.0;
  double largest = -1.0;
  range->GetScalarAttribute("min", least);
  range->GetScalarAttribute("max", largest);
  EXPECT_TRUE((property.aboveLeast ? least > property.least : least == property.least) &&
    largest == property.largest)
    << property.name << " has the range that its help in ParaView offers";
}

/// @param preset What the file's default stands for.
void CheckProperty(vtkXMLDataElement* xml, const std::string& name,
  const MaterialProperty& property, const float* preset)
{
  CheckRange(xml, property);
  std::vector<double> defaults(3, -1.0);
  const int count = xml->GetVectorAttribute("default_values", 3, defaults.data());
  EXPECT_TRUE(count == 1 || count == ComponentsOf(property))
    << name << " has as many values as its array";
  for (int c = 0; c < count; ++c)
  {
    EXPECT_EQ(static_cast<float>(defaults[static_cast<std::size_t>(c)]), preset[c])
      << name << " has the default of the filter";
  }
}

vtkXMLDataElement* Parsed(vtkXMLDataParser* parser, const char* file)
{
  parser->SetFileName((std::string(ILLUMINATION_XML) + "/" + file).c_str());
  return parser->Parse() ? parser->GetRootElement() : nullptr;
}

} // namespace

TEST(MaterialProperties, InParaViewAreThoseOfTheCore)
{
  // What both filters start with: grey, and glass where something is clear.
  Material start;
  start.diffuseReflectance = Colour(0.5f);
  start.refractiveIndex = 1.5f;
  const MaterialValues values = ValuesOf(start);
  EXPECT_EQ(ValuesOf(MaterialOf(values)), values) << "values make the material that they are of";
  EXPECT_TRUE(ProblemOf(start).empty()) << "the default is a material";
  for (const char* file : { "SurfaceMaterial.xml", "IlluminationMap.xml" })
  {
    vtkNew<vtkXMLDataParser> parser;
    vtkXMLDataElement* root = Parsed(parser, file);
    EXPECT_NE(root, nullptr) << file << " can be read";
    for (std::size_t p = 0; root && p < MaterialProperties.size(); ++p)
    {
      // Illumination Map has properties for surfaces without arrays, but need not have all.
      const bool map = std::string(file) == "IlluminationMap.xml";
      const std::string name = p == 0 && map ? "Reflectance" : MaterialProperties[p].name;
      vtkXMLDataElement* xml = PropertyNamed(root, name);
      EXPECT_TRUE(xml || map) << name << " is a property of Surface Material";
      if (xml)
      {
        CheckProperty(xml, name, MaterialProperties[p], &values[3 * p]);
      }
    }
  }
}
