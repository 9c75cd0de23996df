// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/Receiver.h"

#include <cstdint>
#include <functional>

namespace PhotonTransport
{

/// Receivers for which a first pass is made: it has to know the light that they see.
struct Viewers
{
  std::uint64_t number;
  std::function<void(std::uint64_t i, Receiver& receiver)> make;
};

} // namespace PhotonTransport
