// SPDX-License-Identifier: BSD-3-Clause
// A lamp from the properties of a filter.
#ifndef LampProperties_h
#define LampProperties_h

#include "PhotonTransport/photometry/PhotometricSolid.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <map>
#include <string>
#include <utility>

namespace Illumination
{

/// Gives a lamp its values (see PhotonTransport::DescribedLamp). Each comes from a function, under
/// the name and in the unit of the field array that holds it; so only those are asked, and may
/// throw for what is out of range, which the kind of lamp has.
class LampProperties
{
public:
  /// A component of the value; 0 for a number.
  using Value = std::function<double(int component)>;

  /// @param solid Gives the photometric solid, for a filter that has one.
  explicit LampProperties(std::map<std::string, Value> values,
    std::function<PhotonTransport::PhotometricSolid()> solid = {})
    : Values(std::move(values))
    , Solid(std::move(solid))
  {
  }
  void operator()(const char* name, double& number) const { number = this->Values.at(name)(0); }
  void operator()(const char* name, int& number, int, int) const
  {
    number = static_cast<int>(this->Values.at(name)(0));
  }
  void operator()(const char* name, bool& is) const { is = this->Values.at(name)(0) != 0.0; }
  void operator()(const char* name, glm::dvec2& v) const
  {
    const Value& value = this->Values.at(name);
    v = { value(0), value(1) };
  }
  void operator()(const char* name, glm::dvec3& v) const
  {
    const Value& value = this->Values.at(name);
    v = { value(0), value(1), value(2) };
  }
  void operator()(const char*, PhotonTransport::PhotometricSolid& solid) const
  {
    solid = this->Solid();
  }

private:
  std::map<std::string, Value> Values;
  std::function<PhotonTransport::PhotometricSolid()> Solid;
};

} // namespace Illumination

#endif
