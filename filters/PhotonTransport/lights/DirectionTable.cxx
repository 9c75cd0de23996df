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
  : Polar(std::move(polar))
  , Azimuth(std::move(azimuth))
  , Values(std::move(values))
{
  const std::size_t rows = this->Polar.size();
  const std::size_t columns = this->Azimuth.size();
  this->UpTo.resize(rows * columns, 0.0);
  for (std::size_t p = 0; p < rows; ++p)
  {
    for (std::size_t z = 1; z < columns; ++z)
    {
      const double mean = 0.5 * (this->Value(p, z - 1) + this->Value(p, z));
      this->UpTo[p * columns + z] =
        this->UpTo[p * columns + z - 1] + mean * (this->Azimuth[z] - this->Azimuth[z - 1]);
    }
  }
  double sum = 0.0;
  for (std::size_t band = 0; band + 1 < rows; ++band)
  {
    const double p0 = this->Polar[band], p1 = this->Polar[band + 1];
    const Line line(
      p0, p1, this->UpTo[(band + 1) * columns - 1], this->UpTo[(band + 2) * columns - 1]);
    sum += line.SineIntegral(p0, p1);
    this->BandEnds.push_back(sum);
  }
}

double DirectionTable::CosineIntegral() const
{
  const std::size_t columns = this->Azimuth.size();
  double sum = 0.0;
  for (std::size_t band = 0; band + 1 < this->Polar.size() && this->Polar[band] < HalfPi; ++band)
  {
    const double p0 = this->Polar[band], p1 = this->Polar[band + 1];
    const Line line(
      p0, p1, this->UpTo[(band + 1) * columns - 1], this->UpTo[(band + 2) * columns - 1]);
    sum += line.SineCosineIntegral(p0, std::min(p1, HalfPi));
  }
  return sum;
}

/// The polar angle up to which a share of the whole lies.
double DirectionTable::PolarAt(double share, std::size_t& band) const
{
  const double target = share * this->Integral();
  const auto end = std::upper_bound(this->BandEnds.begin(), this->BandEnds.end() - 1, target);
  band = static_cast<std::size_t>(end - this->BandEnds.begin());
  const std::size_t columns = this->Azimuth.size();
  const double p0 = this->Polar[band], p1 = this->Polar[band + 1];
  const Line line(
    p0, p1, this->UpTo[(band + 1) * columns - 1], this->UpTo[(band + 2) * columns - 1]);
  const double wanted = target - (band == 0 ? 0.0 : this->BandEnds[band - 1]);
  // Newton's method, kept between bounds that close in, from where it would be if the density were
  // linear in the angle.
  double low = p0, high = p1;
  const double whole = this->BandEnds[band] - (band == 0 ? 0.0 : this->BandEnds[band - 1]);
  double p = p0 +
    (p1 - p0) *
      LinearInverse(line.At(p0) * std::sin(p0), line.At(p1) * std::sin(p1),
        whole > 0.0 ? std::clamp(wanted / whole, 0.0, 1.0) : 0.5);
  const double start = line.Primitive(std::sin(p0), std::cos(p0), p0);
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

glm::dvec2 DirectionTable::Sample(double u, double v) const
{
  std::size_t band = 0;
  const double p = this->PolarAt(u, band);
  const std::size_t columns = this->Azimuth.size();
  const double t =
    std::clamp((p - this->Polar[band]) / (this->Polar[band + 1] - this->Polar[band]), 0.0, 1.0);
  const double* above = &this->UpTo[band * columns];
  const double* below = above + columns;
  const auto upTo = [&](std::size_t z) { return (1.0 - t) * above[z] + t * below[z]; };
  const double target = v * upTo(columns - 1);
  // The first interval that ends beyond the target.
  std::size_t first = 0, last = columns - 2;
  while (first < last)
  {
    const std::size_t middle = (first + last) / 2;
    if (upTo(middle + 1) > target)
    {
      last = middle;
    }
    else
    {
      first = middle + 1;
    }
  }
  const double whole = upTo(first + 1) - upTo(first);
  const double share = whole > 0.0 ? std::clamp((target - upTo(first)) / whole, 0.0, 1.0) : 0.5;
  const auto value = [&](std::size_t z)
  { return (1.0 - t) * this->Value(band, z) + t * this->Value(band + 1, z); };
  const double width = this->Azimuth[first + 1] - this->Azimuth[first];
  return { p, this->Azimuth[first] + width * LinearInverse(value(first), value(first + 1), share) };
}

} // namespace PhotonTransport
