// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/PlaneGraph.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

std::uint32_t Back(std::uint32_t way)
{
  return way ^ 1u;
}

/// Twice the area, > 0 if the nodes run counter-clockwise.
double TwiceArea(const std::vector<glm::dvec2>& nodes, const std::vector<std::uint32_t>& polygon)
{
  double sum = 0.0;
  const glm::dvec2& origin = nodes[polygon.front()];
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2 a = nodes[polygon[i]] - origin;
    const glm::dvec2 b = nodes[polygon[(i + 1) % polygon.size()]] - origin;
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

} // namespace

PlaneGraph::PlaneGraph(const std::vector<glm::dvec2>& nodes, const std::vector<PlanePiece>& pieces)
  : Nodes(nodes)
  , Pieces(pieces)
  , Removed(pieces.size(), 0)
  , WaysFrom(nodes.size())
{
  for (std::uint32_t way = 0; way < 2 * pieces.size(); ++way)
  {
    this->WaysFrom[this->Start(way)].push_back(way);
  }
  this->RemoveLooseEnds();
  this->SortWays();
}

std::uint32_t PlaneGraph::Start(std::uint32_t way) const
{
  const PlanePiece& piece = this->Pieces[way / 2];
  return way % 2 == 0 ? piece.from : piece.to;
}

bool PlaneGraph::IsCovered(std::uint32_t way) const
{
  const PlanePiece& piece = this->Pieces[way / 2];
  return way % 2 == 0 ? piece.coveredLeft : piece.coveredRight;
}

double PlaneGraph::Angle(std::uint32_t way) const
{
  const glm::dvec2 along = this->Nodes[this->Start(Back(way))] - this->Nodes[this->Start(way)];
  return std::atan2(along.y, along.x);
}

void PlaneGraph::RemoveLooseEnds()
{
  const auto remains = [&](std::uint32_t way) { return this->Removed[way / 2] == 0; };
  for (std::uint32_t first = 0; first < this->WaysFrom.size(); ++first)
  {
    std::uint32_t node = first;
    while (std::count_if(this->WaysFrom[node].begin(), this->WaysFrom[node].end(), remains) == 1)
    {
      const std::uint32_t way =
        *std::find_if(this->WaysFrom[node].begin(), this->WaysFrom[node].end(), remains);
      this->Removed[way / 2] = 1;
      node = this->Start(Back(way));
    }
  }
}

void PlaneGraph::SortWays()
{
  for (std::vector<std::uint32_t>& ways : this->WaysFrom)
  {
    ways.erase(std::remove_if(ways.begin(), ways.end(),
                 [&](std::uint32_t way) { return this->Removed[way / 2] != 0; }),
      ways.end());
    std::sort(ways.begin(), ways.end(),
      [&](std::uint32_t a, std::uint32_t b) { return this->Angle(a) < this->Angle(b); });
  }
}

/// The way on along what lies to the left: the first one clockwise from the way back.
std::uint32_t PlaneGraph::Next(std::uint32_t way) const
{
  const std::vector<std::uint32_t>& ways = this->WaysFrom[this->Start(Back(way))];
  const auto back = std::find(ways.begin(), ways.end(), Back(way));
  return back == ways.begin() ? ways.back() : *(back - 1);
}

std::vector<PlaneFace> PlaneGraph::FreeFaces() const
{
  std::vector<PlaneFace> faces;
  std::vector<std::uint8_t> walked(2 * this->Pieces.size(), 0);
  for (std::uint32_t first = 0; first < walked.size(); ++first)
  {
    if (walked[first] != 0 || this->Removed[first / 2] != 0)
    {
      continue;
    }
    PlaneFace face;
    bool covered = false;
    for (std::uint32_t way = first; walked[way] == 0; way = this->Next(way))
    {
      walked[way] = 1;
      covered = covered || this->IsCovered(way);
      face.nodes.push_back(this->Start(way));
      face.pieces.push_back(way / 2);
    }
    if (!covered && TwiceArea(this->Nodes, face.nodes) > 0.0)
    {
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

} // namespace PhotonTransport
