// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/DirectionTable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PhotonTransport
{
namespace
{

constexpr double HalfPi = 1.57079632679489661923;

/// A function linear in the polar angle p, a + b p.
struct Line
{
  double a, b;

  Line(double p0, double p1, double f0, double f1)
    : b((f1 - f0) / (p1 - p0))
  {
    this->a = f0 - this->b * p0;
  }
  double At(double p) const { return std::max(0.0, this->a + this->b * p); }
  /// Of (a + b p) sin p, up to a constant.
  double Primitive(double sine, double cosine, double p) const
  {
    return -(this->a + this->b * p) * cosine + this->b * sine;
  }
  double SineIntegral(double from, double to) const
  {
    return std::max(0.0,
      this->Primitive(std::sin(to), std::cos(to), to) -
        this->Primitive(std::sin(from), std::cos(from), from));
  }
  /// Of (a + b p) sin p cos p.
  double SineCosineIntegral(double from, double to) const
  {
    const auto primitive = [&](double p)
    {
      return -0.25 * (this->a + this->b * p) * std::cos(2.0 * p) +
        0.125 * this->b * std::sin(2.0 * p);
    };
    return primitive(to) - primitive(from);
  }
};

/// Where (f0 + (f1 - f0) s) ds has summed up to a share of its whole, s in [0, 1].
double LinearInverse(double f0, double f1, double share)
{
  const double target = share * 0.5 * (f0 + f1);
  const double root = f0 + std::sqrt(std::max(0.0, f0 * f0 + 2.0 * (f1 - f0) * target));
  return root > 0.0 ? std::clamp(2.0 * target / root, 0.0, 1.0) : share;
}

} // namespace

DirectionTable::DirectionTable(
  std::vector<double> polar, std::vector<double> azimuth, std::vector<double> values)
  : PolarSearch(polar)
  , AzimuthSearch(azimuth)
  , Azimuth(std::move(azimuth))
{
  const std::size_t columns = this->Azimuth.size();
  this->Nodes.reserve(polar.size() * columns);
  for (std::size_t p = 0; p < polar.size(); ++p)
  {
    this->Rings.push_back({ polar[p], std::sin(polar[p]), std::cos(polar[p]), 0.0 });
    for (std::size_t z = 0; z < columns; ++z)
    {
      this->Nodes.push_back({ values[z * polar.size() + p], 0.0 });
    }
    this->AddUpRing(p);
    this->FindFirstOfParts(p);
  }
  std::vector<double> bands;
  for (std::size_t band = 0; band + 1 < polar.size(); ++band)
  {
    const Ring &above = this->Rings[band], &below = this->Rings[band + 1];
    const Line line(above.angle, below.angle, above.integral, below.integral);
    bands.push_back(line.SineIntegral(above.angle, below.angle));
    this->Whole += bands.back();
  }
  if (this->Whole > 0.0)
  {
    this->Bands = FluxTable(bands);
  }
}

void DirectionTable::AddUpRing(std::size_t ring)
{
  const std::size_t columns = this->Azimuth.size();
  Node* nodes = &this->Nodes[ring * columns];
  for (std::size_t z = 1; z < columns; ++z)
  {
    const double mean = 0.5 * (nodes[z - 1].value + nodes[z].value);
    nodes[z].upTo = nodes[z - 1].upTo + mean * (this->Azimuth[z] - this->Azimuth[z - 1]);
  }
  this->Rings[ring].integral = nodes[columns - 1].upTo;
}

void DirectionTable::FindFirstOfParts(std::size_t ring)
{
  const std::size_t intervals = this->Azimuth.size() - 1;
  const Node* nodes = &this->Nodes[ring * this->Azimuth.size()];
  const double whole = this->Rings[ring].integral;
  std::uint32_t first = 0;
  for (std::size_t part = 0; part < intervals; ++part)
  {
    // In a dark ring every part points to the last interval. Nothing is drawn from such a ring
    // alone, and in a mixture the other ring's smaller interval counts.
    const double start = whole * static_cast<double>(part) / static_cast<double>(intervals);
    while (first + 1 < intervals && nodes[first + 1].upTo <= start)
    {
      ++first;
    }
    this->FirstOfPart.push_back(first);
  }
}

double DirectionTable::CosineIntegral() const
{
  double sum = 0.0;
  for (std::size_t band = 0; band + 1 < this->Rings.size() && this->Rings[band].angle < HalfPi;
       ++band)
  {
    const Ring &above = this->Rings[band], &below = this->Rings[band + 1];
    const Line line(above.angle, below.angle, above.integral, below.integral);
    sum += line.SineCosineIntegral(above.angle, std::min(below.angle, HalfPi));
  }
  return sum;
}

/// The polar angle up to which a share of the whole lies.
double DirectionTable::PolarAt(double share, std::size_t& band) const
{
  band = this->Bands.At(share);
  const Ring &above = this->Rings[band], &below = this->Rings[band + 1];
  const Line line(above.angle, below.angle, above.integral, below.integral);
  const double width = this->Bands.End(band) - this->Bands.Begin(band);
  const double part = std::clamp((share - this->Bands.Begin(band)) / width, 0.0, 1.0);
  const double wanted = part * width * this->Whole;
  // Newton's method, kept between bounds that close in, from where it would be if the density were
  // linear in the angle.
  double low = above.angle, high = below.angle;
  double p = low +
    (high - low) * LinearInverse(above.integral * above.sine, below.integral * below.sine, part);
  const double start = line.Primitive(above.sine, above.cosine, above.angle);
  constexpr int MostSteps = 60;
  constexpr double Close = 1e-5; // of p; the step's own error is its square
  for (int step = 0; step < MostSteps; ++step)
  {
    const double sine = std::sin(p);
    const double excess = line.Primitive(sine, std::cos(p), p) - start - wanted;
    (excess > 0.0 ? high : low) = p;
    const double slope = line.At(p) * sine;
    const double next = slope > 0.0 ? p - excess / slope : low;
    const bool inside = next > low && next < high;
    const double before = std::exchange(p, inside ? next : 0.5 * (low + high));
    if (std::fabs(p - before) <= Close * p)
    {
      break;
    }
  }
  return p;
}

/// The azimuth up to which a share of the light at one polar angle lies. The angle is a part
/// `below`, in [0, 1], of the way from the band's upper ring to its lower one. The distribution
/// there is a mixture of the two rings' distributions, so the azimuth lies between those of the two
/// rings, and the search starts at the smaller of them.
double DirectionTable::AzimuthAt(std::size_t band, double below, double share) const
{
  const std::size_t columns = this->Azimuth.size();
  const std::size_t intervals = columns - 1;
  const Node* upper = &this->Nodes[band * columns];
  const Node* lower = upper + columns;
  const auto upTo = [&](std::size_t z)
  { return (1.0 - below) * upper[z].upTo + below * lower[z].upTo; };
  const auto value = [&](std::size_t z)
  { return (1.0 - below) * upper[z].value + below * lower[z].value; };
  const double target =
    share * ((1.0 - below) * this->Rings[band].integral + below * this->Rings[band + 1].integral);
  const std::size_t part =
    band * intervals + static_cast<std::size_t>(share * static_cast<double>(intervals));
  std::size_t z = std::min(this->FirstOfPart[part], this->FirstOfPart[part + intervals]);
  while (z + 1 < intervals && upTo(z + 1) <= target)
  {
    ++z;
  }
  const double whole = upTo(z + 1) - upTo(z);
  const double within = whole > 0.0 ? std::clamp((target - upTo(z)) / whole, 0.0, 1.0) : 0.5;
  const double width = this->Azimuth[z + 1] - this->Azimuth[z];
  return this->Azimuth[z] + width * LinearInverse(value(z), value(z + 1), within);
}

double DirectionTable::Value(const glm::dvec2& angles) const
{
  constexpr double Rounding = 1e-9; // an edge of the grid belongs to it
  constexpr double Turn = 4.0 * HalfPi;
  const double first = this->Azimuth.front();
  const double polar = angles.x;
  double azimuth = angles.y - Turn * std::floor((angles.y - first + Rounding) / Turn);
  if (polar < this->Rings.front().angle - Rounding || polar > this->Rings.back().angle + Rounding ||
    azimuth > this->Azimuth.back() + Rounding)
  {
    return 0.0;
  }
  azimuth = std::clamp(azimuth, first, this->Azimuth.back());
  const auto ring =
    this->Rings.begin() + static_cast<std::ptrdiff_t>(this->PolarSearch.EndOf(polar));
  const auto column =
    this->Azimuth.begin() + static_cast<std::ptrdiff_t>(this->AzimuthSearch.EndOf(azimuth));
  const double below =
    std::clamp((polar - ring[-1].angle) / (ring->angle - ring[-1].angle), 0.0, 1.0);
  const double beside = (azimuth - column[-1]) / (*column - column[-1]);
  const Node* lower =
    &this->Nodes[static_cast<std::size_t>(ring - this->Rings.begin()) * this->Azimuth.size() +
      static_cast<std::size_t>(column - this->Azimuth.begin())];
  const Node* upper = lower - this->Azimuth.size();
  const auto between = [&](const Node* node)
  { return (1.0 - beside) * node[-1].value + beside * node->value; };
  return (1.0 - below) * between(upper) + below * between(lower);
}

glm::dvec2 DirectionTable::Sample(double u, double v) const
{
  std::size_t band = 0;
  const double p = this->PolarAt(u, band);
  const double from = this->Rings[band].angle, to = this->Rings[band + 1].angle;
  const double below = std::clamp((p - from) / (to - from), 0.0, 1.0);
  return { p, this->AzimuthAt(band, below, v) };
}

} // namespace PhotonTransport
