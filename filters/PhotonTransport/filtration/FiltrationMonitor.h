// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace PhotonTransport
{

/// Called between steps with the share of the work done; throws to end it.
using FiltrationMonitor = std::function<void(double)>;

} // namespace PhotonTransport
