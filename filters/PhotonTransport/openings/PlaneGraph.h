// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// A straight piece between two nodes of a plane, and what lies beside it.
struct PlanePiece
{
  std::uint32_t from, to;
  bool coveredLeft = false; ///< As seen from `from` towards `to`: a facet of the plane lies there.
  bool coveredRight = false;
};

/// A part of a plane that pieces enclose.
struct PlaneFace
{
  std::vector<std::uint32_t> nodes;  ///< Counter-clockwise.
  std::vector<std::uint32_t> pieces; ///< Around it.
};

/// Straight pieces in a plane that meet at nodes only.
class PlaneGraph
{
public:
  /// @param nodes, pieces Must outlive this.
  PlaneGraph(const std::vector<glm::dvec2>& nodes, const std::vector<PlanePiece>& pieces);

  /// The parts of the plane that pieces enclose and that no facet beside one of them covers. Pieces
  /// that enclose nothing, as they end where no other begins, are left out.
  std::vector<PlaneFace> FreeFaces() const;

private:
  // Each piece is there twice, 2 * piece from its first node to its last and 2 * piece + 1 back.
  std::uint32_t Start(std::uint32_t way) const;
  bool IsCovered(std::uint32_t way) const;
  double Angle(std::uint32_t way) const;
  void RemoveLooseEnds();
  void SortWays();
  std::uint32_t Next(std::uint32_t way) const;

  const std::vector<glm::dvec2>& Nodes;
  const std::vector<PlanePiece>& Pieces;
  std::vector<std::uint8_t> Removed;                ///< By piece.
  std::vector<std::vector<std::uint32_t>> WaysFrom; ///< Each node, counter-clockwise.
};

} // namespace PhotonTransport
