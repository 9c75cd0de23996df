// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Scene.h"

#include <memory>
#include <vector>

/// Nothing but rtcIntersect1 on recorded rays, on a scene with the tracer's own triangles.
class BareEmbree
{
public:
  /// @param robust Whether Embree is told to let no ray slip through an edge, as the tracer does.
  BareEmbree(const PhotonTransport::Scene& scene, const std::vector<PhotonTransport::Ray>& rays,
    int threads, bool robust = true);
  ~BareEmbree();

  /// Traces all rays once.
  void Replay();

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};
