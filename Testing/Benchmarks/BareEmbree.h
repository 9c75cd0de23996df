// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"

#include <memory>
#include <vector>

/// Nothing but rtcIntersect1 on recorded rays, on a scene with the tracer's own triangles and
/// flags.
class BareEmbree
{
public:
  BareEmbree(const PhotonTransport::Scene& scene, const std::vector<PhotonTransport::Ray>& rays,
    int threads);
  ~BareEmbree();

  /// Traces all rays once.
  void Replay();

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};
