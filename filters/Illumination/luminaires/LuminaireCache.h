// SPDX-License-Identifier: BSD-3-Clause
// Luminaires as they were read last, since reading a large surface that shines takes a while.
#ifndef LuminaireCache_h
#define LuminaireCache_h

#include "PhotonTransport/lights/Lamp.h"

#include "vtkPolyData.h"
#include "vtkType.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace Illumination
{

class LuminaireCache
{
public:
  /// The luminaire of data: read anew only if the data have changed since the last call of Renew.
  const PhotonTransport::Luminaire& Of(
    vtkPolyData* data, const std::function<PhotonTransport::Luminaire()>& read)
  {
    const vtkMTimeType time = data->GetMTime();
    const auto same = std::find_if(this->Last.begin(), this->Last.end(),
      [&](const Entry& entry) { return entry.data == data && entry.time == time; });
    this->Now.push_back(same == this->Last.end() ? Entry{ data, time, read() } : *same);
    return this->Now.back().luminaire;
  }

  /// Forgets what was not asked for since it was called last.
  void Renew() { this->Last = std::exchange(this->Now, {}); }

private:
  struct Entry
  {
    const vtkPolyData* data; ///< To compare only: it may be gone.
    vtkMTimeType time;
    PhotonTransport::Luminaire luminaire;
  };
  std::vector<Entry> Last, Now;
};

} // namespace Illumination

#endif
