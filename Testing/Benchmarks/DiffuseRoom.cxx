// SPDX-License-Identifier: BSD-3-Clause
// Traces blocks of 256 photons through the room with sphere, from a point lamp, on one thread:
//
//   DiffuseRoom REFLECTANCE BLOCKS
//
// instructions.sh compiles it with the core of two commits, so it uses only what has always been
// there.
#include "Shapes.h"

#include "PhotonTransport/transport/PhotonTracer.h"

#include <cstdio>
#include <cstdlib>

using namespace PhotonTransport;

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    return 2;
  }
  const auto reflectance = static_cast<float>(std::atof(argv[1]));
  const Scene scene(Shapes::WithReflectance(Shapes::RoomWithSphere(20'000), reflectance));
  TraceSettings settings;
  settings.threads = 1;
  const Lamp lamp = PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 };
  PhotonTracer tracer(scene, lamp, settings);
  IlluminationSums sums = tracer.EmptySums();
  tracer.Trace(0, 0, std::strtoull(argv[2], nullptr, 10), sums);
  std::printf("%llu segments\n", static_cast<unsigned long long>(sums.Balance().segments));
  return 0;
}
