// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminationMap
 * @brief   illuminance at every point of a triangulated surface, by photon tracing
 *
 * Traces photons from lamps through the scene that the input describes and gives each point the
 * light that arrives there, directly and after any number of reflections. Hits are
 * registered on the vertices of the facet they land on and, in two of the three registrations,
 * compensated for the difference between the flat facet and the curved surface that the point
 * normals describe (B. Barladian, "Indirect illumination on curve surfaces").
 *
 * The input is a vtkPolyData, or a composite data set whose vtkPolyData blocks form one scene
 * together. Polygons and strips count as the triangles they are made of; vertices and lines stay
 * unlit. Point normals say which side of the surface is the front; without them they are computed
 * as vtkPolyDataNormals does. Facets without area change nothing. Cells that vtkGhostType marks as
 * duplicate, refined or hidden are not part of the scene; duplicate points get the values of their
 * owners, points of the input in the same place that face the same way.
 *
 * The output is the input, untouched, with these point arrays (double):
 *  - Illuminance (lx = lm/m^2): what arrives on the front; IlluminanceDirect + IlluminanceIndirect.
 *  - IlluminanceDirect, IlluminanceIndirect (lx): straight from the lamps, thin panes in between
 *    not counted, and all the rest.
 *  - StandardError (lx), RelativeError (StandardError / Illuminance; 1 where no light came, 0 at a
 *    point without a triangle): the noise of Illuminance, from eight independent replicates, or
 * with less than 30 hits from their number if that is more. Facet size is not in it.
 *  - IlluminanceRGB (lx, 3 components): by colour, where the scene has any; for white light the
 *    three are equal, and 0.2126 R + 0.7152 G + 0.0722 B is Illuminance.
 *  - Illuminance_<name> (lx): from one luminaire, with LampContributions. Luminaires without a
 * name, or with one that is taken, get one: "Lamp 2", "Spot (2)".
 *  - IlluminanceBack, StandardErrorBack (lx): what arrives on the back, with RegisterBackSide.
 *  - PhotonHits (vtkIdType): photons that hit the front of a facet around the point.
 * and these field data arrays: PhotonsEmitted = PhotonsAbsorbed + PhotonsEscaped + PhotonsCutOff,
 * EmittedFlux (lm), FluxOnFronts, FluxOnBacks and FluxEscaped (lm: where it first arrived, backs
 * that let light through not counted, or left the scene before), FluxCutByWeightBound (lm),
 * FluxSwitchedOff (lm), Seconds, PhotonsPerSecond, SegmentsPerSecond, MemoryNeeded (bytes, at
 * most), StoppedBy, Effects (which are on or off, and why), Notes (what was found and mended in the
 * input, what light is missing, what was assumed of photometric files), IlluminationMapsVersion. A
 * vtkWarning says what to do where most light fell on backs or met nothing.
 *
 * Give watts for lumens and the result is irradiance in W/m^2.
 *
 * The result is a function of the input and the properties alone: it has the same bits for any
 * NumberOfThreads. Where only Photons, TargetRelativeError or TimeLimit change and
 * ask for no fewer photons than there are, the run goes on from what it has; its result has the
 * bits of a run in one go. Bad input gives one error that names the array, the cell or point and
 * the value, and the input passes through without the arrays.
 */

#ifndef vtkIlluminationMap_h
#define vtkIlluminationMap_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"
#include "vtkTimeStamp.h" // for when a run must start anew

#include <cstdint> // for bytes
#include <memory>  // for the kept run
#include <string>  // for array names
#include <vector>  // for luminaires

class vtkTable;
struct LuminaireInput;
struct SurfaceDescription;

namespace PhotonTransport
{
struct Lighting;
struct StopRules;
struct TraceSettings;
}

