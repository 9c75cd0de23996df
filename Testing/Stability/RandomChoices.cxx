// SPDX-License-Identifier: BSD-3-Clause
#include "RandomChoices.h"

#include <rapidcheck.h>

int Below(int end)
{
  return *rc::gen::inRange(0, end);
}

bool OneIn(int many)
{
  return Below(many) == many - 1;
}

double Anywhere()
{
  constexpr int Steps = 1 << 20;
  return static_cast<double>(*rc::gen::inRange(-Steps, Steps + 1)) / Steps;
}

double LatticePlace()
{
  return 0.5 * (Below(5) - 2);
}

static double Coordinate()
{
  switch (Below(8))
  {
    case 0:
    case 1:
      return Anywhere();
    case 2: // almost on the lattice: needles, slivers, sheets that nearly coincide
      return LatticePlace() + OneOf({ 1e-5, 1e-7, 1e-9, 1e-16 }) * Anywhere();
    case 3:
      return OneOf({ 1e-3, 1e-12, 1e-25, 1e-40 }) * Anywhere();
    default:
      return LatticePlace();
  }
}

glm::dvec3 Place()
{
  const double x = Coordinate();
  const double y = Coordinate();
  return { x, y, Coordinate() };
}

glm::dvec3 Direction()
{
  const glm::dvec3 along(LatticePlace(), LatticePlace(), LatticePlace());
  switch (Below(4))
  {
    case 0: // almost along an axis
      return { 1e-9 * Anywhere(), 1.0, 1e-9 * Anywhere() };
    case 1:
      return OneOf({ 1e-200, 1e-20, 1.0, 1e200 }) * glm::dvec3(1.0, Anywhere(), Anywhere());
    default:
      return along == glm::dvec3(0.0) ? glm::dvec3(0.0, 0.0, -1.0) : along;
  }
}
