// SPDX-License-Identifier: BSD-3-Clause
// A luminaire goes where the points of its glyph go, and is refused where they say nothing clear.
#include "LuminaireTools.h"

#include "PhotonTransport/lights/Lamp.h"

#include "vtkAppendPolyData.h"
#include "vtkCleanPolyData.h"
#include "vtkClipPolyData.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataNormals.h"
#include "vtkReverseSense.h"
#include "vtkTriangleFilter.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <type_traits>
#include <vector>

namespace
{

using namespace PhotonTransport;

const glm::dvec3 Position(0.3, -0.2, 0.5);
const glm::dvec3 Direction(0.4, 0.3, -1.0);

vtkSmartPointer<vtkLuminaireSource> PlacedSource(int type, const char* file = "asymmetric_c.ies")
{
  auto source = Source(type);
  source->SetPosition(Position.x, Position.y, Position.z);
  source->SetDirection(Direction.x, Direction.y, Direction.z);
  source->SetSize(0.6, 0.2);
  source->SetSpotHalfAngle(90.0); // whose cone is flat
  source->SetRotation(25.0);
  source->SetSkyType(12);
  source->SetSunAltitude(30.0);
  source->SetFileName(PhotometricFile(file).c_str());
  source->Update();
  return source;
}

/// What a lamp is made of: points, directions (of any length) and lengths.
struct Parts
{
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec3> directions;
  std::vector<double> lengths;
};

/// Collects the parts among the values that describe a lamp; see LampKind.h.
struct AddParts
{
  Parts& parts;

