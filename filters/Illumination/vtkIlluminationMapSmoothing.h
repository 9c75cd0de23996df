// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminationMapSmoothing
 * @brief   removes photon noise from an illumination map without blurring its shadows
 *
 * The filtration of B. Barladian, "Indirect illumination on curve surfaces". By default each point
 * gets a smoothing width of its own: the one with the least expected error, noise and blur
 * together. That error is estimated from the differences between independent estimates of the map.
 * Light spreads along the surface as heat would, but never across creases, rims and non-manifold
 * edges, nor into regions that light certainly does not reach. The flux (sum of illuminance times
 * area) of every smooth patch is conserved, and no value falls below 0.
 *
 * The input is the output of vtkIlluminationMap, one vtkPolyData or a composite data set. With
 * GroupMeans on there, direct and indirect light are smoothed each by its own noise, which is best:
 * what is read then is IlluminanceDirect, IlluminanceIndirect and their Groups arrays. Without
 * group means the whole map is smoothed, by its StandardError; without that array, by its
 * roughness, which takes fine detail for noise. The field array SmoothingNotes says which it was.
 * Of the map Illuminance, the point array PhotonHits tells which regions are certainly dark.
 *
 * Facets without area and ghost cells are not part of the surface, as in vtkIlluminationMap, and
 * duplicate points get the values of their owners.
 *
 * The output is the input, untouched, with these point arrays:
 *  - IlluminanceSmoothed (lx), and with group means IlluminanceDirectSmoothed and
 *    IlluminanceIndirectSmoothed (lx), which add up to it. For another IlluminanceArray the names
 *    begin with its name.
 *  - StandardErrorSmoothed (lx): expected error of IlluminanceSmoothed, remaining noise and blur.
 *  - SmoothingScale: standard deviation of the kernel at the point, in distances between points; 0
 *    where the map is as it was. With group means it has two components, direct and indirect.
 *
 * The result has the same bits for any NumberOfThreads. Bad input gives one error that names the
 * array, the point and the value, and the input passes through without the arrays.
 */

#ifndef vtkIlluminationMapSmoothing_h
#define vtkIlluminationMapSmoothing_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for array names

class VTKILLUMINATION_EXPORT vtkIlluminationMapSmoothing : public vtkSurfaceAlgorithm
{
public:
  static vtkIlluminationMapSmoothing* New();
  vtkTypeMacro(vtkIlluminationMapSmoothing, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    NONE = 0,      ///< The map as it is.
    DIFFUSION = 1, ///< One width everywhere, which blurs shadows; to compare with.
    ADAPTIVE = 2   ///< A width for each point, as its noise asks for.
  };

  ///@{
  /**
   * How to smooth, see Methods. Default: ADAPTIVE.
   */
  vtkSetClampMacro(Method, int, NONE, ADAPTIVE);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Name of the point array to smooth: one component, lx, finite, >= 0. With group means the arrays
   * are read whose names are this one with Direct, Indirect, DirectGroups and IndirectGroups added.
   * Default: Illuminance.
   */
  vtkSetStdStringFromCharMacro(IlluminanceArray);
  vtkGetCharFromStdStringMacro(IlluminanceArray);
  ///@}

  ///@{
  /**
   * Name of the point array with the standard error of the map, lx, >= 0, for input without group
   * means. If the input has no such array, or this is empty or "None", the map is smoothed by its
   * roughness. Default: StandardError.
   */
  vtkSetStdStringFromCharMacro(StandardErrorArray);
  vtkGetCharFromStdStringMacro(StandardErrorArray);
  ///@}

  ///@{
  /**
   * How much noise counts against blur for ADAPTIVE, [0, 10]: 1 is the estimated optimum, 0 keeps
   * the map, and a larger number smooths more. Default: 1.
   */
  vtkSetMacro(Strength, double);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /**
   * Standard deviation of DIFFUSION's kernel, in distances between points, [0, 50]. Default: 4.
   */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /**
   * Facets that meet at a greater angle than this, degrees, [0, 180], meet at a crease, which
   * light does not cross. Default: 40.
   */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Threads to smooth with, 0 to 1024; 0 means all cores. The result does not depend on it.
   * Default: 0.
   */
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

protected:
  vtkIlluminationMapSmoothing() = default;
  ~vtkIlluminationMapSmoothing() override = default;

  void Execute(
    vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int Method = ADAPTIVE;
  std::string IlluminanceArray = "Illuminance";
  std::string StandardErrorArray = "StandardError";
  double Strength = 1.0;
  double Width = 4.0;
  double FeatureAngle = 40.0;
  int NumberOfThreads = 0;

private:
  vtkIlluminationMapSmoothing(const vtkIlluminationMapSmoothing&) = delete;
  void operator=(const vtkIlluminationMapSmoothing&) = delete;
};

#endif
