// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLuminaireSource
 * @brief   a lamp, the sun or a sky to light a scene with
 *
 * The output shows the lamp, in the data's length unit, and carries its description as field data,
 * for filters that light scenes: LuminaireType and LuminaireName (text), LuminaireColour,
 * LuminaireDimming (a factor on all that follows), and, where the type has them, LuminairePosition,
 * LuminaireDirection, LuminaireSize, LuminousFlux (lm), LuminaireIlluminance (lx), SpotHalfAngle
 * (degrees), SpotExponent, SkyUp, SkyType, SkyLuminance (cd/m^2), SkyIsWholeSphere, SunDirection
 * (from the ground to the sun), LuminaireRotation (degrees), and the photometric solid:
 * PhotometricType (C, B or A), PhotometricPolar and PhotometricAzimuth (degrees),
 * PhotometricCandela (cd, polar angles of the first azimuth first), PhotometricScale (a factor on
 * them, 1), PhotometricRatedFlux (lm), PhotometricInputPower (W), PhotometricOpening (width,
 * length, height, m), PhotometricDescription, PhotometricNotes (what the reader of the file
 * assumed).
 *
 * The lamp's place, axes and size travel with the output's points. The point array LuminairePoint
 * (where each point was made, and a number that tells the lamp from others) and the field array
 * LuminaireGlyph (that number, area and length of what is drawn) say how filters have moved them.
 * The lamp may be turned, moved, scaled evenly, and mirrored, unless it is a photometric file whose
 * intensities are symmetric neither left and right nor fore and aft. An even scale changes the size
 * of panels, balls and lines. It changes no flux, no illuminance of the sun or a sky, and no
 * intensity. vtkIlluminationMap refuses a lamp that was scaled unevenly, sheared, bent or rounded
 * by more than 0.1 % of its extent, lost these arrays, was cut, or was appended to another lamp. A
 * composite data set may hold several lamps.
 *
 * Panels, balls and lines are shown in their own size, panels with a line to the side to which they
 * shine. Other lamps are shown in GlyphSize: parallel light and a Lambertian point as an arrow, a
 * point as a ball, a spot as an open cone with its axis, a sky as a dome, and a photometric file as
 * its polar diagram. The dome of a CIE sky has the point array Luminance (cd/m^2, after Dimming),
 * the polar diagram the point array LuminousIntensity (cd, before Dimming). A property that the
 * type uses and that is out of its range gives one error that names it and its value, and an output
 * with nothing but that error, as field data LuminaireError.
 */

#ifndef vtkLuminaireSource_h
#define vtkLuminaireSource_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for names

namespace Illumination
{
struct LuminaireGlyph;
}

namespace PhotonTransport
{
struct Luminaire;
}