  void operator()(const std::string& name, const glm::dvec3& v) const
  {
    (name == "LuminairePosition" ? this->parts.points : this->parts.directions).push_back(v);
  }
  void operator()(const std::string& name, const glm::dvec2& v) const
  {
    EXPECT_EQ(name, "LuminaireSize");
    this->parts.lengths.insert(this->parts.lengths.end(), { v.x, v.y });
  }
  void operator()(const std::string& name, double value) const
  {
    if (name == "LuminaireSize")
    {
      this->parts.lengths.push_back(value);
    }
  }
  void operator()(const std::string&, int, int, int) const {}
  void operator()(const std::string&, bool) const {}
  void operator()(const std::string&, const PhotometricSolid&) const {}
};

/// Adds the axes in which lamps of some kinds lie and which no field of theirs holds.
template <typename AnyLamp>
void AddAxes(const AnyLamp& lamp, Parts& parts)
{
  if constexpr (std::is_same_v<AnyLamp, RectangleLamp>)
  {
    const auto axes = lamp.Axes();
    parts.points.push_back(lamp.centre + 0.5 * lamp.width * axes.width);
    parts.points.push_back(lamp.centre + 0.5 * lamp.height * axes.height);
  }
  else if constexpr (std::is_same_v<AnyLamp, PhotometricLamp>)
  {
    const auto axes = lamp.Axes();
    parts.directions.insert(parts.directions.end(), { axes.x, axes.y });
  }
}

Parts PartsOf(Lamp lamp)
{
  Parts parts;
  std::visit(
    [&](auto& l)
    {
      l.Describe(AddParts{ parts });
      AddAxes(l, parts);
    },
    lamp);
  return parts;
}

struct Place
{
  const char* name;
  double scale;
  std::function<void(vtkTransform*)> setUp;
};

const std::vector<Place> Places{ { "moved", 1.0, [](vtkTransform* t) { t->Translate(3, -2, 1); } },
  { "turned", 1.0,
    [](vtkTransform* t)
    {
      t->RotateX(30);
      t->RotateY(50);
      t->RotateZ(70);
    } },
  { "turned by half a turn", 1.0, [](vtkTransform* t) { t->RotateX(180); } },
  { "turned by half a turn about z", 1.0, [](vtkTransform* t) { t->RotateZ(180); } },
  { "enlarged", 2.5, [](vtkTransform* t) { t->Scale(2.5, 2.5, 2.5); } },
  { "in millimetres", 1000.0, [](vtkTransform* t) { t->Scale(1000, 1000, 1000); } },
  { "in kilometres", 0.001, [](vtkTransform* t) { t->Scale(0.001, 0.001, 0.001); } },
  { "far away and turned", 1.0,
    [](vtkTransform* t)
    {
      t->Translate(1e6, -1e6, 1e6);
      t->RotateWXYZ(111, 1, 2, 3);
    } },
  { "all at once", 0.3,
    [](vtkTransform* t)
    {
      t->Translate(7, 8, 9);
      t->RotateY(-120);
      t->Scale(0.3, 0.3, 0.3);
    } },
  { "turned inside out", 1.0, [](vtkTransform* t) { t->Scale(-1, -1, -1); } }, // for the symmetric
  { "mirrored", 1.0,
    [](vtkTransform* t)
    {
      t->RotateX(20);
      t->Scale(-1, 1, 1);
    } } };

/// Whether direction b is a, transformed: parallel to it, or to its opposite for an axis.
bool IsAlong(const glm::dvec3& a, const glm::dvec3& b, bool eitherWay, double rounding)
{
  const double cosine = glm::dot(glm::normalize(a), glm::normalize(b));
  const double sine = glm::length(glm::cross(glm::normalize(a), glm::normalize(b)));
  return sine <= rounding && (eitherWay || cosine > 0.0);
}

glm::dvec3 TransformedPoint(vtkTransform* transform, const glm::dvec3& p)
{
  const double* point = transform->TransformPoint(&p.x);
  return { point[0], point[1], point[2] };
}

/// The moved lamp's parts against the lamp's parts, moved by VTK's transform.
/// @param rounding Of a coordinate, relative to the largest; a sum over a glyph's thousand points
/// has about 32 of it, and a few more come from the transform.
void CheckMoved(const Luminaire& lamp, vtkPolyData* moved, const Place& place, double rounding,
  const std::string& what)
{
  vtkNew<vtkTransform> transform;
  place.setUp(transform);
  std::optional<Luminaire> found;
  try
  {
    found = ReadLuminaire(moved);
  }
  catch (const InputError& error)
  {
    EXPECT_TRUE(false) << what << ": " << error.what();
    return;
  }
  const Parts before = PartsOf(lamp.lamp);
  const Parts after = PartsOf(found->lamp);
  EXPECT_TRUE(found->name == lamp.name && found->lamp.index() == lamp.lamp.index())
    << what << ": its kind";
  constexpr double Sum = 64.0;
  const double size = 0.1 * place.scale; // at least, of each glyph
  double farthest = glm::length(TransformedPoint(transform, Position));
  for (std::size_t i = 0; i < before.points.size(); ++i)
  {
    const glm::dvec3 point = TransformedPoint(transform, before.points[i]);
    farthest = std::max(farthest, glm::length(point));
    // A rectangle's sides have no sign: the height's end of a mirror image is the opposite one.
    const glm::dvec3 opposite = 2.0 * after.points[0] - after.points[i];
    const double error =
      std::min(glm::distance(after.points[i], point), glm::distance(opposite, point));
    EXPECT_LE(error, Sum * rounding * farthest) << what << ": a point is off by " << error;
  }
  const double angle = Sum * rounding * farthest / size;
  for (std::size_t i = 0; i < before.directions.size(); ++i)
  {
    const double* expected = transform->TransformVector(&before.directions[i].x);
    EXPECT_TRUE(IsAlong({ expected[0], expected[1], expected[2] }, after.directions[i],
      std::holds_alternative<LineLamp>(lamp.lamp), angle))
      << what << ": direction " << i;
  }
  for (std::size_t i = 0; i < before.lengths.size(); ++i)
  {
    EXPECT_LE(std::fabs(after.lengths[i] / before.lengths[i] / place.scale - 1.0), angle)
      << what << ": length " << i << " is " << after.lengths[i];
  }
}

vtkSmartPointer<vtkPolyData> Appended(vtkPolyData* a, vtkPolyData* b)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(a);
  append->AddInputData(b);
  append->Update();
  return append->GetOutput();
}

template <typename Filter>
void CheckKept(const char* name)
{
  for (int type = 0; type < vtkLuminaireSource::NUMBER_OF_TYPES; ++type)
  {
    const auto source = PlacedSource(type);
    const Place& place = Places.back();
    vtkNew<Filter> filter;
    filter->SetInputData(source->GetOutput());
    filter->Update();
    const auto turn = [](vtkTransform* t) { t->RotateX(40); };
    CheckMoved(*ReadLuminaire(source->GetOutput()), Transformed(filter->GetOutput(), turn),
      { place.name, 1.0, turn }, 0x1p-52, name + (" of type " + std::to_string(type)));
  }
}

} // namespace

