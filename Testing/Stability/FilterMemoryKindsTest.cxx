// SPDX-License-Identifier: BSD-3-Clause
// What a run takes of each kind that there is.
#include "FilterMemoryTools.h"

#include "vtkLuminaireSource.h"

#include <functional>

namespace
{

/// Four lamps, which are kept apart, one of them coloured.
void AddLamps(vtkIlluminationMap* filter)
{
  filter->SetLampContributions(true);
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkLuminaireSource> lamp;
    lamp->SetType(vtkLuminaireSource::POINT);
    lamp->SetPosition(0.05 * i, 0.1, -0.1);
    lamp->SetLightColour(1.0, i == 0 ? 0.5 : 1.0, 1.0);
    filter->AddLuminaireConnection(lamp->GetOutputPort());
  }
}

/// What a run may have in addition.
struct Kind
{
  const char* name;
  std::function<void(vtkIlluminationMap*)> set;
  double least = 0.8; ///< Share of what it said that it takes.
};

const Kind Kinds[] = {
  { "EightThreadsWithoutGroupMeans",
    [](vtkIlluminationMap* filter)
    {
      filter->SetNumberOfThreads(8);
      filter->SetGroupMeans(false);
    } },
  { "LampsApartInColours", AddLamps },
  { "PhotonMap",
    [](vtkIlluminationMap* filter)
    {
      filter->SetPhotons(300'000);
      filter->SetMaximumPhotons(500'000);
    } },
  { "CurvedPatches", [](vtkIlluminationMap* filter) { filter->SetCurvedSurface(true); } },
  { "Gathered", Gather },
  { "GatheredLampsApartInColours",
    [](vtkIlluminationMap* filter)
    {
      Gather(filter);
      AddLamps(filter);
    } },
  { "GatheredAndRefined",
    [](vtkIlluminationMap* filter)
    {
      Gather(filter);
      filter->SetAdaptiveRefinement(true);
    },
    0.7 }, // at how many middles of edges there is light is not counted
};

class FilterMemoryOfKinds
  : public FilterMemory
  , public ::testing::WithParamInterface<Kind>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Stability, FilterMemoryOfKinds, ::testing::ValuesIn(Kinds),
  [](const ::testing::TestParamInfo<Kind>& instance) { return instance.param.name; });

TEST_P(FilterMemoryOfKinds, NoMoreThanWasSaidOfEachKind)
{
  if (!MeasuresMemory)
  {
    GTEST_SKIP() << "not with the address sanitizer";
  }
  this->LightMayBeMissing = true;
  this->Filter->SetLampType(vtkIlluminationMap::POINT);
  this->Filter->SetLampPosition(0.05, 0.1, -0.1);
  this->Filter->SetNumberOfThreads(2);
  GetParam().set(this->Filter);
  this->ExpectTaken(LargeSphere(400, 250), GetParam().least);
}
