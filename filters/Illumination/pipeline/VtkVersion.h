// SPDX-License-Identifier: BSD-3-Clause
// The one place for differences between VTK 9.1 and 9.3.
#ifndef VtkVersion_h
#define VtkVersion_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace Illumination
{

/// Whether the user wants this execution to end.
inline bool AbortRequested(vtkAlgorithm* algorithm)
{
#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 3)
  const bool requested = algorithm->CheckAbort(); // looks downstream too
  if (requested)
  {
    algorithm->SetAbortOutput(false); // or the executive empties the output, which is valid
  }
  return requested;
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

} // namespace Illumination

#endif