class VTKILLUMINATION_EXPORT vtkIlluminationMap : public vtkSurfaceAlgorithm
{
public:
  static vtkIlluminationMap* New();
  vtkTypeMacro(vtkIlluminationMap, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using Superclass::Update;
  /**
   * As ever, but an observer of the progress may delete the filter: it lives until this returns.
   */
  void Update(int port) override;

  /**
   * The next execution starts anew, whatever has changed. Only the setters of Photons,
   * TargetRelativeError, TimeLimit, GroupMeans and MemoryLimit let the run go on.
   */
  void Modified() override;

  enum LampTypes
  {
    PARALLEL = 0,         ///< Light from infinitely far away over the whole scene.
    POINT = 1,            ///< The same intensity in all directions.
    LAMBERTIAN_POINT = 2, ///< A small flat lamp: intensity falls as the cosine.
    SPOT = 3,             ///< A cone of light from a point.
    RECTANGLE = 4,        ///< A Lambertian panel; it stops no light itself.
    DISK = 5,             ///< As RECTANGLE, round.
    EMITTING_FACETS = 6   ///< The input's own cells, by ExitanceArray.
  };

  enum Registrations
  {
    FLAT = 0,             ///< Formula (1) of the paper: facets as they are.
    FACET_RATIO = 1,      ///< Formulas (2) and (3): compensated at the hit.
    VERTEX_NORMALISED = 2 ///< Compensated at the vertex: no bias from facets, bounded weight.
  };

  enum Samplings
  {
    RANDOM = 0,
    SOBOL = 1
  };

  ///@{
  /**
   * Kind of lamp, see LampTypes. Default: PARALLEL.
   */
  vtkSetClampMacro(LampType, int, PARALLEL, EMITTING_FACETS);
  vtkGetMacro(LampType, int);
  ///@}

  ///@{
  /**
   * Where a point lamp or the centre of a panel is, in the data's length unit. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(LampPosition, double);
  vtkGetVector3Macro(LampPosition, double);
  ///@}

  ///@{
  /**
   * The way the light travels: of parallel light, or the axis of a lamp that has one. Any length
   * but zero. Default: (0, 0, -1).
   */
  vtkSetVector3Macro(LampDirection, double);
  vtkGetVector3Macro(LampDirection, double);
  ///@}

  ///@{
  /**
   * Width and height of a rectangle, or the radius of a disk first, in the data's length unit; 0
   * or more. With 0 all light comes from one point, or from a line. The width runs along z x
   * LampDirection (along x for a lamp that shines straight up or down). Default: (1, 1).
   */
  vtkSetVector2Macro(LampSize, double);
  vtkGetVector2Macro(LampSize, double);
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
   * Luminous flux of the lamp, lm, >= 0. Not for parallel light and emitting facets. Default: 1000.
   */
  vtkSetMacro(LuminousFlux, double);
  vtkGetMacro(LuminousFlux, double);
  ///@}

  ///@{
  /**
   * Illuminance that parallel light gives a surface perpendicular to it, lx, >= 0. Default: 1000.
   */
  vtkSetMacro(ParallelIlluminance, double);
  vtkGetMacro(ParallelIlluminance, double);
  ///@}

  ///@{
  /**
   * Diffuse reflectance of all cells, both sides, [0, 1], where no array says otherwise.
   * Default: 0.5.
   */
  vtkSetMacro(Reflectance, double);
  vtkGetMacro(Reflectance, double);
  ///@}

  ///@{
  /**
   * Name of a cell array of diffuse reflectances in [0, 1], 1 or 3 components (3 are a colour). It
   * takes precedence over an array DiffuseReflectance. Default: none (empty, or "None").
   */
  vtkSetStdStringFromCharMacro(ReflectanceArray);
  vtkGetCharFromStdStringMacro(ReflectanceArray);
  ///@}

  ///@{
  /**
   * Shares of the light that cells without arrays of their own treat in other ways than diffuse
   * reflection, each in [0, 1] and with Reflectance at most 1 together; see vtkSurfaceMaterial for
   * what they mean, which writes them onto cells. Default: 0.
   */
  vtkSetMacro(SpecularReflectance, double);
  vtkGetMacro(SpecularReflectance, double);
  vtkSetMacro(GlossyReflectance, double);
  vtkGetMacro(GlossyReflectance, double);
  vtkSetMacro(DiffuseTransmittance, double);
  vtkGetMacro(DiffuseTransmittance, double);
  vtkSetMacro(ClearTransmittance, double);
  vtkGetMacro(ClearTransmittance, double);
  ///@}

  ///@{
  /**
   * Of the glossy share, (0, 1]. Default: 0.3.
   */
  vtkSetMacro(Roughness, double);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{
  /**
   * Of the clear share, [1, 4]. Default: 1.5.
   */
  vtkSetMacro(RefractiveIndex, double);
  vtkGetMacro(RefractiveIndex, double);
  ///@}

  ///@{
  /**
   * Whether clear cells are the surface of a solid body, which bends light, in place of thin panes.
   * Default: off.
   */
  vtkSetMacro(SolidBody, bool);
  vtkGetMacro(SolidBody, bool);
  vtkBooleanMacro(SolidBody, bool);
  ///@}

  ///@{
  /**
   * Whether the cell arrays that vtkSurfaceMaterial writes (DiffuseReflectance,
   * SpecularReflectance, GlossyReflectance, Roughness, DiffuseTransmittance, ClearTransmittance,
   * RefractiveIndex, SolidBody) count where a block has them. Default: on.
   */
  vtkSetMacro(UseMaterialArrays, bool);
  vtkGetMacro(UseMaterialArrays, bool);
  vtkBooleanMacro(UseMaterialArrays, bool);
  ///@}

  ///@{
  /**
   * Name of a cell array of luminous exitances, lm/m^2, >= 0, 1 or 3 components (3 are a colour),
   * for EMITTING_FACETS: the cells' fronts shine diffusely. Default: none (empty, or "None").
   */
  vtkSetStdStringFromCharMacro(ExitanceArray);
  vtkGetCharFromStdStringMacro(ExitanceArray);
  ///@}

  ///@{
  /**
   * How hits are registered, see Registrations. Default: VERTEX_NORMALISED.
   */
  vtkSetClampMacro(Registration, int, FLAT, VERTEX_NORMALISED);
  vtkGetMacro(Registration, int);
  ///@}

  ///@{
  /**
   * The photons to stop at, 1 to 1e10, rounded up to a multiple of 2048. Four times as many halve
   * the noise. Default: 1000000. The form for doubles is ParaView's, whose properties of whole
   * numbers end at 2^31; what is no whole number within the range is refused when the filter runs.
   */
  void SetPhotons(vtkIdType photons);
  vtkGetMacro(Photons, vtkIdType);
  void SetPhotonsAsDouble(double photons);
  vtkGetMacro(PhotonsAsDouble, double);
  ///@}

  ///@{
  /**
   * The relative error to stop at, unless Photons or TimeLimit are reached before: area-weighted
   * RMS of StandardError over the mean Illuminance; 0.02 is 2 %, 0 is no target. Where none of
   * 2^20 photons registers no target can be met, and the run ends. Default: 0.
   */
  virtual void SetTargetRelativeError(double error)
  {
    this->SetAndKeepRun(this->TargetRelativeError, error);
  }
  vtkGetMacro(TargetRelativeError, double);
  ///@}

  ///@{
  /**
   * Seconds of tracing to stop at, >= 0; 0 is no limit. Default: 0.
   */
  virtual void SetTimeLimit(double seconds) { this->SetAndKeepRun(this->TimeLimit, seconds); }
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /**
   * Any integer; another one gives independent noise. Default: 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * SOBOL spreads the photons of a lamp evenly (Owen-scrambled), RANDOM does not. Default: SOBOL.
   */
  vtkSetClampMacro(Sampling, int, RANDOM, SOBOL);
  vtkGetMacro(Sampling, int);
  ///@}

  ///@{
  /**
   * Whether light is reflected diffusely. Each of these effects is simulated only where the scene
   * calls for it (the field array Effects says why or why not) and can be switched off: photons
   * that would have taken that way then end, and are counted in PhotonsCutOff and
   * FluxSwitchedOff. Default: on.
   */
  vtkSetMacro(Interreflection, bool);
  vtkGetMacro(Interreflection, bool);
  vtkBooleanMacro(Interreflection, bool);
  ///@}

  ///@{
  /**
   * As by a mirror; in a lobe about that direction; diffusely to the other side; through thin
   * panes, or off them; at the surface of solid bodies. As Interreflection. Default: on.
   */
  vtkSetMacro(SpecularReflection, bool);
  vtkGetMacro(SpecularReflection, bool);
  vtkBooleanMacro(SpecularReflection, bool);
  vtkSetMacro(GlossyReflection, bool);
  vtkGetMacro(GlossyReflection, bool);
  vtkBooleanMacro(GlossyReflection, bool);
  vtkSetMacro(DiffuseTransmission, bool);
  vtkGetMacro(DiffuseTransmission, bool);
  vtkBooleanMacro(DiffuseTransmission, bool);
  vtkSetMacro(ClearTransmission, bool);
  vtkGetMacro(ClearTransmission, bool);
  vtkBooleanMacro(ClearTransmission, bool);
  vtkSetMacro(Refraction, bool);
  vtkGetMacro(Refraction, bool);
  vtkBooleanMacro(Refraction, bool);
  ///@}

  ///@{
  /**
   * Whether photons carry one of three channels each, if any material or lamp has a colour. Off,
   * or in a scene without colours, there is one channel, the luminous one. Default: on.
   */
  vtkSetMacro(Colour, bool);
  vtkGetMacro(Colour, bool);
  vtkBooleanMacro(Colour, bool);
  ///@}

  ///@{
  /**
   * Whether each luminaire's part is kept, as Illuminance_<name>, so that lamps can be dimmed
   * without tracing again. Costs 8 bytes a point and lamp, for each thread once more. Default: off.
   */
  vtkSetMacro(LampContributions, bool);
  vtkGetMacro(LampContributions, bool);
  vtkBooleanMacro(LampContributions, bool);
  ///@}

  ///@{
  /**
   * The second, optional, repeatable input: luminaires, from vtkLuminaireSource or
   * vtkPhotometricReader, or surfaces that shine by a cell array "Exitance" (lm/m^2) but are no
   * part of the scene; or composite data sets, of which every block that is not empty is one of
   * these. Luminaires go where filters move their points. With any of them the filter's own lamp is
   * off.
   */
  void AddLuminaireConnection(vtkAlgorithmOutput* luminaire);
  void RemoveAllLuminaires();
  ///@}

  ///@{
  /**
   * Whether light on the backs of facets is registered too, as IlluminanceBack. Default: off.
   */
  vtkSetMacro(RegisterBackSide, bool);
  vtkGetMacro(RegisterBackSide, bool);
  vtkBooleanMacro(RegisterBackSide, bool);
  ///@}

  ///@{
  /**
   * Whether vtkIlluminationMapSmoothing gets what it works best with: the maps as means over each
   * of four groups of photons, IlluminanceDirectGroups and IlluminanceIndirectGroups (lx, 4
   * components). Costs no tracing, but 64 bytes a point. Default: off.
   */
  virtual void SetGroupMeans(bool on) { this->SetAndKeepRun(this->GroupMeans, on); }
  vtkGetMacro(GroupMeans, bool);
  vtkBooleanMacro(GroupMeans, bool);
  ///@}

  ///@{
  /**
   * Metres that the data's length unit is long, > 0: 0.001 for a model in millimetres. Default: 1.
   */
  vtkSetMacro(MetresPerUnit, double);
  vtkGetMacro(MetresPerUnit, double);
  ///@}

  ///@{
  /**
   * Edges sharper than this stay sharp where normals are computed, degrees, [0, 180]. Only used on
   * input without point normals. A point on a sharp edge then gets the mean of its sides, by area.
   * Default: 30.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Threads to trace with, 0 to 1024; 0 means all cores. The result does not depend on it.
   * Default: 0.
   */
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Largest factor by which compensation may raise a hit, [1, 1048576]. Ordinary surfaces stay
   * below 2 with VERTEX_NORMALISED; FACET_RATIO has no bound of its own. What is cut off is
   * reported in FluxCutByWeightBound. Default: 16.
   */
  vtkSetMacro(WeightBound, double);
  vtkGetMacro(WeightBound, double);
  ///@}

  ///@{
  /**
   * Photons that are still on their way after this many segments end there and are counted in
   * PhotonsCutOff; >= 1. Default: 10000, which no scene that absorbs 1 % ever reaches.
   */
  vtkSetMacro(MaximumPathLength, int);
  vtkGetMacro(MaximumPathLength, int);
  ///@}

  ///@{
  /**
   * GiB of memory that the input's triangles, the run and its results may take together, >= 0; 0 is
   * what the machine has available (on Linux; no limit on other systems). What they need at most is
   * worked out once the input is cut into triangles, about a tenth of it, and before the rest is
   * taken; it is told in MemoryNeeded, and refused if it is more. Default: 0.
   */
  virtual void SetMemoryLimit(double limit) { this->SetAndKeepRun(this->MemoryLimit, limit); }
  vtkGetMacro(MemoryLimit, double);
  ///@}

protected:
  vtkIlluminationMap();
  ~vtkIlluminationMap() override;

  int ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    vtkDataObject* input, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void WithoutResult(vtkInformationVector* outputs) override;

  int LampType = PARALLEL;
  double LampPosition[3] = { 0.0, 0.0, 1.0 };
  double LampDirection[3] = { 0.0, 0.0, -1.0 };
  double LampSize[2] = { 1.0, 1.0 };
  double SpotHalfAngle = 30.0;
  double SpotExponent = 0.0;
  double LuminousFlux = 1000.0;
  double ParallelIlluminance = 1000.0;
  double Reflectance = 0.5;
  double SpecularReflectance = 0.0;
  double GlossyReflectance = 0.0;
  double DiffuseTransmittance = 0.0;
  double ClearTransmittance = 0.0;
  double Roughness = 0.3;
  double RefractiveIndex = 1.5;
  bool SolidBody = false;
  bool UseMaterialArrays = true;
  std::string ReflectanceArray;
  std::string ExitanceArray;
  int Registration = VERTEX_NORMALISED;
  vtkIdType Photons = 1000000;
  double PhotonsAsDouble = 1e6;
  double TargetRelativeError = 0.0;
  double TimeLimit = 0.0;
  int Seed = 1;
  int Sampling = SOBOL;
  bool Interreflection = true;
  bool SpecularReflection = true;
  bool GlossyReflection = true;
  bool DiffuseTransmission = true;
  bool ClearTransmission = true;
  bool Refraction = true;
  bool Colour = true;
  bool LampContributions = false;
  bool RegisterBackSide = false;
  bool GroupMeans = false;
  double MetresPerUnit = 1.0;
  double FeatureAngle = 30.0;
  int NumberOfThreads = 0;
  double WeightBound = 16.0;
  int MaximumPathLength = 10000;
  double MemoryLimit = 0.0;

private:
  vtkIlluminationMap(const vtkIlluminationMap&) = delete;
  void operator=(const vtkIlluminationMap&) = delete;

  using Luminaires = std::vector<LuminaireInput>;

  // The properties in the core's terms; each throws for values out of range.
  PhotonTransport::Lighting MakeLighting(const Luminaires& luminaires);
  PhotonTransport::TraceSettings MakeTraceSettings();
  PhotonTransport::StopRules MakeStopRules();
  SurfaceDescription DescribeSurface(bool otherLamps);
  std::uint64_t MemoryLimitInBytes(); ///< 0 for what the machine has.

  template <typename Value>
  void SetAndKeepRun(Value& property, Value value)
  {
    if (property != value)
    {
      property = value;
      this->Superclass::Modified();
    }
  }

  struct KeptRun;
  std::unique_ptr<KeptRun> Kept; ///< To go on from.
  vtkTimeStamp RunChanged;       ///< When something changed that a run can't go on after.
};

#endif
