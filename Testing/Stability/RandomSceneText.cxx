// SPDX-License-Identifier: BSD-3-Clause
#include "RandomScene.h"

#include "PhotonTransport/materials/MaterialProperties.h"

#include <limits>
#include <ostream>

namespace
{

using namespace PhotonTransport;

std::ostream& operator<<(std::ostream& out, const glm::dvec3& v)
{
  return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
}

std::ostream& operator<<(std::ostream& out, const std::vector<double>& values)
{
  for (const double value : values)
  {
    out << ' ' << value;
  }
  return out;
}

void Describe(std::ostream& out, const Material& material)
{
  const MaterialValues values = ValuesOf(material);
  for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
  {
    out << ' ' << MaterialProperties[p].name;
    for (int c = 0; c < ComponentsOf(MaterialProperties[p]); ++c)
    {
      out << ' ' << values[3 * p + static_cast<std::size_t>(c)];
    }
  }
}

/// Writes the values that describe a lamp; see LampKind.h.
struct WriteFields
{
  std::ostream& out;

  template <typename Value, typename... Range>
  void operator()(const char* name, const Value& value, const Range&...) const
  {
    this->out << ' ' << name << ' ' << value;
  }
  void operator()(const char* name, const glm::dvec2& v) const
  {
    this->out << ' ' << name << " (" << v.x << ", " << v.y << ')';
  }
  void operator()(const char*, const PhotometricSolid& solid) const
  {
    this->out << " type " << static_cast<int>(solid.type) << ", polar" << solid.polar << ", azimuth"
              << solid.azimuth << ", candela" << solid.candela;
  }
};

struct DescribeLamp
{
  std::ostream& out;

  template <class AnyLamp>
  void operator()(AnyLamp lamp) const
  {
    this->out << (AnyLamp::Name ? AnyLamp::Name : "facets");
    lamp.Describe(WriteFields{ this->out });
  }
  void operator()(const EmittingMesh& l) const
  {
    out << "mesh of";
    for (const glm::dvec3& point : l.points)
    {
      out << ' ' << point;
    }
    for (std::size_t f = 0; f < l.facets.size() && f < l.exitance.size(); ++f)
    {
      out << "; " << glm::dvec3(l.facets[f]) << " exitance " << l.exitance[f];
    }
  }
};

} // namespace

std::ostream& operator<<(std::ostream& out, const RandomScene& scene)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  const Surface& surface = scene.surface;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    out << "\n  point " << p << ' ' << surface.points[p];
    if (p < surface.normals.size())
    {
      out << " normal " << surface.normals[p];
    }
  }
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
  {
    const glm::uvec3& ids = surface.facets[f];
    out << "\n  facet " << ids.x << ' ' << ids.y << ' ' << ids.z;
    if (f < surface.materialOfFacet.size())
    {
      out << " material " << surface.materialOfFacet[f];
    }
    if (!surface.exitance.empty())
    {
      out << " exitance " << glm::dvec3(surface.exitance[f]);
    }
  }
  for (const Material& material : surface.materials)
  {
    out << "\n  material";
    Describe(out, material);
  }
  out << "\n  " << surface.metresPerUnit << " m per unit";
  for (const Luminaire& luminaire : scene.lighting.luminaires)
  {
    out << "\n  lamp '" << luminaire.name << "' of colour " << glm::dvec3(luminaire.colour) << ": ";
    std::visit(DescribeLamp{ out }, luminaire.lamp);
  }
  const TraceSettings& s = scene.settings;
  return out << "\n  seed " << s.seed << ", sampling " << static_cast<int>(s.sampling)
             << ", registration " << static_cast<int>(s.registration) << ", scatterings "
             << s.scatterings << ", colour " << s.colour << ", lamps apart " << s.lampsApart
             << ", back " << s.registerBackSide << ", curved " << s.curvedSurface << ", bound "
             << s.weightBound << ", longest path " << s.maximumPathLength << ", threads "
             << s.threads << ", method " << static_cast<int>(s.method)
             << "\n  mistake: " << (scene.mistake.empty() ? "none" : scene.mistake);
}
