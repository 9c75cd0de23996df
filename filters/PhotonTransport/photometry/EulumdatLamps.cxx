// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/EulumdatLamps.h"

#include "PhotonTransport/photometry/PhotometricNumbers.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace PhotonTransport
{

namespace
{

/// What a set's lines hold, in their order.
enum Field : std::size_t
{
  NumberOfLamps,
  TypeOfLamps,
  FluxOfLamps,
  ColourTemperature,
  ColourRendering,
  Watts,
  Fields
};

/// The lines of all sets in one of the two orders in use.
struct Layout
{
  std::size_t sets;
  bool isSetAfterSet;

  std::size_t Line(std::size_t set, Field field) const
  {
    return this->isSetAfterSet ? set * Fields + field : field * this->sets + set;
  }
};

using Lines = std::vector<std::string>;

bool IsWithin(const std::optional<double>& value, double smallest, double largest)
{
  return value && *value >= smallest && *value <= largest;
}

/// Whether lamps give as many lumens for a watt.
bool IsEfficacy(double flux, double watts)
{
  return watts > 0.0 && IsWithin(flux / watts, 2.0, 400.0);
}

/// How much a set looks like one. Its colour is in kelvins
/// (or a colour code of three digits), their colour rendering index at most 100.
int Plausibility(const Lines& lines, const Layout& layout, std::size_t set)
{
  const auto text = [&](Field field) { return lines[layout.Line(set, field)]; };
  const auto number = [&](Field field) { return Number(text(field)); };
  int points = 0;
  const auto judge = [&](bool isGood, int good, int bad) { points += isGood ? good : bad; };

  const std::optional<double> lamps = number(NumberOfLamps);
  judge(IsWithin(lamps, -1000.0, 1000.0) && *lamps != 0.0 && *lamps == std::floor(*lamps), 2, -4);
  const std::optional<double> flux = number(FluxOfLamps);
  judge(IsWithin(flux, 0.0, LargestNumber), 1, -4);
  const std::optional<double> watts = WattsOf(text(Watts));
  if (flux && watts && *watts > 0.0)
  {
    judge(IsEfficacy(*flux, *watts), 2, -2);
  }
  judge(!number(TypeOfLamps), 1, 0);
  if (const auto index = number(ColourRendering))
  {
    judge(IsWithin(index, 0.0, 100.0), 0, -2);
  }
  if (const auto colour = number(ColourTemperature))
  {
    judge(IsWithin(colour, 100.0, 30000.0), 1, -1);
  }
  return points;
}

/// Whether every number of lamps and every flux is a number, by which light may go.
bool IsPossible(const Lines& lines, const Layout& layout)
{
  for (std::size_t set = 0; set < layout.sets; ++set)
  {
    const auto flux = Number(lines[layout.Line(set, FluxOfLamps)]);
    if (!Number(lines[layout.Line(set, NumberOfLamps)]) || !IsWithin(flux, 0.0, LargestNumber))
    {
      return false;
    }
  }
  return true;
}

/// Notes what was chosen where the other layout is possible too.
Layout ChooseLayout(TextReader& reader, const Lines& lines, std::size_t sets)
{
  const Layout rows{ sets, true };
  const Layout columns{ sets, false };
  int difference = 0;
  for (std::size_t set = 0; set < sets; ++set)
  {
    difference += Plausibility(lines, rows, set) - Plausibility(lines, columns, set);
  }
  const Layout& chosen = difference >= 0 ? rows : columns;
  const Layout& other = difference >= 0 ? columns : rows;
  const std::string& flux = lines[chosen.Line(0, FluxOfLamps)];
  const std::string& otherFlux = lines[other.Line(0, FluxOfLamps)];
  if (IsPossible(lines, other) && flux != otherFlux)
  {
    reader.Note("the " + std::to_string(sets) +
      " sets of lamps that follow can be read set after set or line after line of all sets; " +
      (chosen.isSetAfterSet ? "set after set" : "line after line") +
      (difference == 0 ? " was chosen, although it is no more plausible"
                       : " was chosen, by lm/W, colour and the number of lamps") +
      ": the flux is " + Shortened(flux, 40) + " lm, not " + Shortened(otherFlux, 40) + " lm");
  }
  return chosen;
}

} // namespace

EulumdatLamps ReadEulumdatLamps(TextReader& reader)
{
  EulumdatLamps lamps;
  const std::size_t sets = reader.CountLine("number of sets of lamps", 1, MostAngles);
  Lines lines(Fields * sets);
  TextReader ahead = reader;
  for (std::string& line : lines)
  {
    ahead.NextLine(line); // empty after the end, which is told below
  }
  const Layout layout = sets == 1 ? Layout{ 1, true } : ChooseLayout(reader, lines, sets);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    if (i == layout.Line(0, NumberOfLamps))
    {
      // A number below 0 marks absolute photometry; the flux is the luminaire's then.
      lamps.isAbsolute = reader.LenientNumberLine("number of lamps", -1e6, 1e6) < 0.0;
    }
    else if (i == layout.Line(0, FluxOfLamps))
    {
      constexpr const char* name = "flux of the lamps";
      lamps.flux = reader.Positive(name, reader.NumberLine(name, 0.0, LargestNumber));
    }
    else if (i == layout.Line(0, Watts))
    {
      lamps.watts = LenientWatts(reader, "wattage", reader.TextLine("wattage"));
    }
    else
    {
      reader.TextLine("set of lamps");
    }
  }
  lamps.isPlausible = IsEfficacy(lamps.flux, lamps.watts);
  if (lamps.watts > 0.0 && !lamps.isPlausible)
  {
    reader.Note("the lamps of the first set give " + NumberText(lamps.flux) + " lm for " +
      NumberText(lamps.watts) + " W, which lamps hardly do; the flux was used as it is");
  }
  return lamps;
}

} // namespace PhotonTransport
