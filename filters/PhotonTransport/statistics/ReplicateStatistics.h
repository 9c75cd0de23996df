// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace PhotonTransport
{

/// Mean of independent replicates and its standard error. A replicate weighs as many photons as it
/// has traced, so that the mean is that of all photons. The updates are those of West, "Updating
/// Mean and Variance Estimates: An Improved Method", 1979, which take no difference of large sums.
class ReplicateStatistics
{
public:
  /// @param value Mean over the replicate's photons. @param photons Their number; 0 adds nothing.
  void Add(double value, double photons)
  {
    if (!(photons > 0.0))
    {
      return;
    }
    this->Replicates += 1.0;
    this->Photons += photons;
    const double difference = value - this->PooledMean;
    this->PooledMean += difference * photons / this->Photons;
    this->Squares += photons * difference * (value - this->PooledMean);
  }

  double Mean() const { return this->PooledMean; }

  /// sqrt(sum_r n_r (x_r - mean)^2 / ((R - 1) n)): the usual s / sqrt(R) where all n_r are equal,
  /// unbiased in its square for any n_r. 0 with fewer than two replicates.
  double StandardError() const
  {
    return this->Replicates < 2.0
      ? 0.0
      : std::sqrt(this->Squares / ((this->Replicates - 1.0) * this->Photons));
  }

private:
  double Replicates = 0.0;
  double Photons = 0.0;
  double PooledMean = 0.0;
  double Squares = 0.0;
};

} // namespace PhotonTransport
