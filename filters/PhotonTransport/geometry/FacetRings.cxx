// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/FacetRings.h"

#include <numeric>

namespace PhotonTransport
{

FacetRings::FacetRings(std::size_t vertexCount, const std::vector<glm::uvec3>& facets)
  : Offsets(vertexCount + 1, 0)
{
  for (const glm::uvec3& facet : facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (facet[corner] != NoVertex)
      {
        ++this->Offsets[facet[corner] + 1];
      }
    }
  }
  std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
  this->Facets.resize(this->Offsets.back());

  std::vector<std::uint64_t> next(this->Offsets.begin(), this->Offsets.end() - 1);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (facets[f][corner] != NoVertex)
      {
        this->Facets[next[facets[f][corner]]++] = static_cast<std::uint32_t>(f);
      }
    }
  }
}

} // namespace PhotonTransport
