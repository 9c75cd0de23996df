// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Ray.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// Why a polygon is an opening.
enum class OpeningKind
{
  Hole,  ///< The mesh has a hole there.
  Glass, ///< Facets there let light straight through.
  Marked ///< As Glass, and the user says that it is one.
};

/// A flat polygon through which outdoor light enters. Those of facets lie a little outside of them,
/// so that light from outdoors crosses the opening first and then meets the pane. Scene
/// coordinates.
struct Opening
{
  using Triangle = std::array<glm::vec3, 3>;

  std::vector<Triangle> triangles; ///< Beside each other, counter-clockwise as seen from indoors.
  std::vector<float> areas;        ///< Of all triangles up to each, its own included.
  glm::vec3 normal{ 0.0f };        ///< Unit, inwards.
  glm::vec3 centre{ 0.0f };        ///< Of a ball around it.
  float radius = 0.0f;
  OpeningKind kind = OpeningKind::Hole;

  float Area() const { return this->areas.back(); }
  /// A point uniform by area, for two numbers in [0, 1).
  glm::vec3 PointAt(float u, float v) const;
};

/// @param triangles One or more, flat, counter-clockwise about the normal.
Opening MakeOpening(
  std::vector<Opening::Triangle> triangles, const glm::vec3& normal, OpeningKind kind);

/// So many openings are used at most, the largest ones: they are few, so that all can be asked.
constexpr std::size_t MostOpenings = 64;

/// Where a ray crosses an opening.
struct OpeningCrossing
{
  std::size_t opening;
  float distance; ///< From the ray's origin.
};

/// All openings of a scene.
class Openings
{
public:
  Openings() = default;
  explicit Openings(std::vector<Opening> all)
    : All(std::move(all))
  {
  }

  const std::vector<Opening>& List() const { return this->All; }
  bool IsEmpty() const { return this->All.empty(); }

  /// The first opening that a ray crosses in one sense.
  /// @param inwards Whether it is to be crossed from outdoors to indoors, or the other way.
  /// @param end Only what lies before this distance from the origin counts, such as the ray's hit.
  std::optional<OpeningCrossing> FirstCrossing(
    const Ray& ray, bool inwards, float end = std::numeric_limits<float>::infinity()) const;

private:
  std::vector<Opening> All;
};

} // namespace PhotonTransport
