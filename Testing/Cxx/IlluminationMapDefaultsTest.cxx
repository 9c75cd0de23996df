// SPDX-License-Identifier: BSD-3-Clause
// A new filter has the defaults that are documented, and PrintSelf shows every property.
#include "Messages.h"

#include "vtkIlluminationMap.h"

#include "vtkNew.h"

#include <sstream>

TEST(IlluminationMap, PrintsItsDefaults)
{
  vtkNew<vtkIlluminationMap> illuminate;
  std::ostringstream printed;
  illuminate->PrintSelf(printed, vtkIndent());
  for (const char* line : { "LampType: 0", "LampPosition:", "LampDirection:", "LampSize:",
         "SpotHalfAngle: 30", "SpotExponent: 0", "LuminousFlux: 1000", "ParallelIlluminance: 1000",
         "Reflectance: 0.5", "ReflectanceArray:", "ExitanceArray:", "Registration: 2",
         "Photons: 1000000", "TargetRelativeError: 0", "CountFacetError: 0", "TimeLimit: 0",
         "Seed: 1", "Sampling: 1", "Interreflection: 1", "RegisterBackSide: 0", "CurvedSurface: 0",
         "MetresPerUnit: 1", "FeatureAngle: 30", "NumberOfThreads: 0", "WeightBound: 16",
         "MaximumPathLength: 10000", "MemoryLimit: 0" })
  {
    EXPECT_TRUE(Holds(printed.str(), line));
  }
}
