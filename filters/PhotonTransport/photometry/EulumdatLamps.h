// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/TextReader.h"

namespace PhotonTransport
{

/// The first set of lamps of an EULUMDAT file. The other sets are alternatives and are not used.
struct EulumdatLamps
{
  double flux = 0.0;        ///< lm of the set's lamps together, > 0.
  double watts = 0.0;       ///< W of the set; 0 if it is not known.
  bool isAbsolute = false;  ///< Absolute photometry: the flux is that of the luminaire.
  bool isPlausible = false; ///< There are from 2 to 400 lm for each watt.
};

/// Reads the number of sets and the six lines of each. Two orders are in use: set after set, or
/// each of the six lines for all sets before the next line. The order in which the numbers are more
/// plausible is taken, and a note says so where both are possible and give another flux.
EulumdatLamps ReadEulumdatLamps(TextReader& reader);

} // namespace PhotonTransport
