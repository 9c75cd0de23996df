// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/TextReader.h"

namespace PhotonTransport
{

/// The first set of lamps of an EULUMDAT file; the others are alternatives.
struct EulumdatLamps
{
  double flux = 0.0; ///< lm of the set's lamps together, > 0.
  double watts = 0.0;
  bool isAbsolute = false;  ///< The flux is the luminaire's.
  bool isPlausible = false; ///< Flux and watts go together.
};

/// Reads the number of sets and their six lines each, set after set or each of the six for all
/// sets before the next one: whichever makes sense of the numbers.
EulumdatLamps ReadEulumdatLamps(TextReader& reader);

} // namespace PhotonTransport
