// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPhotometricReader
 * @brief   reads photometric files (IES LM-63, EULUMDAT) and draws their photometric solids
 *
 * Reads the luminous intensities of a luminaire: IESNA LM-63 of 1986 to 2019 (.ies) of photometry
 * types C, B and A, or EULUMDAT (.ldt, .eul). The output is the photometric solid, a closed surface
 * about the origin, whose distance from the origin is in proportion to the intensity. The luminaire
 * aims along -z. For type C azimuth 0 is +x and azimuth 90 degrees is +y; for types A and B right
 * is +x and up is +y. Directions beyond the file's angles are dark.
 *
 * Intensities are the file's with all factors that it names. Of the factors of TILT the one at 0
 * degrees counts, for a luminaire that is not tilted.
 *
 * Point array: LuminousIntensity (cd).
 *
 * Field data:
 *  - LuminaireFlux (lm): what the luminaire emits, the integral over the solid.
 *  - RatedFlux (lm): that of all its bare lamps; 0 for absolute photometry.
 *  - InputPower (W): 0 if the file does not say.
 *  - Efficacy (lm/W): LuminaireFlux / InputPower, where the power is known.
 *  - Description: manufacturer, name and number as far as given.
 *  - PhotometricType: C, B or A.
 *  - Notes: what was assumed where the file deviates from its standard, and what is odd in it, one
 *    text each; none for most files.
 *
 * The reader is strict where light depends on it (counts, angles, intensities, units, factors) and
 * lenient elsewhere: UTF-8, UTF-16 and Latin-1, any line ends, text after the last intensity,
 * decimal commas, spellings of the format line, lamp sets of EULUMDAT in either order.
 *
 * The output is a luminaire too, for the second input of vtkIlluminationMap: at the origin, aiming
 * along -z, with the file's flux, and named as the file is without its extension. It has the field
 * arrays of vtkLuminaireSource as well, and moves with its points as the output of that source
 * does. Size does not change its light.
 *
 * A file that can't be read gives one error with its name, the line, the value and what should be
 * there, and an output with nothing but that error, as field data LuminaireError.
 */

#ifndef vtkPhotometricReader_h
#define vtkPhotometricReader_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the file name

class VTKILLUMINATION_EXPORT vtkPhotometricReader : public vtkPolyDataAlgorithm
{
public:
  static vtkPhotometricReader* New();
  vtkTypeMacro(vtkPhotometricReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read, .ies, .ldt or .eul. Default: empty.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  ///@{
  /**
   * Distance of the largest intensity from the origin, in the data's length unit, finite and above
   * 0. Default: 1.
   */
  vtkSetMacro(Size, double);
  vtkGetMacro(Size, double);
  ///@}

  /**
   * 1 for a file that can be opened and has the extension of a photometric file, else 0. The
   * content is not looked at.
   */
  int CanReadFile(VTK_FILEPATH const char* name);

protected:
  vtkPhotometricReader();
  ~vtkPhotometricReader() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  void Read(vtkPolyData* surface);

  std::string FileName;
  double Size = 1.0;

private:
  vtkPhotometricReader(const vtkPhotometricReader&) = delete;
  void operator=(const vtkPhotometricReader&) = delete;
};

#endif
