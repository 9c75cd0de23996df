// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/OverlappingFacets.h"

#include "PhotonTransport/scene/BundleSearch.h"
#include "PhotonTransport/threads/Threads.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace PhotonTransport
{
namespace
{

/// Where each of some shares of the groups begins, and where the last one ends.
std::vector<const PlaneMember*> Shares(const std::vector<PlaneMember>& groups)
{
  constexpr std::ptrdiff_t Members = 2048;
  std::vector<const PlaneMember*> begins{ groups.data() };
  ForEachGroup(groups,
    [&](const PlaneMember*, const PlaneMember* last)
    {
      if (last - begins.back() >= Members)
      {
        begins.push_back(last);
      }
    });
  begins.push_back(groups.data() + groups.size());
  return begins;
}

} // namespace

void ForEachOverlap(const FacetPlaces& places, const std::function<void(const FacetOverlap&)>& f)
{
  // All threads look for the bundles that may hold overlaps, which are few. These are then gone
  // through in their order, so that the result does not depend on the threads.
  const std::vector<const PlaneMember*> begins = Shares(places.groups);
  std::vector<std::vector<Bundle>> found(begins.size() - 1);
  const std::vector<std::uint64_t> numbers = NumbersOfPlaces(places.points);
  PerThread<Outline> outlines(MostThreadIndices(), Outline(numbers, places.facets));
  ParallelFor(0, found.size(),
    [&](std::uint64_t begin, std::uint64_t end)
    {
      Outline& outline = outlines.Own();
      ForEachGroup(begins[begin], begins[end],
        [&](const PlaneMember* first, const PlaneMember* last)
        {
          if (IsPairApart(places, first, last))
          {
            return;
          }
          for (Bundle& bundle : BundlesOf(places.planes, first, last))
          {
            if (bundle.facets.size() > 1 && BundleSearch(places, bundle).MayHaveAny(outline))
            {
              found[begin].push_back(std::move(bundle));
            }
          }
        });
    });
  for (const std::vector<Bundle>& bundles : found)
  {
    for (const Bundle& bundle : bundles)
    {
      BundleSearch(places, bundle).ForEach(f);
    }
  }
}

} // namespace PhotonTransport
