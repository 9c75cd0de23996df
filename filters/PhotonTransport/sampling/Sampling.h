// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace PhotonTransport
{

/// Which numbers photons are drawn with.
enum class Sampling : int
{
  Random = 0, ///< Independent numbers everywhere.
  Sobol = 1   ///< Owen-scrambled Sobol points for the emission and the first scattering.
};

} // namespace PhotonTransport
