// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminanceStatistics
 * @brief   a table of means, extremes and uniformity of an illumination map, by block or part
 *
 * The input is a surface with an illumination map, a set of points with illuminances such as a grid
 * of sensors, or a composite data set of these. The output is a table with a row for each block, or
 * for each part of the surfaces that a cell array names, over all blocks. The map is taken as
 * linear between the points of a triangle, and all integrals over it are exact.
 *
 * Columns (Unit: lx or fc):
 *  - Name: of the block or part; "All" for a single data set. Unit: "lx" or "fc".
 *  - Points: how many count, those that are corners of triangles with an area or, where there are
 *    no polygons, all. Area (m^2); 0 where there are no polygons. Of a grid of
 * vtkIlluminanceSensors (point array SensorArea) all points count, each with the area that it
 * stands for, and not the polygons between them. So Mean is that of the points, as EN 12464-1 has
 * it.
 *  - Mean (Unit): weighted by area; over the points where there are no polygons.
 *  - MeanOfPoints (Unit): over the points, as of a measured grid.
 *  - Minimum, Maximum (Unit): freed of the bias that noise gives them. One half of the samples
 * finds the point, the other half tells its value. Halves are pairs of the group means or, without
 *    these, the map with noise of its standard error added and the same noise subtracted. Without
 *    either, noise is not known, and they are those of the values.
 *  - U0 = Minimum / Mean and Ud = Minimum / Maximum; 0 in the dark.
 *  - ShareAtTarget: of the area, or of the points, where the map is at or above Target; [0, 1].
 *  - Flux (lm), on the surface. MeanLuminance (cd/m^2): the mean of reflectance E / pi, for white
 *    light. Both are 0 where there are no polygons.
 *  - Each of these but the first four has an error column, such as MeanError, if the noise is
 * known.
 *
 * Errors are standard errors. With group means (GroupMeans of vtkIlluminationMap), those of means,
 * flux and share follow from the differences between the groups, and count that noise is correlated
 * between points. With StandardErrorArray alone they are the largest that they can be, as if the
 * noise of all points went together. Minimum and Maximum have the standard error at their point and
 * half the distance to the plain extreme, since the two bracket the true one.
 *
 * Duplicate, refined and hidden cells and points (vtkGhostType) do not count, nor do points whose
 * ValidArray is 0, or triangles that have such a corner. Under MPI, rank 0 summarises the data of
 * all ranks and has the table; a block that is spread over ranks has one row, and its pieces become
 * one surface before, so that a point on a border between them counts once.
 *
 * The field array Notes tells where errors come from and what was left out. Bad input gives one
 * error that names the array, the cell or point and the value, and an empty table.
 */

#ifndef vtkIlluminanceStatistics_h
#define vtkIlluminanceStatistics_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkTableAlgorithm.h"

#include <string> // for array names

class VTKILLUMINATION_EXPORT vtkIlluminanceStatistics : public vtkTableAlgorithm
{
public:
  static vtkIlluminanceStatistics* New();
  vtkTypeMacro(vtkIlluminanceStatistics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Units
  {
    LUX = 0,
    FOOT_CANDLES = 1 ///< 1 fc = 10.7639 lx.
  };

  ///@{
  /**
   * Name of the point array to summarise: one component, lx, finite, >= 0. Group means are the
   * arrays of this name with Groups, or with DirectGroups and IndirectGroups, added. Default:
   * Illuminance.
   */
  vtkSetStdStringFromCharMacro(IlluminanceArray);
  vtkGetCharFromStdStringMacro(IlluminanceArray);
  ///@}

  ///@{
  /**
   * Name of the point array with the standard error of that array, lx, >= 0. If it is empty or
   * "None", or a block has no such array, errors are told by group means or not at all. Default:
   * StandardError.
   */
  vtkSetStdStringFromCharMacro(StandardErrorArray);
  vtkGetCharFromStdStringMacro(StandardErrorArray);
  ///@}

  ///@{
  /**
   * Name of a cell array of one number or text a cell: cells with the same value, in whichever
   * block, are one part of the surface, and have a row. At most 10000 values. Empty or "None": a
   * row for each block. Blocks without polygons are rows of their own. Default: empty.
   */
  vtkSetStdStringFromCharMacro(PartArray);
  vtkGetCharFromStdStringMacro(PartArray);
  ///@}

  ///@{
  /**
   * Name of a point array of one number a point: where it is 0, the point does not count, such as a
   * sensor inside a solid. Blocks without it have valid points only. Default: Valid.
   */
  vtkSetStdStringFromCharMacro(ValidArray);
  vtkGetCharFromStdStringMacro(ValidArray);
  ///@}

  ///@{
  /**
   * Illuminance for ShareAtTarget, in Unit, >= 0; the map with MaintenanceFactor is compared with
   * it. Default: 500.
   */
  vtkSetMacro(Target, double);
  vtkGetMacro(Target, double);
  ///@}

  ///@{
  /**
   * By which all light is multiplied, (0, 1]: what is left of it when lamps have aged and surfaces
   * become dirty. Default: 1, as new.
   */
  vtkSetMacro(MaintenanceFactor, double);
  vtkGetMacro(MaintenanceFactor, double);
  ///@}

  ///@{
  /**
   * Unit of illuminances in the table and of Target, see Units. Default: LUX.
   */
  vtkSetClampMacro(Unit, int, LUX, FOOT_CANDLES);
  vtkGetMacro(Unit, int);
  ///@}

  ///@{
  /**
   * For MeanLuminance, as in vtkIlluminationMap: name of a cell array of diffuse reflectances, [0,
   * 1], one component or three (a colour). Empty or "None": DiffuseReflectance, where there is one.
   * Default: empty.
   */
  vtkSetStdStringFromCharMacro(ReflectanceArray);
  vtkGetCharFromStdStringMacro(ReflectanceArray);
  ///@}

  ///@{
  /**
   * Diffuse reflectance of cells without an array of these, [0, 1]. Default: 0.5.
   */
  vtkSetMacro(Reflectance, double);
  vtkGetMacro(Reflectance, double);
  ///@}

  ///@{
  /**
   * Length of the data's length unit in metres, > 0: 0.001 for a model in millimetres. Default: 1.
   */
  vtkSetMacro(MetresPerUnit, double);
  vtkGetMacro(MetresPerUnit, double);
  ///@}

protected:
  vtkIlluminanceStatistics();
  ~vtkIlluminanceStatistics() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  std::string IlluminanceArray = "Illuminance";
  std::string StandardErrorArray = "StandardError";
  std::string PartArray;
  std::string ValidArray = "Valid";
  double Target = 500.0;
  double MaintenanceFactor = 1.0;
  int Unit = LUX;
  std::string ReflectanceArray;
  double Reflectance = 0.5;
  double MetresPerUnit = 1.0;

private:
  vtkIlluminanceStatistics(const vtkIlluminanceStatistics&) = delete;
  void operator=(const vtkIlluminanceStatistics&) = delete;

  /// Fills the table from the data of all ranks. Throws InputError.
  void Summarise(vtkDataObject* input, vtkTable* table);
};

#endif
