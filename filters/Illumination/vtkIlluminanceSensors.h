// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminanceSensors
 * @brief   illuminances at points that are no part of the scene, such as a work plane
 *
 * Measures the light at points in a scene that vtkIlluminationMap has lit. The points are a grid
 * over a box or over horizontal polygons, with the spacing of EN 12464-1, or those of any data set.
 * They stop no light.
 *
 * Inputs:
 *  - 0: the output of vtkIlluminationMap, made by either method, or what other filters have made
 *    of it. Its field array IlluminationMapSettings tells how surface and light are to be
 *    understood, so that nothing has to be set again.
 *  - 1: the luminaires whose light is measured: as a rule those of the map. If there are none, it
 * is the map's own lamp.
 *  - 2: with POLYGONS the polygons, with POINTS the points: any vtkDataSet, or a composite one.
 *
 * The light is found anew, as by vtkIlluminationMap with FINAL_GATHERING: photons find it on cells
 * that are as fine as it varies, and then each sensor gathers it from all directions, and straight
 * from the lamps by rays to them. The map's own values are not read: they lie at the points of its
 * mesh, and a wall may have four.
 *
 * The output is the grid, a vtkPolyData, or the input 2 with these point arrays (double but Valid):
 *  - Illuminance (lx): of a surface across the sensor's normal. Without normals that is up.
 *  - HorizontalIlluminance (lx): of a surface that faces up.
 *  - VerticalIlluminance (lx, 4 components): of surfaces that face four horizontal views.
 *  - CylindricalIlluminance (lx): the mean over all vertical surfaces.
 *  - SemicylindricalIlluminance (lx, 4): of half cylinders that face the views.
 *  - HemisphericalIlluminance, SphericalIlluminance (lx): means over half a ball and a ball.
 *  - DaylightFactor (%), if all luminaires are overcast or uniform skies: HorizontalIlluminance
 * over that of open level ground.
 *  - UGR (4): unified glare rating of CIE 117:1995 by luminaires that have an area, for an eye that
 *    looks along each view; within [0, 100], 0 if it sees none.
 *  - StandardError, StandardErrorHorizontal and so on, for each of them: noise of rays and photons.
 *  - Valid: 0 for points inside solid bodies and outside of rooms, where most rays meet the backs
 * of facets; all else is 0 there.
 *  - SensorArea (m^2), of a grid: the area that each sensor stands for.
 *
 * The field array Notes (text) says what was assumed and what is missing. Light that mirrors, gloss
 * or glass have sent straight from a lamp to a sensor is not seen; Notes says how much such light
 * there is, and a warning if it is much. The result has the same bits for any NumberOfThreads. Bad
 * input gives one error, and the output has no such arrays.
 *
 * Under MPI all ranks measure together: points stay on the ranks that have them, and a grid is on
 * the first rank.
 */

#ifndef vtkIlluminanceSensors_h
#define vtkIlluminanceSensors_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <cstdint> // for the number of a rank
#include <vector>  // for readings

namespace Illumination
{
class ControllerRanks;
struct SensorInput;
struct SensorScene;
}

namespace PhotonTransport
{
struct SensorDirections;
struct SensorReading;
}

class vtkIlluminationMap;

class VTKILLUMINATION_EXPORT vtkIlluminanceSensors : public vtkPolyDataAlgorithm
{
public:
  static vtkIlluminanceSensors* New();
  vtkTypeMacro(vtkIlluminanceSensors, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Layouts
  {
    BOX = 0,      ///< A grid over the bottom of GridBounds.
    POLYGONS = 1, ///< A grid over the horizontal polygons of input 2.
    POINTS = 2    ///< The points of input 2.
  };

  ///@{
  /**
   * Where the sensors are, see Layouts. Default: BOX.
   */
  vtkSetClampMacro(Layout, int, BOX, POINTS);
  vtkGetMacro(Layout, int);
  ///@}

  ///@{
  /**
   * Box over whose bottom the grid lies: least and largest x, y and z in the data's unit of length.
   * All 0: the box around the surface. Default: 0.
   */
  vtkSetVector6Macro(GridBounds, double);
  vtkGetVector6Macro(GridBounds, double);
  ///@}

  ///@{
  /**
   * Height of the grid above the box's bottom or the polygons, metres, finite. Default: 0.75.
   */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Width of the zone along the outline that has no sensors, metres, >= 0. Default: 0.5.
   */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * Spacing of the grid, metres, >= 0, about: the area is divided evenly. 0 is that of EN 12464-1,
   * 0.2 * 5^lg(d) and at most 10 m, where d is the longer side of the area within the margin, or
   * the shorter one if the longer is twice as long or more. Default: 0.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * The direction that is up, any length but 0. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Direction of the first of the four views, degrees, counter-clockwise from +x (from +y if up is
   * along x) as seen from above. The others follow by right angles. Default: 0.
   */
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /**
   * Photons that find the light on the surface, 1 to 10^10. Default: 500000.
   */
  vtkSetMacro(Photons, vtkIdType);
  vtkGetMacro(Photons, vtkIdType);
  ///@}

  ///@{
  /**
   * Rays that gather light for each sensor, about, 16 to 16384. Default: 1024.
   */
  vtkSetMacro(GatherRays, int);
  vtkGetMacro(GatherRays, int);
  ///@}

  ///@{
  /**
   * Another one gives independent noise. Default: 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Threads to work with, 0 to 1024; 0 means all cores. The result does not depend on it. Default:
   * 0.
   */
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Inputs 1 and 2.
   */
  void AddLuminaireConnection(vtkAlgorithmOutput* luminaire);
  void RemoveAllLuminaires();
  void SetSensorsConnection(vtkAlgorithmOutput* sensors);
  ///@}

protected:
  vtkIlluminanceSensors();
  ~vtkIlluminanceSensors() override = default;

  int ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int Layout = BOX;
  double GridBounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  double Height = 0.75;
  double Margin = 0.5;
  double Spacing = 0.0;
  double Up[3] = { 0.0, 0.0, 1.0 };
  double Azimuth = 0.0;
  vtkIdType Photons = 500000;
  int GatherRays = 1024;
  int Seed = 1;
  int NumberOfThreads = 0;

private:
  vtkIlluminanceSensors(const vtkIlluminanceSensors&) = delete;
  void operator=(const vtkIlluminanceSensors&) = delete;

  void ExecuteOnRanks(
    Illumination::ControllerRanks& ranks, vtkInformationVector** inputs, vtkDataObject* output);
  void Execute(
    Illumination::ControllerRanks& ranks, vtkInformationVector** inputs, vtkDataObject* output);
  /// Makes the sensors of a grid.
  void Place(std::uint64_t rank, vtkInformationVector** inputs,
    const PhotonTransport::SensorDirections& directions, double metresPerUnit,
    vtkDataObject* output);
  /// @return False if the user has stopped it.
  bool Measure(Illumination::SensorScene& scene, const Illumination::SensorInput& input,
    const PhotonTransport::SensorDirections& directions,
    std::vector<PhotonTransport::SensorReading>& readings);
  void RequireRanges();
};

#endif
