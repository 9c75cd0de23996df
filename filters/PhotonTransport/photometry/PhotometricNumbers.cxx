// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/PhotometricNumbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Takes a number with a decimal point or comma from the beginning.
std::optional<double> TakeNumber(std::string& text)
{
  std::replace(text.begin(), text.end(), ',', '.');
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value))
  {
    return std::nullopt;
  }
  text = Trimmed(std::string_view(text).substr(static_cast<std::size_t>(stop - text.data())));
  return value;
}

} // namespace

std::optional<double> Number(std::string text)
{
  const std::optional<double> value = TakeNumber(text);
  return text.empty() ? value : std::nullopt;
}

std::optional<double> WattsOf(std::string text)
{
  std::optional<double> watts = TakeNumber(text);
  for (const std::string times : { "x", "X", "*", "\xC3\x97" })
  {
    if (watts && text.compare(0, times.size(), times) == 0)
    {
      text = Trimmed(std::string_view(text).substr(times.size()));
      const std::optional<double> each = TakeNumber(text);
      watts = each ? std::optional(*watts * *each) : std::nullopt;
    }
  }
  const std::string unit = UpperCase(text);
  const bool isKnown = unit.empty() || unit == "W" || unit == "WATT" || unit == "WATTS";
  const bool isPower = watts && *watts >= 0.0 && *watts <= LargestNumber;
  return isKnown && isPower ? watts : std::nullopt;
}

double LenientWatts(TextReader& reader, const char* name, const std::string& text)
{
  const std::optional<double> watts = text.empty() ? 0.0 : WattsOf(text);
  if (!watts || !(text.empty() || Number(text)))
  {
    reader.Note(std::string(name) + " is '" + Shortened(text, 40) + "'; " +
      (watts ? NumberText(*watts) + " W was taken" : "0 was taken for unknown") +
      ", and the light does not depend on it");
  }
  return watts.value_or(0.0);
}

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
