// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/Readings.h"

#include "PhotonTransport/photometry/PhotometricFile.h"

#include <exception>

namespace PhotonTransport
{

PhotometricSolid FirstThatReads(const std::vector<Attempt>& attempts)
{
  std::exception_ptr error;
  for (const Attempt& attempt : attempts)
  {
    try
    {
      return attempt();
    }
    catch (const PhotometricFileError&)
    {
      error = error ? error : std::current_exception();
    }
  }
  std::rethrow_exception(error);
}

} // namespace PhotonTransport