class VTKILLUMINATION_EXPORT vtkLuminaireSource : public vtkPolyDataAlgorithm
{
public:
  static vtkLuminaireSource* New();
  vtkTypeMacro(vtkLuminaireSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Types
  {
    PARALLEL = 0,         ///< Light from infinitely far away, as the sun's.
    POINT = 1,            ///< The same intensity in all directions.
    LAMBERTIAN_POINT = 2, ///< A small flat lamp: intensity falls as the cosine.
    SPOT = 3,             ///< A cone of light from a point.
    RECTANGLE = 4,        ///< A Lambertian panel that shines to one side and stops no light.
    DISK = 5,             ///< As RECTANGLE, round.
    SPHERE = 6,           ///< A ball of uniform luminance that stops no light.
    LINE = 7,             ///< A thin diffuse tube: intensity as the sine of the angle to its axis.
    UNIFORM_SKY = 8,      ///< The same luminance from everywhere above the horizon.
    CIE_SKY = 9, ///< The sky of SkyType in ISO 15469:2004 / CIE S 011:2003, without the sun.
    PHOTOMETRIC_FILE = 10, ///< A point with the intensities of FileName.
    NUMBER_OF_TYPES        ///< No type.
  };

  ///@{
  /**
   * Kind of lamp, see Types. Default: PARALLEL.
   */
  vtkSetClampMacro(Type, int, PARALLEL, NUMBER_OF_TYPES - 1);
  vtkGetMacro(Type, int);
  ///@}

  ///@{
  /**
   * Name of the lamp, in messages and in the point array Illuminance_<name>. Default: empty.
   */
  vtkSetStdStringFromCharMacro(LuminaireName);
  vtkGetCharFromStdStringMacro(LuminaireName);
  ///@}

  ///@{
  /**
   * Where the lamp or its centre is, or where the glyph of parallel light or of a sky is drawn; in
   * the data's length unit, finite. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * The direction in which the light travels: that of parallel light, the axis of a Lambertian
   * point or a spot, the side to which a panel shines, the aim of a photometric file's lamp. For a
   * line it is the line's axis. Finite, any length but zero. Default: (0, 0, -1).
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * Width and height of a rectangle; or the radius of a disk or ball or the length of a line (the
   * second number is not used then); in the data's length unit, [0, 1e30]. With size 0 all light
   * comes from one point, and from a rectangle with one side of 0 from a line. The width runs along
   * z x Direction (along x for a panel that shines straight up or down). Default: (1, 1).
   */
  vtkSetVector2Macro(Size, double);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Degrees by which the lamp of a photometric file is turned about its aim before it is aimed,
   * from +x towards +y for one that aims along -z; finite. Default: 0.
   */
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /**
   * Angle between a spot's axis and its edge, degrees, (0, 180]; at most 90 with a SpotExponent
   * above 0. Default: 30.
   */
  vtkSetMacro(SpotHalfAngle, double);
  vtkGetMacro(SpotHalfAngle, double);
  ///@}

  ///@{
  /**
   * How a spot's intensity falls off from its axis: as cos^n(theta), n >= 0. Default: 0, even.
   */
  vtkSetMacro(SpotExponent, double);
  vtkGetMacro(SpotExponent, double);
  ///@}

  ///@{
  /**
   * Luminous flux, lm, >= 0. Parallel light, skies and photometric files do not use it. Default:
   * 1000.
   */
  vtkSetMacro(LuminousFlux, double);
  vtkGetMacro(LuminousFlux, double);
  ///@}

  ///@{
  /**
   * Illuminance that parallel light gives a surface perpendicular to it, or a sky an unshaded
   * horizontal one, lx, >= 0. Default: 1000.
   */
  vtkSetMacro(Illuminance, double);
  vtkGetMacro(Illuminance, double);
  ///@}

  ///@{
  /**
   * Type of a CIE_SKY, 1 to 15 as ISO 15469 numbers them, or 16, the traditional overcast sky.
   * Default: 1, the CIE standard overcast sky.
   */
  vtkSetMacro(SkyType, int);
  vtkGetMacro(SkyType, int);
  ///@}

  ///@{
  /**
   * Where the sun of a CIE_SKY stands, degrees: the altitude above the horizon, (0, 90], and the
   * azimuth clockwise from north, finite. North is +y, east is +x, the zenith is +z. Default: 45
   * and 180, in the south.
   */
  vtkSetMacro(SunAltitude, double);
  vtkGetMacro(SunAltitude, double);
  vtkSetMacro(SunAzimuth, double);
  vtkGetMacro(SunAzimuth, double);
  ///@}

  ///@{
  /**
   * Photometric file of PHOTOMETRIC_FILE: IESNA LM-63 (.ies) or EULUMDAT (.ldt, .eul). Default:
   * empty.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  ///@{
  /**
   * Factor on LuminousFlux, Illuminance and the intensities of a photometric file, >= 0; no unit.
   * Where vtkIlluminationMap keeps lamps apart (LampContributions), another factor changes its map
   * without tracing; also from 0, since the lamp is traced as if undimmed. Default: 1.
   */
  vtkSetMacro(Dimming, double);
  vtkGetMacro(Dimming, double);
  ///@}

  ///@{
  /**
   * Colour of the light, linear RGB (ITU-R BT.709), finite, >= 0, and at least one of the three
   * above 0. Only their ratios count. Default: (1, 1, 1).
   */
  vtkSetVector3Macro(LightColour, double);
  vtkGetVector3Macro(LightColour, double);
  ///@}

  ///@{
  /**
   * How large lamps are drawn that have no size of their own, or size 0, in the data's length unit,
   * [1e-30, 1e30]: length of an arrow, edge of a cone, diameter of a point's ball, radius of a
   * dome, largest radius of a polar diagram. Default: 0.1.
   */
  vtkSetMacro(GlyphSize, double);
  vtkGetMacro(GlyphSize, double);
  ///@}

protected:
  vtkLuminaireSource();
  ~vtkLuminaireSource() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int Type = PARALLEL;
  std::string LuminaireName;
  double Position[3] = { 0.0, 0.0, 1.0 };
  double Direction[3] = { 0.0, 0.0, -1.0 };
  double Size[2] = { 1.0, 1.0 };
  double Rotation = 0.0;
  double SpotHalfAngle = 30.0;
  double SpotExponent = 0.0;
  double LuminousFlux = 1000.0;
  double Illuminance = 1000.0;
  int SkyType = 1;
  double SunAltitude = 45.0;
  double SunAzimuth = 180.0;
  std::string FileName;
  double Dimming = 1.0;
  double LightColour[3] = { 1.0, 1.0, 1.0 };
  double GlyphSize = 0.1;

private:
  vtkLuminaireSource(const vtkLuminaireSource&) = delete;
  void operator=(const vtkLuminaireSource&) = delete;

  // What the properties describe; each throws for values that the type of lamp uses and that are
  // out of range, and for a file that can't be read.
  PhotonTransport::Luminaire MakeLuminaire();
  Illumination::LuminaireGlyph MakeGlyph();
};

#endif
