// SPDX-License-Identifier: BSD-3-Clause
// What is connected as luminaires, whether one by one or in groups.
#ifndef LuminaireInput_h
#define LuminaireInput_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkInformationVector;
class vtkPolyData;

namespace Illumination
{

struct LuminaireInput
{
  vtkSmartPointer<vtkPolyData> data;
  std::string name; ///< "luminaire 2", or "luminaire 2, block 3 'Spot'".
};

/// One for each connection; for a composite data set one for each block that is not empty. Throws
/// InputError for data that are no vtkPolyData, and for a group without a luminaire.
std::vector<LuminaireInput> LuminaireInputs(vtkInformationVector* port);

} // namespace Illumination

#endif
