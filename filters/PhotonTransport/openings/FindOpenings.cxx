// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/FindOpenings.h"

#include "PhotonTransport/openings/OpeningPolygons.h"
#include "PhotonTransport/openings/SkyView.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace PhotonTransport
{
namespace
{

/// No more polygons than these are looked at.
constexpr std::size_t MostPolygons = 4 * MostOpenings;
/// A polygon sees the sky if so many of SkyRays do.
constexpr std::size_t LeastSky = SkyRays / 32;
/// By how many offsets of rays (OriginOffset) the openings of panes lie outside of them: rays start
/// about one offset from a pane.
constexpr float OutsidePane = 4.0f;
/// Two openings that face alike are one if they are closer than this, relative to the root of the
/// area: a pane in its reveal, the panes of a double window.
constexpr float CloseBy = 0.125f;
/// Cosine of the angle within which they face alike.
constexpr float FacingAlike = 0.99f;

OpeningPolygon Turned(const OpeningPolygon& polygon)
{
  std::vector<Opening::Triangle> triangles = polygon.shape.triangles;
  for (Opening::Triangle& triangle : triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return { MakeOpening(std::move(triangles), -polygon.shape.normal, polygon.shape.kind),
    polygon.below, polygon.above };
}

/// The openings of panes lie outside of them.
Opening InPlace(const OpeningPolygon& polygon, const Scene& scene)
{
  const Opening& opening = polygon.shape;
  if (opening.kind == OpeningKind::Hole)
  {
    return opening;
  }
  float reach = 0.0f;
  for (const Opening::Triangle& triangle : opening.triangles)
  {
    for (const glm::vec3& corner : triangle)
    {
      reach = std::max(reach, scene.Reach(corner));
    }
  }
  const float outside = polygon.below + OutsidePane * OriginOffset * reach;
  const glm::vec3 outwards = -outside * opening.normal;
  std::vector<Opening::Triangle> triangles = opening.triangles;
  for (Opening::Triangle& triangle : triangles)
  {
    for (glm::vec3& corner : triangle)
    {
      corner += outwards;
    }
  }
  return MakeOpening(std::move(triangles), opening.normal, opening.kind);
}

/// Whether most of an opening lies closely in front of another one or behind it.
bool IsDoubled(const Opening& opening, const Opening& other)
{
  if (glm::dot(opening.normal, other.normal) < FacingAlike)
  {
    return false;
  }
  constexpr int Side = 8; // of a square of points
  const float near = CloseBy * std::sqrt(opening.Area());
  const Openings others({ other });
  int doubled = 0;
  for (int i = 0; i < Side * Side; ++i)
  {
    const float u = (static_cast<float>(i % Side) + 0.5f) / Side;
    const float v = (static_cast<float>(i / Side) + 0.5f) / Side;
    const Ray ray{ opening.PointAt(u, v) - near * opening.normal, opening.normal };
    doubled += others.FirstCrossing(ray, true, 2.0f * near) ? 1 : 0;
  }
  return 2 * doubled > Side * Side;
}

bool IsDoubled(const Opening& opening, const std::vector<Opening>& others)
{
  return std::any_of(
    others.begin(), others.end(), [&](const Opening& other) { return IsDoubled(opening, other); });
}

/// Decides which polygons are openings.
class Choice
{
public:
  Choice(const Scene& scene, const std::function<bool(const glm::vec3&)>& isSky)
    : Prepared(scene)
    , IsSky(isSky)
  {
  }

  /// A polygon close in front of a pane or behind it, such as the hole in which it stands, is none.
  void Refuse(const OpeningPolygon& pane)
  {
    this->Refused.push_back(pane.shape);
    this->Refused.push_back(Turned(pane).shape);
  }

  void Consider(const OpeningPolygon& polygon)
  {
    if (IsDoubled(polygon.shape, this->Refused))
    {
      return;
    }
    if (this->Chosen.size() == MostOpenings || this->Considered == MostPolygons)
    {
      ++this->Notes.tooMany;
      return;
    }
    ++this->Considered;
    const SkyView view = ViewOfSky(polygon.shape, this->Prepared, this->IsSky);
    if (2 * view.covered > SkyRays)
    {
      ++this->Notes.covered;
    }
    else if (std::max(view.front, view.back) < LeastSky)
    {
      ++this->Notes.withoutSky;
    }
    else if (2 * std::min(view.front, view.back) > std::max(view.front, view.back))
    {
      ++this->Notes.openToBothSides;
    }
    else
    {
      this->Keep(view.front > view.back ? Turned(polygon) : polygon);
    }
  }

  OpeningNotes Notes;
  std::vector<Opening> Chosen;

private:
  void Keep(const OpeningPolygon& polygon)
  {
    if (IsDoubled(polygon.shape, this->Chosen))
    {
      ++this->Notes.doubled;
    }
    else
    {
      this->Chosen.push_back(InPlace(polygon, this->Prepared));
    }
  }

  const Scene& Prepared;
  const std::function<bool(const glm::vec3&)>& IsSky;
  std::vector<Opening> Refused;
  std::size_t Considered = 0;
};

} // namespace

FoundOpenings FindOpenings(
  const Surface& surface, const Scene& scene, const std::function<bool(const glm::vec3&)>& isSky)
{
  Choice choice(scene, isSky);
  for (const OpeningPolygon& pane : RefusedPolygonsOf(surface, scene))
  {
    choice.Refuse(pane);
  }
  for (const OpeningPolygon& polygon : OpeningPolygonsOf(surface, scene))
  {
    choice.Consider(polygon);
  }
  for (std::size_t f = 0; f < surface.openingOfFacet.size(); ++f)
  {
    if (surface.openingOfFacet[f] == OpeningMark::Opening && !PassesStraightOn(surface, f))
    {
      choice.Notes.opaqueMarks.Add(f);
    }
  }
  return { Openings(std::move(choice.Chosen)), choice.Notes };
}

} // namespace PhotonTransport
