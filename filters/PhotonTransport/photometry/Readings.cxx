// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/Readings.h"

#include "PhotonTransport/photometry/PhotometricFile.h"

#include <exception>

namespace PhotonTransport
{

PhotometricSolid FirstThatReads(const std::vector<Attempt>& attempts)
{
  std::size_t furthest = 0;
  std::exception_ptr error;
  for (const Attempt& attempt : attempts)
  {
    try
    {
      return attempt();
    }
    catch (const PhotometricFileError& failed)
    {
      if (failed.Line > furthest)
      {
        furthest = failed.Line;
        error = std::current_exception();
      }
    }
  }
  std::rethrow_exception(error);
}

} // namespace PhotonTransport
