// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/materials/DiffuseReflections.h"

#include "PhotonTransport/materials/DiffuseReflection.h"
#include "PhotonTransport/sampling/WideVectors.h"

namespace PhotonTransport
{

void DiffuseReflections::FindDirections()
{
  const std::size_t count = this->Count;
  WithWideVectors(
    [&]
    {
      for (std::size_t i = 0; i < count; ++i) // simple enough to become vector operations
      {
        const glm::vec3 direction =
          ReflectDiffusely({ this->X[i], this->Y[i], this->Z[i] }, this->U[i], this->V[i]);
        this->X[i] = direction.x;
        this->Y[i] = direction.y;
        this->Z[i] = direction.z;
      }
    });
}

} // namespace PhotonTransport
