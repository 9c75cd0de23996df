// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace PhotonTransport
{

constexpr double Pi = 3.14159265358979323846;

} // namespace PhotonTransport
