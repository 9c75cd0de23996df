// SPDX-License-Identifier: BSD-3-Clause
// A new filter has the defaults that are documented, and PrintSelf shows every property.
#include "vtkIlluminationMap.h"

#include "vtkNew.h"

#include <iostream>
#include <sstream>
#include <string>

int TestIlluminationMapDefaults(int, char*[])
{
  vtkNew<vtkIlluminationMap> illuminate;
  std::ostringstream printed;
  illuminate->PrintSelf(printed, vtkIndent());
  bool good = true;
  for (const char* line : { "LampType: 0", "LampPosition:", "LampDirection:", "LampSize:",
         "SpotHalfAngle: 30", "SpotExponent: 0", "LuminousFlux: 1000", "ParallelIlluminance: 1000",
         "Reflectance: 0.5", "ReflectanceArray:", "ExitanceArray:", "Registration: 2",
         "Photons: 1000000", "TargetRelativeError: 0", "TimeLimit: 0", "Seed: 1", "Sampling: 1",
         "Interreflection: 1", "RegisterBackSide: 0", "MetresPerUnit: 1", "FeatureAngle: 30",
         "NumberOfThreads: 0", "WeightBound: 16", "MaximumPathLength: 10000", "MemoryLimit: 0" })
  {
    if (printed.str().find(line) == std::string::npos)
    {
      std::cerr << "PrintSelf does not say \"" << line << "\"\n";
      good = false;
    }
  }
  if (!good)
  {
    std::cerr << printed.str();
  }
  return good ? 0 : 1;
}
