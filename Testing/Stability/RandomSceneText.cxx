// SPDX-License-Identifier: BSD-3-Clause
#include "RandomScene.h"

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

void Describe(std::ostream& out, const Material& m)
{
  out << "diffuse " << glm::dvec3(m.diffuseReflectance) << " specular "
      << glm::dvec3(m.specularReflectance) << " glossy " << glm::dvec3(m.glossyReflectance)
      << " through " << glm::dvec3(m.diffuseTransmittance) << " clear "
      << glm::dvec3(m.clearTransmittance) << " roughness " << m.roughness << " index "
      << m.refractiveIndex << (m.solid ? " solid" : " pane");
}

struct DescribeLamp
{
  std::ostream& out;
  void operator()(const ParallelLight& l) const
  {
    out << "parallel " << l.direction << ' ' << l.illuminance << " lx";
  }
  void operator()(const PointLamp& l) const { out << "point " << l.position << ' ' << l.flux; }
  void operator()(const LambertianPointLamp& l) const
  {
    out << "Lambertian " << l.position << ' ' << l.direction << ' ' << l.flux;
  }
  void operator()(const SpotLamp& l) const
  {
    out << "spot " << l.position << ' ' << l.direction << ' ' << l.halfAngle << " rad, exponent "
        << l.exponent << ' ' << l.flux;
  }
  void operator()(const RectangleLamp& l) const
  {
    out << "rectangle " << l.centre << ' ' << l.direction << ' ' << l.width << " x " << l.height
        << ' ' << l.flux;
  }
  void operator()(const DiskLamp& l) const
  {
    out << "disk " << l.centre << ' ' << l.direction << ' ' << l.radius << ' ' << l.flux;
  }
  void operator()(const EmittingFacets&) const { out << "facets"; }
  void operator()(const UniformSky& l) const
  {
    out << "sky " << l.up << ' ' << l.luminance << (l.wholeSphere ? " whole" : " half");
  }
  void operator()(const CieSky& l) const
  {
    out << "CIE sky " << l.type << ' ' << l.up << " sun " << l.sun << ' ' << l.horizontalIlluminance
        << " lx";
  }
  void operator()(const SphereLamp& l) const
  {
    out << "sphere " << l.centre << ' ' << l.radius << ' ' << l.flux;
  }
  void operator()(const LineLamp& l) const
  {
    out << "line " << l.centre << ' ' << l.axis << ' ' << l.length << ' ' << l.flux;
  }
  void operator()(const PhotometricLamp& l) const
  {
    out << "photometric " << l.position << ' ' << l.direction << " turned " << l.rotation
        << " times " << l.scale << " type " << static_cast<int>(l.solid.type) << ", polar"
        << l.solid.polar << ", azimuth" << l.solid.azimuth << ", candela" << l.solid.candela;
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
    out << "\n  material ";
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
             << ", back " << s.registerBackSide << ", bound " << s.weightBound << ", longest path "
             << s.maximumPathLength << ", threads " << s.threads
             << "\n  mistake: " << (scene.mistake.empty() ? "none" : scene.mistake);
}
