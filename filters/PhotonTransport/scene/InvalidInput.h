// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace PhotonTransport
{

/// Input that cannot be traced. `what()` says which value is wrong and what it should be; Kind and
/// Index say where, so that a caller can name the cell or point in its own terms.
class InvalidInput : public std::runtime_error
{
public:
  enum class Where
  {
    Surface,      ///< The surface as a whole; Index means nothing.
    Point,        ///< Index is that of a point of the surface.
    Facet,        ///< Index is that of a facet of the surface.
    LampSettings, ///< Index means nothing.
    TraceSettings ///< Index means nothing.
  };

  InvalidInput(Where where, std::size_t index, const std::string& message)
    : std::runtime_error(message)
    , Kind(where)
    , Index(index)
  {
  }

  const Where Kind;
  const std::size_t Index;
};

} // namespace PhotonTransport
