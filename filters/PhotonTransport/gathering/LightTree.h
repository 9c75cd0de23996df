// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/LightPieces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// A hierarchy of pieces of lamps, to choose one by about how bright it is at a point: what is far
/// off as a group, and what is near by itself.
class LightTree
{
public:
  /// @param pieces Must outlive this; those that are near.
  explicit LightTree(const LightPieces& pieces);

  /// Nodes that together hold all pieces that can be seen from a point, in the tree's order.
  class Cut
  {
  public:
    static constexpr std::size_t Most = 64; ///< Nodes.
    /// About how bright all is at the point: its illuminance times pi, in lm per scene unit
    /// squared, if nothing stood between.
    double Brightness() const { return this->Sum; }

  private:
    friend class LightTree;
    struct Entry
    {
      std::uint32_t node;
      double brightness;
      double priority; ///< By which nodes are opened; 0: it is not.
      double end;      ///< Of its interval of [0, 1).
    };
    glm::dvec3 Point{ 0.0 }, Normal{ 0.0 };
    std::array<Entry, Most> Entries;
    std::size_t Size = 0;
    double Sum = 0.0; ///< Of all brightnesses.
  };

  /// Opens the brightest of the nodes that are large for their distance, one after the other.
  /// @param most Nodes, up to Cut::Most.
  Cut CutAt(const glm::dvec3& point, const glm::dvec3& normal, std::size_t most) const;

  /// A piece that was chosen. A probability of 0 says that none can be seen.
  struct Choice
  {
    std::uint32_t piece = 0;
    double probability = 0.0;
    double number = 0.0; ///< The place of the number in the piece's interval of [0, 1).
  };

  /// Each piece that can be seen has an interval of [0, 1), and pieces that are close together have
  /// intervals that are close, so that well spread numbers give well spread choices. In the cut,
  /// and at each fork of
  /// the way from there to a piece, a tenth is decided by flux alone; among surfaces that are far
  /// off all is.
  Choice Choose(const Cut& cut, double number) const;

private:
  struct Node
  {
    LightBounds bounds;
    std::uint32_t second;     ///< The second child; the first one is the next node. 0: a leaf.
    std::uint32_t begin, end; ///< Its pieces, in Order.
    bool isSurface;           ///< All of them shine by Lambert's law.
  };
  std::uint32_t Build(std::uint32_t begin, std::uint32_t end);
  double Brightness(const Node& node, const glm::dvec3& point, const glm::dvec3& normal) const;
  bool IsNear(const Node& node, const glm::dvec3& point) const;
  void Add(std::uint32_t node, Cut& cut) const;
  void Finish(Cut& cut) const;
  void Descend(const Cut& cut, std::uint32_t node, Choice& choice) const;
  void ChooseByFlux(const Node& node, Choice& choice) const;

  const LightPieces& Pieces;
  std::vector<Node> Nodes;
  std::vector<std::uint32_t> Order; ///< Of the pieces, as the leaves have them.
  std::vector<double> FluxUpTo;     ///< Of the pieces before, in this order.
};

} // namespace PhotonTransport
