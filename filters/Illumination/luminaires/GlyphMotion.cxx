// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/GlyphMotion.h"

#include "Illumination/pipeline/InputError.h"

#include "vtkLandmarkTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace Illumination
{
namespace
{

using Points = std::vector<glm::dvec3>;

constexpr double Tolerance = 1e-3;      ///< Of the points' size.
constexpr double Flat = 1e-9;           ///< Thinner than this, of the points' size.
constexpr double LargestSize = 1e100;   ///< Whose square is finite.
constexpr double SmallestSize = 1e-100; ///< Whose square is not 0.

/// The points relative to the first one, so that a place far away costs no digits.
Points Relative(const Points& points, double sign)
{
  Points relative;
  for (const glm::dvec3& point : points)
  {
    relative.push_back(sign * (point - points.front()));
  }
  return relative;
}

double Size(const Points& relative)
{
  double size = 0.0;
  for (const glm::dvec3& point : relative)
  {
    // Negated, so that NaN is not passed over.
    size = !(glm::length(point) <= size) ? glm::length(point) : size;
  }
  return size;
}

vtkSmartPointer<vtkPoints> Landmarks(const Points& points)
{
  auto landmarks = vtkSmartPointer<vtkPoints>::New();
  landmarks->SetDataTypeToDouble();
  for (const glm::dvec3& point : points)
  {
    landmarks->InsertNextPoint(point.x, point.y, point.z);
  }
  return landmarks;
}

struct Fit
{
  glm::dmat3 linear;
  glm::dvec3 shift;
  double error; ///< The largest distance that is left.
};

/// The best rotation, uniform scale and translation (Horn).
Fit BestFit(const Points& was, const Points& is)
{
  vtkNew<vtkLandmarkTransform> horn;
  horn->SetModeToSimilarity();
  horn->SetSourceLandmarks(Landmarks(was));
  horn->SetTargetLandmarks(Landmarks(is));
  horn->Update();
  vtkMatrix4x4* matrix = horn->GetMatrix();
  Fit fit{};
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      fit.linear[column][row] = matrix->GetElement(row, column);
    }
    fit.shift[row] = matrix->GetElement(row, 3);
  }
  for (std::size_t i = 0; i < was.size(); ++i)
  {
    fit.error = std::max(fit.error, glm::length(fit.linear * was[i] + fit.shift - is[i]));
  }
  return fit;
}

} // namespace

PhotonTransport::Similarity FindMotion(const Points& was, const Points& is)
{
  PhotonTransport::Similarity motion;
  if (was == is)
  {
    return motion;
  }
  motion.isNone = false;
  motion.before = was.front();
  const Points from = Relative(was, 1.0);
  const Points to = Relative(is, 1.0);
  const double sizeBefore = Size(from);
  const double size = Size(to);
  if (sizeBefore == 0.0 && size == 0.0)
  {
    motion.after = is.front();
    return motion;
  }
  if (!(size <= LargestSize))
  {
    throw InputError("its points are not finite, or too far apart");
  }
  if (!(size >= SmallestSize))
  {
    throw InputError(
      "its points were all moved to one place, so that nothing says how it is turned");
  }
  const Fit proper = BestFit(from, to);
  Fit mirrored = BestFit(from, Relative(is, -1.0)); // a mirror image is a point reflection, turned
  motion.mirrors = !(proper.error <= std::max(mirrored.error, Flat * size));
  const Fit& best = motion.mirrors ? mirrored : proper;
  const double scale = std::cbrt(std::fabs(glm::determinant(best.linear)));
  if (!(best.error <= Tolerance * size) || !(scale > 0.0))
  {
    throw InputError(
      "its points were not only turned, moved, scaled evenly or mirrored, but scaled "
      "unevenly, sheared or bent, or rounded off far from the origin, by " +
      std::to_string(100.0 * best.error / size) +
      " % of its size; place it by a rotation, a translation and a uniform scale");
  }
  const double sign = motion.mirrors ? -1.0 : 1.0;
  motion.scale = scale;
  motion.turn = best.linear * (sign / scale);
  motion.after = is.front() + sign * best.shift;
  return motion;
}

} // namespace Illumination
