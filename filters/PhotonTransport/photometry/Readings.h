// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/PhotometricSolid.h"

#include <functional>
#include <vector>

namespace PhotonTransport
{

/// One way to read a file. Throws PhotometricFileError if the file is inconsistent in that way.
using Attempt = std::function<PhotometricSolid()>;

/// What the first attempt that does not throw gives. If all throw, the error of the first one,
/// which is the standard's way.
PhotometricSolid FirstThatReads(const std::vector<Attempt>& attempts);

} // namespace PhotonTransport
