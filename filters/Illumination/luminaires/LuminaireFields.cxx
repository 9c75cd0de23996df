// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/LuminaireFields.h"

#include "Illumination/luminaires/EmittingSurface.h"
#include "Illumination/luminaires/LuminairePlace.h"
#include "Illumination/pipeline/FieldValues.h"
#include "Illumination/pipeline/InputError.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"
#include "vtkType.h"

#include <algorithm>
#include <sstream>

namespace Illumination
{
namespace
{

using namespace PhotonTransport;

constexpr const char* Type = "LuminaireType";
constexpr const char* Error = "LuminaireError";

/// FieldWriter and FieldReader share this function. A value that fields hold in another type is
/// converted, passed, and converted back.
template <typename Fields>
void Pass(const Fields& fields, Luminaire& luminaire)
{
  fields("LuminaireName", luminaire.name);
  glm::dvec3 colour(luminaire.colour);
  fields("LuminaireColour", colour);
  const auto [least, largest] = std::minmax({ colour.x, colour.y, colour.z });
  if (least < 0.0 || !(largest > 0.0) || largest > VTK_FLOAT_MAX)
  {
    std::ostringstream text;
    text << "is (" << colour.x << ", " << colour.y << ", " << colour.z
         << "); its parts must be 0 or more, and one above 0";
    fields.Refuse("LuminaireColour", text.str());
  }
  luminaire.colour = Colour(colour);
  fields.IfGiven("LuminaireDimming", luminaire.dimming);
  if (luminaire.dimming < 0.0)
  {
    std::ostringstream text;
    text << "is " << luminaire.dimming << "; it must be 0 or more";
    fields.Refuse("LuminaireDimming", text.str());
  }
  std::visit([&](auto& lamp) { lamp.Describe(fields); }, luminaire.lamp);
}

/// The LuminaireType; nullptr for emitting surfaces, which are not described by field data.
const char* NameOf(const Lamp& lamp)
{
  return std::visit([](const auto& l) { return l.Name; }, lamp);
}

Luminaire ReadFields(const FieldReader& fields)
{
  std::string type;
  fields(Type, type);
  std::string known;
  for (const Lamp& kind : LampOfEachKind())
  {
    const char* name = NameOf(kind);
    if (name && type == name)
    {
      Luminaire luminaire{ kind, {} };
      Pass(fields, luminaire);
      return luminaire;
    }
    known += name ? (known.empty() ? "" : ", ") + std::string(name) : "";
  }
  fields.Refuse(Type, "is '" + type + "'; known types are " + known);
}

void Move(Lamp& lamp, const Similarity& motion)
{
  if (!motion.isNone)
  {
    try
    {
      std::visit([&](auto& l) { l.Move(motion); }, lamp);
    }
    catch (const InvalidInput& error)
    {
      throw InputError(error.what());
    }
  }
}

} // namespace

void AddLuminaire(vtkFieldData* fields, const Luminaire& luminaire)
{
  const char* type = NameOf(luminaire.lamp);
  if (!type)
  {
    throw InputError("emitting surfaces are not described by field data");
  }
  const FieldWriter writer(fields);
  writer(Type, std::string(type));
  Luminaire passed = luminaire;
  Pass(writer, passed);
}

void AddLuminaireError(vtkFieldData* fields, const std::string& error)
{
  AddArray(fields, Error, std::vector<std::string>{ error });
}

bool HasLuminaireFields(vtkFieldData* fields)
{
  return fields->HasArray(Type) || fields->HasArray(Error);
}

std::optional<Luminaire> ReadLuminaire(vtkPolyData* data)
{
  vtkFieldData* fields = data->GetFieldData();
  if (fields->HasArray(Error))
  {
    std::string error;
    FieldReader reader(fields);
    reader(Error, error);
    throw InputError("its source has an error: " + error);
  }
  if (HasLuminairePoints(data) && !fields->HasArray(Type))
  {
    throw InputError("it has a luminaire's points but lost the field data that describe it, in a "
                     "filter that does not keep them; connect the luminaire before that filter");
  }
  if (fields->HasArray(Type))
  {
    Luminaire luminaire = ReadFields(FieldReader(fields));
    if (data->GetCellData()->HasArray("Exitance"))
    {
      throw InputError("it has both the field data of a luminaire and a cell array 'Exitance'; "
                       "remove one of them to say which of them shines");
    }
    Move(luminaire.lamp, MotionOf(data));
    return luminaire;
  }
  return ReadEmittingSurface(data);
}

} // namespace Illumination
