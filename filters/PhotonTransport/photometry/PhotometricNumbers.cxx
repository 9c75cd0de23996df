// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/PhotometricNumbers.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

void RequireManageable(const TextReader& reader, std::size_t planes, std::size_t angles)
{
  if (planes * angles > MostIntensities)
  {
    reader.Fail("there are " + std::to_string(planes) + " x " + std::to_string(angles) +
      " angles; there must be at most " + std::to_string(MostIntensities));
  }
}

std::vector<double> ReadAngles(TextReader& reader, const char* name, std::size_t count,
  double smallest, double largest, const std::function<void(double)>& requireFirst)
{
  std::vector<double> angles;
  for (std::size_t i = 1; i <= count; ++i)
  {
    angles.push_back(reader.NextNumber({ name, i }, smallest, largest));
    if (i == 1 && requireFirst)
    {
      requireFirst(angles[0]);
    }
    if (i > 1 && !(angles[i - 1] > angles[i - 2]))
    {
      reader.Refuse({ name, i }, "angles must rise");
    }
  }
  return angles;
}

std::vector<double> ReadIntensities(
  TextReader& reader, const char* name, std::size_t count, double factor)
{
  std::vector<double> candela; // grows with the file, not by its promise
  double largest = 0.0;
  for (std::size_t i = 1; i <= count; ++i)
  {
    candela.push_back(factor * reader.NextNumber({ name, i }, 0.0, LargestNumber));
    if (candela.back() > LargestNumber)
    {
      reader.Refuse({ name, i }, "times the factors of the file it is too large");
    }
    largest = std::max(largest, candela.back());
  }
  if (largest == 0.0)
  {
    reader.Fail(std::string("every ") + name + " is 0; a lamp must shine somewhere");
  }
  reader.EndAfter(name);
  return candela;
}

void NoteOnOutputRatio(PhotometricSolid& solid, double stated)
{
  if (solid.ratedFlux == 0.0)
  {
    return;
  }
  const double ratio = 100.0 * Flux(solid) / solid.ratedFlux;
  const double wanted = stated > 0.0 ? stated : std::min(ratio, 100.0);
  constexpr double rounding = 1.0; // the file's percent may be whole ones
  if (std::abs(ratio - wanted) > std::max(rounding, 0.05 * wanted))
  {
    solid.notes.push_back("the intensities make " + NumberText(ratio) + " % of the lamps' flux, " +
      NumberText(solid.ratedFlux) + " lm; " +
      (stated > 0.0 ? "the file says " + NumberText(stated) + " %" : "a luminaire gives less") +
      ". The intensities were used as they are");
  }
}

} // namespace PhotonTransport
