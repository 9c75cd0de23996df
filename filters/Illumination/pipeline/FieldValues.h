// SPDX-License-Identifier: BSD-3-Clause
// Writes values to field arrays and reads them back, by calls of the same form.
#ifndef FieldValues_h
#define FieldValues_h

#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/InputError.h"

#include "vtkDataArray.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <utility>

namespace Illumination
{

/// What writing and reading share. @tparam Passer The class that derives from this one.
template <typename Passer>
class FieldPasser
{
public:
  explicit FieldPasser(vtkFieldData* fields)
    : Fields(fields)
  {
  }
  /// A value that has fields of its own.
  template <typename Part>
  auto operator()(const char*, Part& part) const
    -> decltype(DescribeFields(std::declval<const Passer&>(), part))
  {
    DescribeFields(static_cast<const Passer&>(*this), part);
  }
  /// Throws InputError.
  [[noreturn]] static void Refuse(const std::string& array, const std::string& message)
  {
    throw InputError("field array '" + array + "' " + message);
  }

protected:
  vtkFieldData* Fields;
};

/// Puts each value into a field array of its name.
class FieldWriter : public FieldPasser<FieldWriter>
{
public:
  using FieldPasser::FieldPasser;
  using FieldPasser::operator();
  void operator()(const char* name, const std::string& text) const
  {
    AddArray(this->Fields, name, std::vector<std::string>{ text });
  }
  void operator()(const char* name, const std::vector<std::string>& texts) const
  {
    AddArray(this->Fields, name, texts);
  }
  void operator()(const char* name, const std::vector<double>& numbers) const
  {
    AddArray(this->Fields, name, numbers);
  }
  void operator()(const char* name, double number) const
  {
    AddArray(this->Fields, name, std::vector<double>{ number });
  }
  void operator()(const char* name, const glm::dvec3& v) const
  {
    AddArray(this->Fields, name, std::vector<std::array<double, 3>>{ { v.x, v.y, v.z } });
  }
  void operator()(const char* name, const glm::dvec2& v) const
  {
    (*this)(name, std::vector<double>{ v.x, v.y });
  }
  void operator()(const char* name, int number, int, int) const
  {
    (*this)(name, static_cast<double>(number));
  }
  void operator()(const char* name, bool is) const { (*this)(name, is ? 1.0 : 0.0); }
  void IfGiven(const char* name, double number) const { (*this)(name, number); }
};

/// Takes each value from the field array of its name. Throws InputError for an array that is
/// missing, of the wrong size or kind, or holds a number that is not finite.
class FieldReader : public FieldPasser<FieldReader>
{
public:
  using FieldPasser::FieldPasser;
  using FieldPasser::operator();
  void operator()(const char* name, std::string& text) const
  {
    auto* array = vtkStringArray::SafeDownCast(this->Found(name));
    if (!array || array->GetNumberOfValues() != 1)
    {
      Refuse(name, "is not one text");
    }
    text = array->GetValue(0);
  }
  /// Any number of texts; none where the array is missing.
  void operator()(const char* name, std::vector<std::string>& texts) const
  {
    auto* array = vtkStringArray::SafeDownCast(this->Fields->GetAbstractArray(name));
    texts.clear();
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      texts.push_back(array->GetValue(i));
    }
  }
  void operator()(const char* name, std::vector<double>& numbers) const
  {
    vtkAbstractArray* found = this->Found(name);
    auto* array = vtkDataArray::SafeDownCast(found);
    if (!array)
    {
      Refuse(name, "is a " + std::string(found->GetClassName()) + ", not numbers");
    }
    const int components = array->GetNumberOfComponents();
    numbers.clear();
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      const auto component = static_cast<int>(i % components);
      numbers.push_back(array->GetComponent(i / components, component));
      if (!std::isfinite(numbers.back()))
      {
        Refuse(name, "has the value " + std::to_string(numbers.back()) + ", which is not finite");
      }
    }
  }
  void operator()(const char* name, double& number) const
  {
    number = this->Numbers(name, 1).front();
  }
  void operator()(const char* name, glm::dvec3& v) const
  {
    const std::vector<double> numbers = this->Numbers(name, 3);
    v = { numbers[0], numbers[1], numbers[2] };
  }
  void operator()(const char* name, glm::dvec2& v) const
  {
    const std::vector<double> numbers = this->Numbers(name, 2);
    v = { numbers[0], numbers[1] };
  }
  void operator()(const char* name, int& number, int least, int most) const
  {
    const double read = this->Numbers(name, 1).front();
    if (!(read >= least && read <= most && read == std::floor(read)))
    {
      Refuse(name,
        "is " + std::to_string(read) + "; it must be a whole number from " + std::to_string(least) +
          " to " + std::to_string(most));
    }
    number = static_cast<int>(read);
  }
  void operator()(const char* name, bool& is) const { is = this->Numbers(name, 1).front() != 0.0; }
  /// Leaves the number as it is where the array is missing, as in data of earlier versions.
  void IfGiven(const char* name, double& number) const
  {
    if (this->Fields->GetAbstractArray(name))
    {
      (*this)(name, number);
    }
  }

private:
  vtkAbstractArray* Found(const char* name) const
  {
    vtkAbstractArray* array = this->Fields->GetAbstractArray(name);
    if (!array)
    {
      Refuse(name, "is missing, which luminaires of this LuminaireType have");
    }
    return array;
  }
  std::vector<double> Numbers(const char* name, std::size_t count) const
  {
    std::vector<double> numbers;
    (*this)(name, numbers);
    if (numbers.size() != count)
    {
      Refuse(name,
        "has " + std::to_string(numbers.size()) + " values; " + std::to_string(count) +
          " are wanted");
    }
    return numbers;
  }
};

} // namespace Illumination

#endif
