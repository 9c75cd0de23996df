// SPDX-License-Identifier: BSD-3-Clause
// Under MPI a filter sees only what lies on its own rank, but light and the smoothing of a map need
// the whole scene. Ranks can't share a scene here, so all of it has to be on one rank.
#ifndef OneRank_h
#define OneRank_h

class vtkDataObject;
class vtkInformationVector;

#include <string>

namespace Illumination
{

/// What this rank is to do in this execution.
struct RankTask
{
  /// Whether this rank does the filter's work. A rank that does not passes the data through.
  bool Works = true;
  std::string Message; ///< The error, on the one rank that reports it; otherwise empty.
};

/// Finds out which ranks have the surfaces and luminaires of the scene. A rank that has all of them
/// works. If they are spread over several ranks, none works, and rank 0 reports the error. If
/// several ranks have luminaires and none has a surface, or if there is nothing at all, rank 0
/// works, to report that there is no surface.
///
/// All ranks must call this, once in each execution and before anything on a rank can fail, or the
/// others wait for ever. Without MPI, or with one rank, this rank works.
/// @param luminaires May be null.
RankTask TaskOfThisRank(vtkDataObject* surfaces, vtkInformationVector* luminaires);

} // namespace Illumination

#endif
