// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/LampChecks.h"

#include "PhotonTransport/geometry/Similarity.h"
#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/scene/InvalidInput.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace PhotonTransport
{
namespace
{

/// Scene units. Embree ends the process at a ray that starts beyond 1.8e18, where squares leave the
/// range of a float; a panel's point is the sum of three lengths.
constexpr double Farthest = 0x1p59;

std::string Text(const glm::dvec3& v)
{
  std::ostringstream text;
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

void RefuseLamp(const std::string& message)
{
  throw InvalidInput(InvalidInput::Where::LampSettings, 0, message);
}

std::string Text(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

double CheckedAmount(double amount, const char* what)
{
  if (!(amount >= 0.0) || !std::isfinite(amount))
  {
    RefuseLamp(std::string(what) + " " + Text(amount) + " is not a finite number >= 0");
  }
  return amount;
}

double CheckedLength(double length, const Scene& scene, const char* what)
{
  const double inScene = scene.GetPlacement().LengthToScene(CheckedAmount(length, what));
  if (!(inScene <= Farthest))
  {
    RefuseLamp(std::string(what) + " " + Text(length) + " is more than " + Text(Farthest) +
      " times the size of the surface");
  }
  return inScene;
}

glm::dvec3 CheckedPosition(const glm::dvec3& position, const Scene& scene)
{
  if (!IsFinite(position))
  {
    RefuseLamp("lamp position " + Text(position) + " is not finite");
  }
  const glm::dvec3 inScene = scene.GetPlacement().PointToScene(position);
  if (!(std::max({ std::fabs(inScene.x), std::fabs(inScene.y), std::fabs(inScene.z) }) <= Farthest))
  {
    RefuseLamp("lamp position " + Text(position) + " is more than " + Text(Farthest) +
      " times the size of the surface away from it");
  }
  return inScene;
}

glm::dvec3 ClearPosition(const glm::dvec3& position, const Scene& scene, const glm::dvec3& aim)
{
  const glm::dvec3 place = CheckedPosition(position, scene);
  return place + WayClearOfFacets(scene, { place }, aim);
}

glm::dvec3 CheckedDirection(const glm::dvec3& direction, const char* what)
{
  if (!IsFinite(direction) || direction == glm::dvec3(0.0))
  {
    RefuseLamp(
      what + (" " + Text(direction)) + " has no direction: it must be finite and not zero");
  }
  return Unit(direction);
}

} // namespace PhotonTransport
