// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminatedAppearance
 * @brief   shows a lit surface as it looks: its luminance, and colours for the display
 *
 * The input is the output of vtkIlluminationMap or vtkIlluminationMapSmoothing, one vtkPolyData or
 * a composite data set. A diffuse surface has the luminance L = (reflectance × illuminance +
 * exitance) / pi, by colour: light that arrives has the colour of IlluminanceRGB, where there is
 * one. Cells with DiffuseTransmittance also pass on light of their backs, where there is
 * IlluminanceBack. Mirrors, gloss and glass show only what they reflect diffusely.
 *
 * Display colours come from it by these steps:
 *  - White balance: light of one colour looks white.
 *  - Exposure: the adaptation luminance is shown as mid grey, 18 % of the display's white.
 *  - Highlight compression: bright places keep differences up to the white luminance.
 *  - The transfer function of sRGB (IEC 61966-2-1), in which displays expect 8 bits.
 *
 * The output is the input with these point arrays:
 *  - Luminance (cd/m²), 0 at points that no polygon uses.
 *  - LuminanceRGB (cd/m²), where light or surface have a colour: three components, equal for white;
 *    0.2126 R + 0.7152 G + 0.0722 B is Luminance.
 *  - DisplayColours: red, green and blue, 8 bits, to be shown unlit; the active scalars.
 *  - OriginalPointIds, if points were copied: see below.
 *
 * The colour of a cell ends at its edges. So points that cells of different reflectance or exitance
 * share are copied, and the copies follow the input's points. Polygons and strips that wind against
 * their point normals are turned round: the lit side is then the front of each, and a room is seen
 * from inside if back faces are culled.
 *
 * Field data say what served: AdaptationLuminance and WhiteLuminance (cd/m²), WhiteColour (linear
 * red, green, blue) and AppearanceNotes, in words.
 *
 * Bad input gives one error that names the array, the cell or point and the value, and the input
 * passes through.
 */

#ifndef vtkIlluminatedAppearance_h
#define vtkIlluminatedAppearance_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for array names

namespace Illumination
{
struct LookDescription;
}

class VTKILLUMINATION_EXPORT vtkIlluminatedAppearance : public vtkSurfaceAlgorithm
{
public:
  static vtkIlluminatedAppearance* New();
  vtkTypeMacro(vtkIlluminatedAppearance, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the point array of the light that arrives: lx, one component, finite, >= 0, or three
   * for red, green and blue. One component gets the colour of IlluminanceRGB. "Automatic" takes
   * IlluminanceSmoothed where there is one, or else Illuminance. Default: Automatic.
   */
  vtkSetStdStringFromCharMacro(IlluminanceArray);
  vtkGetCharFromStdStringMacro(IlluminanceArray);
  ///@}

  ///@{
  /**
   * Name of the cell array of diffuse reflectances, [0, 1], one component or three. "Automatic"
   * takes what the illumination map was made with, as its field data say, or else
   * DiffuseReflectance where there is one. "None" takes Reflectance for all cells. Default:
   * Automatic.
   */
  vtkSetStdStringFromCharMacro(ReflectanceArray);
  vtkGetCharFromStdStringMacro(ReflectanceArray);
  ///@}

  ///@{
  /**
   * Diffuse reflectance where neither an array nor the illumination map says it, [0, 1]. Default:
   * 0.5.
   */
  vtkSetMacro(Reflectance, double);
  vtkGetMacro(Reflectance, double);
  ///@}

  ///@{
  /**
   * Name of the cell array of what cells shine with themselves: lm/m², one component or three, >=
   * 0. "Automatic" takes the array of the illumination map's own emitting facets, or else Exitance
   * where there is one. "None": no cell shines. Default: Automatic.
   */
  vtkSetStdStringFromCharMacro(ExitanceArray);
  vtkGetCharFromStdStringMacro(ExitanceArray);
  ///@}

  ///@{
  /**
   * Luminance that is shown as mid grey, cd/m², >= 0. 0 takes the mean of the logarithm of the
   * luminance by area, without cells that shine themselves. Give a number to compare surfaces.
   * Default: 0.
   */
  vtkSetMacro(AdaptationLuminance, double);
  vtkGetMacro(AdaptationLuminance, double);
  ///@}

  ///@{
  /**
   * Brighter or darker than that, in stops: each doubles what is shown. [-20, 20]. Default: 0.
   */
  vtkSetMacro(ExposureCompensation, double);
  vtkGetMacro(ExposureCompensation, double);
  ///@}

  ///@{
  /**
   * How much of the display's range is for compressed highlights, [0, 1]. 0: what is brighter than
   * the display's white is cut off. 1: all is compressed (Reinhard et al. 2002, equation 4).
   * Between them, what is shown darker than 1 - HighlightCompression keeps its ratios. Default: 1.
   */
  vtkSetMacro(HighlightCompression, double);
  vtkGetMacro(HighlightCompression, double);
  ///@}

  ///@{
  /**
   * Luminance that compressed highlights show as white, cd/m², >= 0. 0 takes the brightest point
   * that does not shine itself. Default: 0.
   */
  vtkSetMacro(WhiteLuminance, double);
  vtkGetMacro(WhiteLuminance, double);
  ///@}

  enum WhiteBalances
  {
    NO_BALANCE = 0, ///< Colours as they are: equal red, green and blue look white.
    AUTOMATIC = 1,  ///< The mean of the arriving light looks white.
    BY_COLOUR = 2   ///< Light of WhiteColour looks white.
  };

  ///@{
  /**
   * Which light looks white, see WhiteBalances. Default: NO_BALANCE.
   */
  vtkSetClampMacro(WhiteBalance, int, NO_BALANCE, BY_COLOUR);
  vtkGetMacro(WhiteBalance, int);
  ///@}

  ///@{
  /**
   * Colour of light that looks white with BY_COLOUR: linear red, green and blue, >= 0, any scale,
   * not all 0. Default: 1 1 1.
   */
  vtkSetVector3Macro(WhiteColour, double);
  vtkGetVector3Macro(WhiteColour, double);
  ///@}

protected:
  vtkIlluminatedAppearance() = default;
  ~vtkIlluminatedAppearance() override = default;

  void Execute(
    vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  /// Points are split where cells look different, so each rank keeps its own.
  RankWork WorkOnRanks() const override { return RankWork::OwnParts; }

  std::string IlluminanceArray = "Automatic";
  std::string ReflectanceArray = "Automatic";
  double Reflectance = 0.5;
  std::string ExitanceArray = "Automatic";
  double AdaptationLuminance = 0.0;
  double ExposureCompensation = 0.0;
  double HighlightCompression = 1.0;
  double WhiteLuminance = 0.0;
  int WhiteBalance = NO_BALANCE;
  double WhiteColour[3] = { 1.0, 1.0, 1.0 };

private:
  /// What cells do with light, by the properties and the map's own settings.
  Illumination::LookDescription DescribeLooks(vtkDataObject* data);

  vtkIlluminatedAppearance(const vtkIlluminatedAppearance&) = delete;
  void operator=(const vtkIlluminatedAppearance&) = delete;
};

#endif
