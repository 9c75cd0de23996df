// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/LuminaireNames.h"

#include <set>
#include <string>

namespace Illumination
{
namespace
{

bool IsBlank(const std::string& name)
{
  return name.find_first_not_of(" \t\r\n") == std::string::npos;
}

} // namespace

void GiveNames(std::vector<PhotonTransport::Luminaire>& luminaires)
{
  std::set<std::string> taken;
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < luminaires.size(); ++i)
  {
    if (IsBlank(luminaires[i].name) || !taken.insert(luminaires[i].name).second)
    {
      rest.push_back(i);
    }
  }
  for (const std::size_t i : rest)
  {
    std::string& name = luminaires[i].name;
    const std::string wanted = IsBlank(name) ? "Lamp " + std::to_string(i + 1) : name;
    name = wanted;
    for (int copy = 2; !taken.insert(name).second; ++copy)
    {
      name = wanted + " (" + std::to_string(copy) + ")";
    }
  }
}

} // namespace Illumination
