// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceFile.h"

#include <fstream>
#include <stdexcept>

namespace
{

constexpr std::uint64_t Mark = 0x31666572746e6f70u; // also tells the order of bytes

template <typename T>
void WriteAll(std::ofstream& file, const T* values, std::size_t count)
{
  file.write(
    reinterpret_cast<const char*>(values), static_cast<std::streamsize>(sizeof(T) * count));
}

template <typename T>
void ReadAll(std::ifstream& file, T* values, std::size_t count)
{
  file.read(reinterpret_cast<char*>(values), static_cast<std::streamsize>(sizeof(T) * count));
}

} // namespace

void Store(const StoredReference& reference, const std::string& fileName)
{
  std::ofstream file(fileName, std::ios::binary);
  const std::uint64_t count = reference.vertices.size();
  WriteAll(file, &Mark, 1);
  WriteAll(file, &count, 1);
  WriteAll(file, &reference.seconds, 1);
  WriteAll(file, reference.vertices.data(), count);
  WriteAll(file, reference.estimates.data(), count);
  if (!file.flush())
  {
    throw std::runtime_error(fileName + ": can't be written");
  }
}

StoredReference LoadReference(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  const auto size = file ? static_cast<std::uint64_t>(file.tellg()) : 0;
  file.seekg(0);
  std::uint64_t mark = 0, count = 0;
  StoredReference reference;
  ReadAll(file, &mark, 1);
  ReadAll(file, &count, 1);
  ReadAll(file, &reference.seconds, 1);
  constexpr std::uint64_t Header = 24;
  constexpr std::uint64_t Entry = sizeof(std::uint32_t) + sizeof(PointEstimate);
  if (!file || mark != Mark || count > size / Entry || size != Header + Entry * count)
  {
    throw std::runtime_error(fileName + ": no reference; make it by the command 'reference'");
  }
  reference.vertices.resize(count);
  reference.estimates.resize(count);
  ReadAll(file, reference.vertices.data(), count);
  ReadAll(file, reference.estimates.data(), count);
  return reference;
}
