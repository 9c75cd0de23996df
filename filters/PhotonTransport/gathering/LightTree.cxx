// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/LightTree.h"

#include "PhotonTransport/gathering/LightDivision.h"
#include "PhotonTransport/geometry/Pi.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

namespace PhotonTransport
{
namespace
{

/// The largest number below 1.
constexpr double BelowOne = 1.0 - 0x1p-53;

/// The share of a choice that flux alone decides, so that weights stay bounded.
constexpr double Floor = 0.1;

} // namespace

LightTree::LightTree(const LightPieces& pieces)
  : Pieces(pieces)
  , Order(pieces.Near().size())
{
  const auto count = static_cast<std::uint32_t>(this->Order.size());
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  this->Nodes.reserve(2 * this->Order.size());
  if (count > 0)
  {
    this->Build(0, count);
  }
  this->FluxUpTo.push_back(0.0);
  for (const std::uint32_t piece : this->Order)
  {
    this->FluxUpTo.push_back(this->FluxUpTo.back() + pieces.Near()[piece].bounds.flux);
  }
}

std::uint32_t LightTree::Build(std::uint32_t begin, std::uint32_t end)
{
  const auto node = static_cast<std::uint32_t>(this->Nodes.size());
  if (end - begin == 1)
  {
    const LightPiece& piece = this->Pieces.Near()[this->Order[begin]];
    this->Nodes.push_back({ piece.bounds, 0, begin, end, piece.numbers == PlaceNumbers::Two });
    return node;
  }
  const auto first = this->Order.begin();
  const std::uint32_t middle =
    begin + DividePieces(this->Pieces.Near(), { first + begin, first + end });
  this->Nodes.push_back({});
  const std::uint32_t one = this->Build(begin, middle);
  const std::uint32_t two = this->Build(middle, end);
  this->Nodes[node] = { Joined(this->Nodes[one].bounds, this->Nodes[two].bounds), two, begin, end,
    this->Nodes[one].isSurface && this->Nodes[two].isSurface };
  return node;
}

/// Whether bounds tell too little of a node, since it is large for its distance.
bool LightTree::IsNear(const Node& node, const glm::dvec3& point) const
{
  constexpr double Near = 3.0; // radii
  const glm::dvec3 way = node.bounds.centre - point;
  const glm::dvec3& half = node.bounds.half;
  return glm::dot(way, way) < Near * Near * glm::dot(half, half);
}

/// What is known of a group are its bounds. Of a single piece one place tells more: all of them
/// bring the same, or nearly so, before the cosine at the point.
double LightTree::Brightness(
  const Node& node, const glm::dvec3& point, const glm::dvec3& normal) const
{
  const double bound = PhotonTransport::Brightness(node.bounds, point, normal);
  if (node.second != 0 || !(bound > 0.0))
  {
    return bound;
  }
  const LightPiece& piece = this->Pieces.Near()[this->Order[node.begin]];
  const double perLumen = this->Pieces.Arriving(piece, point, glm::vec2(0.5f)).perLumen;
  return Pi * node.bounds.flux * perLumen * CosineBound(node.bounds, point, normal);
}

void LightTree::Add(std::uint32_t index, Cut& cut) const
{
  const Node& node = this->Nodes[index];
  const double brightness = this->Brightness(node, cut.Point, cut.Normal);
  if (!(brightness > 0.0))
  {
    return;
  }
  const bool opens = node.second != 0 && this->IsNear(node, cut.Point);
  cut.Entries[cut.Size++] = { index, brightness, opens ? brightness : 0.0, 0.0 };
}

LightTree::Cut LightTree::CutAt(
  const glm::dvec3& point, const glm::dvec3& normal, std::size_t most) const
{
  Cut cut;
  cut.Point = point;
  cut.Normal = normal;
  if (!this->Nodes.empty())
  {
    this->Add(0, cut);
  }
  const auto begin = cut.Entries.begin();
  const auto lessUrgent = [](const Cut::Entry& a, const Cut::Entry& b)
  { return a.priority < b.priority; };
  while (cut.Size > 0 && cut.Size < most && begin->priority > 0.0)
  {
    std::pop_heap(begin, begin + cut.Size, lessUrgent);
    const std::uint32_t node = cut.Entries[--cut.Size].node;
    for (const std::uint32_t child : { node + 1, this->Nodes[node].second })
    {
      const std::size_t before = cut.Size;
      this->Add(child, cut);
      if (cut.Size > before)
      {
        std::push_heap(begin, begin + cut.Size, lessUrgent);
      }
    }
  }
  std::sort(begin, begin + cut.Size,
    [](const Cut::Entry& a, const Cut::Entry& b) { return a.node < b.node; });
  this->Finish(cut);
  return cut;
}

/// Gives each node its interval.
void LightTree::Finish(Cut& cut) const
{
  double flux = 0.0;
  for (std::size_t i = 0; i < cut.Size; ++i)
  {
    cut.Sum += cut.Entries[i].brightness;
    flux += this->Nodes[cut.Entries[i].node].bounds.flux;
  }
  double end = 0.0;
  for (std::size_t i = 0; i < cut.Size; ++i)
  {
    Cut::Entry& entry = cut.Entries[i];
    end += (1.0 - Floor) * entry.brightness / cut.Sum +
      Floor * this->Nodes[entry.node].bounds.flux / flux;
    entry.end = i + 1 < cut.Size ? end : 1.0;
  }
}

LightTree::Choice LightTree::Choose(const Cut& cut, double number) const
{
  Choice choice;
  if (cut.Size > 0)
  {
    const auto begin = cut.Entries.begin();
    const auto chosen = std::upper_bound(begin, begin + (cut.Size - 1), number,
      [](double n, const Cut::Entry& entry) { return n < entry.end; });
    const double first = chosen == begin ? 0.0 : chosen[-1].end;
    choice.probability = chosen->end - first;
    choice.number = std::clamp((number - first) / choice.probability, 0.0, BelowOne);
    this->Descend(cut, chosen->node, choice);
  }
  return choice;
}

/// From a node to a piece.
void LightTree::Descend(const Cut& cut, std::uint32_t at, Choice& choice) const
{
  while (this->Nodes[at].second != 0)
  {
    if (this->Nodes[at].isSurface && !this->IsNear(this->Nodes[at], cut.Point))
    {
      this->ChooseByFlux(this->Nodes[at], choice);
      return;
    }
    const Node &one = this->Nodes[at + 1], &two = this->Nodes[this->Nodes[at].second];
    const double first = this->Brightness(one, cut.Point, cut.Normal);
    const double second = this->Brightness(two, cut.Point, cut.Normal);
    if (!(first + second > 0.0))
    {
      choice.probability = 0.0;
      return;
    }
    double share = first > 0.0 ? 1.0 : 0.0;
    if (first > 0.0 && second > 0.0)
    {
      share = (1.0 - Floor) * first / (first + second) +
        Floor * one.bounds.flux / (one.bounds.flux + two.bounds.flux);
    }
    const bool takesFirst = choice.number < share;
    choice.number = takesFirst ? choice.number / share : (choice.number - share) / (1.0 - share);
    choice.number = std::min(choice.number, BelowOne);
    choice.probability *= takesFirst ? share : 1.0 - share;
    at = takesFirst ? at + 1 : this->Nodes[at].second;
  }
  choice.piece = this->Order[this->Nodes[at].begin];
}

void LightTree::ChooseByFlux(const Node& node, Choice& choice) const
{
  const auto upTo = this->FluxUpTo.begin();
  const double first = upTo[node.begin];
  const double whole = upTo[node.end] - first;
  const double place = first + choice.number * whole;
  // Of the pieces but the last one the first that ends beyond the place.
  const auto end = std::upper_bound(upTo + node.begin + 1, upTo + node.end, place);
  const double flux = *end - end[-1];
  choice.piece = this->Order[static_cast<std::size_t>(end - upTo) - 1];
  choice.number = std::clamp((place - end[-1]) / flux, 0.0, BelowOne);
  choice.probability *= flux / whole;
}

} // namespace PhotonTransport
