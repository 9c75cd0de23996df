// SPDX-License-Identifier: BSD-3-Clause
// Under MPI a filter sees only what lies on its own rank, but light and the smoothing of a map need
// the whole scene. Until ranks share one, all of it has to be on one rank.
#ifndef OneRank_h
#define OneRank_h

class vtkDataObject;
class vtkInformationVector;

#include <string>

/// What this rank is to do in this execution.
struct RankTask
{
  bool Works =
    true; ///< Whether it does the filter's work; a rank that doesn't passes data through.
  std::string Message; ///< The error, on the one rank that says it, else empty.
};

/// Finds out who has the scene: its surfaces, and its luminaires if there are any. The rank that
/// has all of it works, rank 0 if there is nothing, and none if it is spread over several.
///
/// All ranks must call this, once in each execution and before anything on a rank can fail, or the
/// others wait for ever. Without MPI, or with one rank, it asks nobody.
/// @param luminaires May be null.
RankTask TaskOfThisRank(vtkDataObject* surfaces, vtkInformationVector* luminaires);

#endif