TEST(LuminairePlace, LampGoesWhereItsGlyphGoes)
{
  for (int type = 0; type < vtkLuminaireSource::NUMBER_OF_TYPES; ++type)
  {
    const auto source = PlacedSource(type);
    vtkPolyData* glyph = source->GetOutput();
    const Luminaire lamp = *ReadLuminaire(glyph);
    for (const Place& place : Places)
    {
      const bool mirrors = place.name[0] == 'm' && place.name[1] == 'i';
      const bool pointReflected = std::string(place.name) == "turned inside out";
      const std::string what = "type " + std::to_string(type) + " " + place.name;
      if (type == vtkLuminaireSource::PHOTOMETRIC_FILE && (mirrors || pointReflected))
      {
        ExpectRefused(Transformed(glyph, place.setUp), "it was mirrored, and its intensities");
        continue;
      }
      CheckMoved(lamp, Transformed(glyph, place.setUp), place, 0x1p-52, what);
      if (std::string(place.name) != "far away and turned")
      {
        CheckMoved(lamp, Transformed(glyph, place.setUp, vtkAlgorithm::SINGLE_PRECISION), place,
          0x1p-23, what + " in single precision");
      }
    }
  }
}

// A lamp that is turned back and forth is where it was; one that was not moved has the same bits.
TEST(LuminairePlace, ThereAndBackIsTheSamePlace)
{
  for (int type = 0; type < vtkLuminaireSource::NUMBER_OF_TYPES; ++type)
  {
    const std::string what = "type " + std::to_string(type);
    const auto source = PlacedSource(type);
    vtkPolyData* glyph = source->GetOutput();
    const Luminaire lamp = *ReadLuminaire(glyph);
    const auto same = ReadLuminaire(Transformed(glyph, [](vtkTransform*) {}));
    const Parts before = PartsOf(lamp.lamp);
    const Parts after = PartsOf(same->lamp);
    EXPECT_TRUE(before.points == after.points && before.directions == after.directions &&
      before.lengths == after.lengths)
      << what << " not moved: the same bits";

    const auto there = Transformed(glyph,
      [](vtkTransform* t)
      {
        t->Translate(1, 2, 3);
        t->RotateX(77);
        t->Scale(4, 4, 4);
      });
    const auto back = Transformed(there,
      [](vtkTransform* t)
      {
        t->Scale(0.25, 0.25, 0.25);
        t->RotateX(-77);
        t->Translate(-1, -2, -3);
      });
    CheckMoved(lamp, back, { "", 1.0, [](vtkTransform*) {} }, 0x1p-48, what + " there and back");
  }
}

// What a lamp with sides of its own sends where: against the solid, by directions.
TEST(LuminairePlace, MirroredSolidsShineMirrored)
{
  const auto mirror = [](vtkTransform* t) { t->Scale(1, -1, 1); };
  for (const char* file : { "lateral.ldt", "lambertian.ies", "isotropic.ies" })
  {
    const auto source = PlacedSource(vtkLuminaireSource::PHOTOMETRIC_FILE, file);
    const auto moved = Transformed(source->GetOutput(), mirror);
    const auto lamp = std::get<PhotometricLamp>(ReadLuminaire(source->GetOutput())->lamp);
    const auto image = std::get<PhotometricLamp>(ReadLuminaire(moved)->lamp);
    const auto towards = [](const PhotometricLamp& l, const glm::dvec3& d)
    {
      const auto axes = l.Axes();
      const double degrees = 45.0 / std::atan(1.0);
      return Intensity(l.solid, degrees * std::acos(glm::clamp(glm::dot(d, axes.aim), -1.0, 1.0)),
        degrees * std::atan2(glm::dot(d, axes.y), glm::dot(d, axes.x)));
    };
    for (int i = 0; i < 100; ++i)
    {
      const double z = -1.0 + 0.02 * (i + 0.5);
      const double r = std::sqrt(1.0 - z * z);
      const glm::dvec3 d(r * std::cos(2.4 * i), r * std::sin(2.4 * i), z);
      const double was = towards(lamp, d);
      const double is = towards(image, { d.x, -d.y, d.z });
      EXPECT_LE(std::fabs(was - is), 1e-6 * (1.0 + was))
        << file << " mirrored: " << is << " cd for " << was;
    }
  }
}

