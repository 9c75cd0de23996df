// SPDX-License-Identifier: BSD-3-Clause
// Properties whose values in the panel somebody follows, applied or not.
#ifndef pqObservedProperties_h
#define pqObservedProperties_h

#include "vtkCommand.h"
#include "vtkSMProperty.h"
#include "vtkWeakPointer.h"

#include <utility>
#include <vector>

/// Ends all observations with itself.
class pqObservedProperties
{
public:
  pqObservedProperties() = default;
  pqObservedProperties(const pqObservedProperties&) = delete;
  pqObservedProperties& operator=(const pqObservedProperties&) = delete;
  ~pqObservedProperties()
  {
    for (const auto& [property, observer] : this->All)
    {
      if (property)
      {
        property->RemoveObserver(observer);
      }
    }
  }

  /// @param property May be null. @param onChange A member of the object.
  template <class Object, class Base>
  void add(vtkSMProperty* property, Object* object, void (Base::*onChange)())
  {
    if (property)
    {
      this->All.emplace_back(property,
        property->AddObserver(
          vtkCommand::UncheckedPropertyModifiedEvent, static_cast<Base*>(object), onChange));
    }
  }

private:
  std::vector<std::pair<vtkWeakPointer<vtkSMProperty>, unsigned long>> All;
};

#endif
