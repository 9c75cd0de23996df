// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/NearGuide.h"

#include "PhotonTransport/sampling/Warps.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// Share of the rays that follow the guide where all light comes from afar.
constexpr float Most = 0.4f;

/// By which light from close by counts: a facet beside gets it from other directions, if at all.
constexpr float WorthOfNear = 0.3f;

/// Below this cosine at the receiver the solid angle of a cell counts as at this one.
constexpr float LeastCosine = 0.2f;

glm::vec3 DirectionIn(std::size_t cell, std::size_t size, const glm::vec2& within)
{
  const glm::vec2 place = (glm::vec2(cell / size, cell % size) + within) / static_cast<float>(size);
  return CosineHemisphere(place.x, place.y);
}

} // namespace

void NearGuide::Set(const Guide& guide, const Frame& frame, const std::vector<std::uint8_t>& near)
{
  this->Axes = frame;
  this->Facing = glm::vec3(0.0f);
  const std::size_t cells = guide.Side() * guide.Side();
  if (this->Size != guide.Side())
  {
    this->Size = guide.Side();
    this->Middles.resize(cells);
    for (std::size_t i = 0; i < cells; ++i)
    {
      const glm::vec3 middle = DirectionIn(i, this->Size, glm::vec2(0.5f));
      this->Middles[i] = middle / std::max(LeastCosine, middle.z);
    }
  }
  this->Shares.resize(cells);
  float far = 0.0f;
  for (std::size_t i = 0; i < cells; ++i)
  {
    this->Shares[i] = guide.ShareOf(i) * (near[i] != 0 ? WorthOfNear : 1.0f);
    far += near[i] != 0 ? 0.0f : guide.ShareOf(i);
  }
  this->MostGuided = Most * std::min(1.0f, far);
}

NearGuide::Way NearGuide::At(const glm::vec3& normal, float u, float v)
{
  if (normal != this->Facing)
  {
    this->Face(normal);
  }
  const float byGuide = this->Ends.back() > 0.0f ? this->MostGuided : 0.0f;
  const float byCosine = 1.0f - byGuide;
  const bool guided = u >= byCosine;
  const float place = guided ? (u - byCosine) / byGuide : u / byCosine;
  const float first = std::min(place, 1.0f - 0x1p-24f); // it may have rounded up to 1
  const glm::vec3 direction =
    guided ? this->Guided(first, v) : Frame(normal).ToWorld(CosineHemisphere(first, v));
  const float cosine = glm::dot(direction, normal);
  if (!(cosine > 0.0f))
  {
    return { direction, 0.0f };
  }
  const float ofGuide = byGuide > 0.0f ? byGuide * this->DensityOf(direction) : 0.0f;
  return { direction, cosine / (byCosine * cosine + ofGuide) };
}

void NearGuide::Face(const glm::vec3& normal)
{
  this->Facing = normal;
  const glm::vec3 inFrame(glm::dot(normal, this->Axes.tangent),
    glm::dot(normal, this->Axes.bitangent), glm::dot(normal, this->Axes.normal));
  this->Ends.resize(this->Shares.size());
  float sum = 0.0f;
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    sum += this->Shares[i] * std::max(0.0f, glm::dot(this->Middles[i], inFrame));
    this->Ends[i] = sum;
  }
}

/// A direction by what cells bring to the facet.
glm::vec3 NearGuide::Guided(float u, float v) const
{
  const float place = u * this->Ends.back();
  const auto end = std::upper_bound(this->Ends.begin(), this->Ends.end() - 1, place);
  const float begin = end == this->Ends.begin() ? 0.0f : end[-1];
  const float within = std::clamp((place - begin) / (*end - begin), 0.0f, 1.0f - 0x1p-24f);
  return this->Axes.ToWorld(DirectionIn(
    static_cast<std::size_t>(end - this->Ends.begin()), this->Size, glm::vec2(within, v)));
}

/// That of Guided by solid angle, times pi.
float NearGuide::DensityOf(const glm::vec3& direction) const
{
  const float cosine = glm::dot(direction, this->Axes.normal);
  if (!(cosine > 0.0f))
  {
    return 0.0f;
  }
  const glm::vec2 square = SquareOfDisk(
    { glm::dot(direction, this->Axes.tangent), glm::dot(direction, this->Axes.bitangent) });
  const auto size = static_cast<float>(this->Size);
  const auto interval = [&](float x)
  { return std::min(static_cast<std::size_t>(std::max(0.0f, x) * size), this->Size - 1); };
  const std::size_t cell = interval(square.x) * this->Size + interval(square.y);
  const float ofCell = this->Ends[cell] - (cell > 0 ? this->Ends[cell - 1] : 0.0f);
  return cosine * ofCell / this->Ends.back() * size * size;
}

} // namespace PhotonTransport
