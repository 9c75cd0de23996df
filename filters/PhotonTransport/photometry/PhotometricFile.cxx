// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/PhotometricFile.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace PhotonTransport
{

namespace
{

std::string LowerCaseExtension(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

bool IsEulumdat(const std::string& extension)
{
  return extension == ".ldt" || extension == ".eul";
}

} // namespace

bool IsPhotometricFileName(const std::string& path)
{
  const std::string extension = LowerCaseExtension(path);
  return extension == ".ies" || IsEulumdat(extension);
}

PhotometricSolid ReadPhotometricFile(const std::string& path)
{
  if (!IsPhotometricFileName(path))
  {
    throw std::runtime_error(
      "'" + path + "' has none of the extensions .ies, .ldt and .eul of photometric files");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw std::runtime_error("can't open the photometric file '" + path + "'");
  }
  return IsEulumdat(LowerCaseExtension(path))
    ? ReadEulumdat(file)
    : ReadIes(file, std::filesystem::path(path).parent_path().string());
}

} // namespace PhotonTransport
