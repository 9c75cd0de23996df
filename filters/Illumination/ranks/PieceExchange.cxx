// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/ranks/PieceExchange.h"

#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/ranks/TreeChildren.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTypes.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace Illumination
{
namespace
{

/// Adds the leaves below a node. @param index The node's flat index, which moves on to the last one
/// below it.
void AddLeaves(
  vtkDataObject* node, const BlockPath& path, unsigned& index, std::vector<Piece>& pieces)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(node);
  if (!tree)
  {
    if (node)
    {
      pieces.push_back({ path, " of block " + std::to_string(index), node });
    }
    return;
  }
  const bool isOneBlock = vtkPartitionedDataSet::SafeDownCast(tree) != nullptr;
  ForEachChild(tree,
    [&](vtkDataObjectTreeIterator* it, int child)
    {
      BlockPath below = path;
      if (!isOneBlock)
      {
        below.push_back(child);
      }
      AddLeaves(it->GetCurrentDataObject(), below, ++index, pieces);
    });
}

/// Bytes to send, and to read in the same order.
class Message
{
public:
  Message() = default;
  explicit Message(std::vector<char> bytes)
    : Bytes(std::move(bytes))
  {
  }

  void Put(const char* bytes, std::size_t size)
  {
    const auto length = static_cast<std::uint64_t>(size);
    const char* ofLength = reinterpret_cast<const char*>(&length);
    this->Bytes.insert(this->Bytes.end(), ofLength, ofLength + sizeof(length));
    this->Bytes.insert(this->Bytes.end(), bytes, bytes + size);
  }
  /// The next bytes, and how many they are. They stay where they are.
  const char* Get(std::size_t& size)
  {
    std::uint64_t length = 0;
    std::memcpy(&length, this->Bytes.data() + this->Next, sizeof(length));
    size = static_cast<std::size_t>(length);
    const char* bytes = this->Bytes.data() + this->Next + sizeof(length);
    this->Next += sizeof(length) + size;
    return bytes;
  }
  std::string GetText()
  {
    std::size_t size = 0;
    const char* bytes = this->Get(size);
    return { bytes, size };
  }
  bool IsAtEnd() const { return this->Next >= this->Bytes.size(); }

  std::vector<char> Bytes;

private:
  std::size_t Next = 0;
};

void Put(const Piece& piece, Message& message)
{
  message.Put(reinterpret_cast<const char*>(piece.path.data()), piece.path.size() * sizeof(int));
  message.Put(piece.name.data(), piece.name.size());
  const std::string type = piece.data->GetClassName();
  auto* surface = vtkPolyData::SafeDownCast(piece.data);
  if (!surface)
  {
    message.Put(type.data(), type.size());
    message.Put(nullptr, 0);
    return;
  }
  RequireValidCells(surface, piece.name);
  RequireArraySizes(surface, piece.name);
  vtkNew<vtkCharArray> bytes;
  if (!vtkCommunicator::MarshalDataObject(surface, bytes))
  {
    throw std::runtime_error("the surface" + piece.name + " can't be sent to other ranks");
  }
  message.Put("vtkPolyData", std::strlen("vtkPolyData"));
  message.Put(bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

Piece Get(Message& message, std::size_t rank)
{
  Piece piece;
  piece.rank = rank;
  std::size_t size = 0;
  const char* path = message.Get(size);
  piece.path.resize(size / sizeof(int));
  if (size > 0)
  {
    std::memcpy(piece.path.data(), path, size);
  }
  piece.name = message.GetText();
  const std::string type = message.GetText();
  piece.data = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(type.c_str()));
  const char* bytes = message.Get(size);
  if (size > 0)
  {
    vtkNew<vtkCharArray> array; // which only reads
    array->SetArray(const_cast<char*>(bytes), static_cast<vtkIdType>(size), 1);
    vtkCommunicator::UnMarshalDataObject(array, piece.data);
  }
  return piece;
}

} // namespace

std::vector<Piece> PiecesOf(vtkDataObject* data, const BlockPath& root)
{
  std::vector<Piece> pieces;
  unsigned index = 0;
  if (vtkDataObjectTree::SafeDownCast(data))
  {
    AddLeaves(data, root, index, pieces);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data)) // such as AMR
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      BlockPath path = root;
      path.push_back(static_cast<int>(it->GetCurrentFlatIndex()));
      pieces.push_back({ path, " of block " + std::to_string(it->GetCurrentFlatIndex()),
        it->GetCurrentDataObject() });
    }
  }
  else if (data)
  {
    pieces.push_back({ root, "", data });
  }
  return pieces;
}

std::vector<Piece> PiecesOfAllRanks(ControllerRanks& ranks, const std::vector<Piece>& own)
{
  Message message;
  for (const Piece& piece : own)
  {
    Put(piece, message);
  }
  std::vector<Piece> all;
  std::vector<std::vector<char>> gathered = ranks.Gather(message.Bytes);
  for (std::size_t rank = 0; rank < gathered.size(); ++rank)
  {
    Message received(std::move(gathered[rank]));
    while (!received.IsAtEnd())
    {
      all.push_back(Get(received, rank));
    }
  }
  return all;
}

} // namespace Illumination