TEST(LuminairePlace, DistortedGlyphsAreRefused)
{
  for (int type = 0; type < vtkLuminaireSource::NUMBER_OF_TYPES; ++type)
  {
    const auto source = PlacedSource(type);
    vtkPolyData* glyph = source->GetOutput();
    if (type != vtkLuminaireSource::LINE) // of which only two points tell, and any two are a line
    {
      const char* const words = "scaled unevenly, sheared or bent";
      ExpectRefused(Transformed(glyph, [](vtkTransform* t) { t->Scale(1, 1, 1.2); }), words);
      ExpectRefused(Transformed(glyph, [](vtkTransform* t) { t->Scale(1.1, 1, 1.1); }), words);
      const double shear[16] = { 1, 0.3, 0.2, 0, 0, 1, 0.3, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
      ExpectRefused(Transformed(glyph, [&](vtkTransform* t) { t->SetMatrix(shear); }), words);
      // Nine digits of 1e8 are not enough for a lamp of less than a metre.
      ExpectRefused(
        Transformed(
          glyph, [](vtkTransform* t) { t->Translate(1e8, 0, 0); }, vtkAlgorithm::SINGLE_PRECISION),
        "rounded off");
    }
    ExpectRefused(Transformed(glyph, [](vtkTransform* t) { t->Scale(0, 0, 0); }), "to one place");
    ExpectRefused(
      Transformed(glyph, [](vtkTransform* t) { t->Translate(std::nan(""), 0, 0); }), "not finite");
    vtkNew<vtkPolyData> bare;
    bare->CopyStructure(glyph);
    bare->GetFieldData()->ShallowCopy(glyph->GetFieldData());
    ExpectRefused(bare, "lost the point array 'LuminairePoint'");
    bare->GetPointData()->ShallowCopy(glyph->GetPointData());
    bare->GetFieldData()->Initialize();
    ExpectRefused(bare, "lost the field data that describe it");
  }
}

TEST(LuminairePlace, AppendedLampsAreRefused)
{
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  for (int type = 0; type < vtkLuminaireSource::NUMBER_OF_TYPES; ++type)
  {
    const auto lamp = PlacedSource(type);
    const auto other = PlacedSource(type);
    other->SetDimming(0.5);
    other->Update();
    ExpectRefused(Appended(lamp->GetOutput(), other->GetOutput()), "Group Datasets");
    ExpectRefused(Appended(lamp->GetOutput(), lamp->GetOutput()), "Group Datasets");
    const auto moved =
      Transformed(lamp->GetOutput(), [](vtkTransform* t) { t->Translate(1, 0, 0); });
    ExpectRefused(Appended(lamp->GetOutput(), moved), "Group Datasets");
    ExpectRefused(Appended(lamp->GetOutput(), plane->GetOutput()), "Group Datasets");
    EXPECT_FALSE(ReadLuminaire(Appended(plane->GetOutput(), lamp->GetOutput())))
      << "a lamp that a surface swallowed is none";
  }
}

TEST(LuminairePlace, FiltersThatKeepTheGlyphKeepTheLamp)
{
  CheckKept<vtkCleanPolyData>("vtkCleanPolyData");
  CheckKept<vtkTriangleFilter>("vtkTriangleFilter");
  CheckKept<vtkPolyDataNormals>("vtkPolyDataNormals");
  CheckKept<vtkReverseSense>("vtkReverseSense");

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(Position.x + 0.01, Position.y, Position.z);
  plane->SetNormal(1.0, 0.0, 0.0);
  for (const int type : { vtkLuminaireSource::RECTANGLE, vtkLuminaireSource::SPHERE,
         vtkLuminaireSource::SPOT, vtkLuminaireSource::LINE, vtkLuminaireSource::PHOTOMETRIC_FILE })
  {
    const auto source = PlacedSource(type);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(source->GetOutput());
    clip->SetClipFunction(plane);
    clip->Update();
    ExpectRefused(clip->GetOutput(), "parts of its geometry were cut away");
  }
}
