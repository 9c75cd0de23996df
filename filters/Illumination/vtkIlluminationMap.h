// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminationMap
 * @brief   illuminance at every point of a triangulated surface, by photon tracing
 *
 * Traces photons from lamps through the scene that the input describes and gives each point the
 * light that arrives there, directly and after any number of reflections. Hits are registered on
 * the vertices of the facet they land on. Two of the three registrations compensate for the
 * difference between the flat facet and the curved surface that the point normals describe (B.
 * Barladian, "Indirect illumination on curve surfaces"). With Method FINAL_GATHERING a second pass
 * finds the light at the points themselves, from what the photons have lit.
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
 *  - IlluminanceDirect (lx): light straight from the lamps or through thin panes.
 *  - IlluminanceIndirect (lx): all other light.
 *  - IlluminanceCaustic (lx), with FINAL_GATHERING: the part of IlluminanceIndirect that only
 *    mirrors, gloss and glass have sent there.
 *  - StandardError (lx): the noise of Illuminance, from eight independent replicates; where fewer
 *    than 30 photons have hit, at least what their number says. The size of facets is not in it.
 *    With FINAL_GATHERING it is that of the rays and of the photons that lit what they find.
 *  - FacetError (lx), with PHOTON_TRACING: how far the value at the point, a mean over the facets
 *    around it, may be from the light at the point itself. An estimate from the map: its RMS over a
 *    wall or a body is within a factor of two of the true one where that exceeds the noise.
 *  - RelativeError: StandardError / Illuminance; 1 where no light came, 0 at a point without a
 *    triangle.
 *  - IlluminanceRGB (lx, 3 components): by colour, if the scene has any. White light has three
 *    equal components, and 0.2126 R + 0.7152 G + 0.0722 B is Illuminance.
 *  - Illuminance_<name> (lx): from one luminaire, with LampContributions. A luminaire without a
 *    name, or whose name is taken, gets one, such as "Lamp 2" or "Spot (2)".
 *  - StandardErrorRGB (lx, 3 components), StandardError_<name> (lx): the noise of these two, with
 *    PHOTON_TRACING, found as that of Illuminance is.
 *  - IlluminanceBack, StandardErrorBack (lx): what arrives on the back, with RegisterBackSide.
 *  - PhotonHits (vtkIdType), with PHOTON_TRACING: photons that hit the front of a facet around the
 *    point.
 *  - IlluminanceDirectGroups, IlluminanceIndirectGroups (lx, 4 components): with GroupMeans and
 *    PHOTON_TRACING.
 *
 * It has these field data arrays:
 *  - PhotonsEmitted = PhotonsAbsorbed + PhotonsEscaped + PhotonsCutOff + PhotonsHandedOver +
 *    PhotonsBlocked. The last two are 0 unless daylight comes through openings with PHOTON_TRACING:
 *    photons of the sky or the sun that came to an opening, whose light starts there, and photons
 *    that were to start there and have no light from where they would have come.
 *  - EmittedFlux (lm), of which FluxOnFronts and FluxOnBacks (lm) first arrived on a front or on a
 *    back that lets no light through, and FluxEscaped (lm) left the scene before.
 *  - FluxCutByWeightBound, FluxSwitchedOff (lm).
 *  - Seconds, PhotonsPerSecond, SegmentsPerSecond; MemoryNeeded (bytes, at most).
 *  - PredictedPhotons, PredictedSeconds: what the run takes to reach a TargetRelativeError.
 *  - StoppedBy, Effects (which are on or off, and why), IlluminationMapsVersion (text).
 *  - IlluminationMapSettings (text): the properties on which the scene and its light depend, for
 *    filters that go on with it: vtkIlluminanceSensors, vtkIlluminatedAppearance.
 *  - Notes (text): what was found in the input and mended or left out, through which openings
 *    daylight comes, what light is missing, and what was assumed of photometric files. Warnings
 *    (text): those of the run.
 *
 * A warning says what to do if much of a lamp's light fell on backs or met nothing, or if facets
 * are too close together or too small to be told apart.
 *
 * The second output is a vtkTable with a row for each round of the run: Photons, GatherRays (for
 * each point; 0 with PHOTON_TRACING), Seconds, RelativeError (as TargetRelativeError means it),
 * RelativeFacetError (the facets' part of it, with CountFacetError), MedianRelativeError and
 * Percentile95RelativeError (over the points that light reached), SegmentsPerSecond,
 * PredictedPhotons, PredictedSeconds, and with a region (AccuracyRegionArray) RegionRelativeError,
 * RegionMedianRelativeError and RegionPercentile95RelativeError, which are 1 in rounds before the
 * region was chosen.
 *
 * The third output is a vtkPolyData, the photon map: a vertex for each hit of the first photons, up
 * to MaximumPhotons hits, in the order of photons and along each path. Point arrays: Flux (lm),
 * Direction (unit, in which the photon flew), Luminaire (its number, from 0), Scatterings (before
 * this hit), Side (1: front, -1: back), OriginalCellIds, with blocks BlockIndex (flat index), with
 * colours FluxRGB (lm). The sum of Flux over a surface is the flux that arrives there; if all
 * photons are stored, it is that of the map with FLAT. Where surfaces share their place, a photon
 * hits the one whose material counts. Field arrays: PhotonsFollowed, the number of photons that the
 * hits are of, and LuminaireNames. The fourth output, a vtkPolyData, has the paths of the first
 * PhotonPaths photons as polylines, from the lamp on; those that left the scene end a little beyond
 * their last hit. Point array: Scatterings (before this point). Cell arrays: Luminaire, Escaped (0
 * or 1), with colours LightColour (linear RGB, luminance 1, as it started).
 *
 * If fluxes are given in watts instead of lumens, the result is irradiance in W/m^2.
 *
 * The result is a function of the input and the properties alone, but for TimeLimit, an abort, and
 * CurvedSurface where memory is too short for its parts: they are then coarser, as Effects says.
 * It has the same bits for any NumberOfThreads. If only Photons, TargetRelativeError,
 * the accuracy region, CountFacetError, TimeLimit, MemoryLimit, GroupMeans, MaximumPhotons or
 * PhotonPaths change, and Photons is no less than what has been traced, the run goes on from what
 * it has; its result has the bits of a run to as many photons in one go. Bad input gives one error
 * that names the array, the cell or point and the value, and the input passes through without the
 * arrays.
 */

#ifndef vtkIlluminationMap_h
#define vtkIlluminationMap_h

#include "vtkIlluminationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"
#include "vtkTimeStamp.h" // for when a run must start anew

#include <cstdint>  // for bytes
#include <memory>   // for the kept run
#include <optional> // for a refined map
#include <set>      // for block numbers
#include <string>   // for array names
#include <vector>   // for luminaires

class vtkFieldData;
class vtkTable;

namespace Illumination
{
class LuminaireCache;
class SceneBlocks;
struct KeptRun;
struct LuminaireInput;
struct SurfaceDescription;
}

namespace PhotonTransport
{
struct AdaptiveLimits;
struct Lighting;
struct RefinedMap;
struct StopRules;
struct TraceSettings;
enum class StopReason : int;
}

class VTKILLUMINATION_EXPORT vtkIlluminationMap : public vtkSurfaceAlgorithm
{
public:
  static vtkIlluminationMap* New();
  vtkTypeMacro(vtkIlluminationMap, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using Superclass::Update;
  /**
   * As in the superclass. An observer of the progress may delete the filter: it lives until this
   * returns.
   */
  void Update(int port) override;

  /**
   * The next execution starts anew, whatever has changed. Only the setters of Photons,
   * TargetRelativeError, the accuracy region, CountFacetError, TimeLimit, GroupMeans, MemoryLimit,
   * MaximumPhotons, PhotonPaths and those of the refinement let the run go on.
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

  enum Methods
  {
    PHOTON_TRACING = 0, ///< Photons register at the points: a point has a mean over its facets.
    FINAL_GATHERING = 1 ///< A second pass gathers at the points what photons have lit.
  };

  enum Registrations
  {
    FLAT = 0,             ///< Formula (1) of Barladian: the facets are the surface.
    FACET_RATIO = 1,      ///< Formulas (2) and (3) of Barladian: compensated at the hit.
    VERTEX_NORMALISED = 2 ///< Compensated at the vertex: no bias from facets.
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
   * The direction in which the light travels: that of parallel light, the axis of a Lambertian
   * point or a spot, the side to which a panel shines. Finite, any length but zero. Default: (0, 0,
   * -1).
   */
  vtkSetVector3Macro(LampDirection, double);
  vtkGetVector3Macro(LampDirection, double);
  ///@}

  ///@{
  /**
   * Width and height of a rectangle, or the radius of a disk (the second number is not used then),
   * in the data's length unit, >= 0. From a disk of radius 0 and from a rectangle without width and
   * height all light comes from one point, from a rectangle without one of them from a line. The
   * width runs along z x LampDirection (along x for a lamp that shines straight up or down).
   * Default: (1, 1).
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
   * Luminous flux of the lamp, lm, >= 0. Parallel light and emitting facets do not use it. Default:
   * 1000.
   */
  virtual void SetLuminousFlux(double flux) { this->SetAndKeepRun(this->LuminousFlux, flux); }
  vtkGetMacro(LuminousFlux, double);
  ///@}

  ///@{
  /**
   * Illuminance that parallel light gives a surface perpendicular to it, lx, >= 0. Default: 1000.
   */
  virtual void SetParallelIlluminance(double lux)
  {
    this->SetAndKeepRun(this->ParallelIlluminance, lux);
  }
  vtkGetMacro(ParallelIlluminance, double);
  ///@}

  ///@{
  /**
   * Diffuse reflectance, on both sides, of cells without an array of diffuse reflectances, [0, 1].
   * Default: 0.5.
   */
  vtkSetMacro(Reflectance, double);
  vtkGetMacro(Reflectance, double);
  ///@}

  ///@{
  /**
   * Name of a cell array of diffuse reflectances in [0, 1], 1 or 3 components (3 are a colour),
   * which every lit block must have. It takes precedence over an array DiffuseReflectance. Empty or
   * "None": no such array. Default: empty.
   */
  vtkSetStdStringFromCharMacro(ReflectanceArray);
  vtkGetCharFromStdStringMacro(ReflectanceArray);
  ///@}

  ///@{
  /**
   * Shares of the light that cells without the array of that name reflect as a mirror, reflect
   * about the mirror direction, let through diffusely and let through clearly. Each is in [0, 1],
   * and together with Reflectance they are at most 1. vtkSurfaceMaterial, which writes such arrays,
   * says more of them. Default: 0.
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
   * Roughness of glossy reflection by cells without the array of that name, (0, 1]. Default: 0.3.
   */
  vtkSetMacro(Roughness, double);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{
  /**
   * Refractive index of clear cells without the array of that name, [1, 4]. Default: 1.5.
   */
  vtkSetMacro(RefractiveIndex, double);
  vtkGetMacro(RefractiveIndex, double);
  ///@}

  ///@{
  /**
   * Whether clear cells without the array of that name are the surface of a solid body, which bends
   * light. Otherwise they are thin panes. Default: off.
   */
  vtkSetMacro(SolidBody, bool);
  vtkGetMacro(SolidBody, bool);
  vtkBooleanMacro(SolidBody, bool);
  ///@}

  ///@{
  /**
   * Whether the cell arrays that vtkSurfaceMaterial writes (DiffuseReflectance,
   * SpecularReflectance, GlossyReflectance, Roughness, DiffuseTransmittance, ClearTransmittance,
   * RefractiveIndex, SolidBody) are used in blocks that have them. Default: on.
   */
  vtkSetMacro(UseMaterialArrays, bool);
  vtkGetMacro(UseMaterialArrays, bool);
  vtkBooleanMacro(UseMaterialArrays, bool);
  ///@}

  ///@{
  /**
   * Name of the cell array of luminous exitances, lm/m^2, >= 0, 1 or 3 components (3 are a colour),
   * for EMITTING_FACETS, which need one: the cells' fronts shine diffusely. Default: empty.
   */
  vtkSetStdStringFromCharMacro(ExitanceArray);
  vtkGetCharFromStdStringMacro(ExitanceArray);
  ///@}

  ///@{
  /**
   * How the map is made, see Methods. With FINAL_GATHERING the value of a point is that at the
   * point itself, whatever the size of facets: light straight from the lamps, caustics (light that
   * only mirrors, gloss and glass have sent there, IlluminanceCaustic), which photons bring, and
   * light that rays gather from diffuse surfaces, as photons have lit them. Registration then
   * concerns caustics alone, and there are no group means. Default: PHOTON_TRACING.
   */
  vtkSetClampMacro(Method, int, PHOTON_TRACING, FINAL_GATHERING);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Rays that gather light for each point and side with FINAL_GATHERING, about; 16 to 16384, or 0
   * for as many as suit the photons: 254 for a million. Default: 0.
   */
  vtkSetMacro(GatherRays, int);
  vtkGetMacro(GatherRays, int);
  ///@}

  ///@{
  /**
   * Whether the output's surface is refined where the light between its points is not what linear
   * interpolation shows, with FINAL_GATHERING: shadows get their borders on a wall of two
   * triangles. Light is received at the middles of edges, and an edge is halved if it misses there
   * by more than RefinementTolerance and by more than four standard errors, down to edges that are
   * as short as the square of the tolerance asks for at a hard shadow's border. Details are looked
   * for about every forty-eighth of the scene, and more closely where the surface sees something
   * near. Rays see the surface as it is; with CurvedSurface the output is the surface that is
   * traced, further refined. The input's points come first, with the values that they have without
   * it. Other arrays are carried over as by vtkSurfaceRefinement; IlluminanceCaustic is
   * interpolated. Cells that are marked as duplicates stay whole. A time limit does not count it.
   * Default: off.
   */
  virtual void SetAdaptiveRefinement(bool on) { this->SetAndKeepRun(this->AdaptiveRefinement, on); }
  vtkGetMacro(AdaptiveRefinement, bool);
  vtkBooleanMacro(AdaptiveRefinement, bool);
  ///@}

  ///@{
  /**
   * By how much linear interpolation may miss the light at the middle of an edge, relative to the
   * light there or, where that is darker, to a tenth of the map's mean; > 0. Default: 0.05.
   */
  virtual void SetRefinementTolerance(double tolerance)
  {
    this->SetAndKeepRun(this->RefinementTolerance, tolerance);
  }
  vtkGetMacro(RefinementTolerance, double);
  ///@}

  ///@{
  /**
   * Triangles of the refined surface at most, 1 to 1e9, and no more than fit the memory, at about 1
   * KiB each. If more were wanted, edges with the greatest errors are halved first, and a warning
   * says so. Default: 1000000.
   */
  virtual void SetMaximumCells(int cells) { this->SetAndKeepRun(this->MaximumCells, cells); }
  vtkGetMacro(MaximumCells, int);
  ///@}

  ///@{
  /**
   * How hits are registered, see Registrations; with FINAL_GATHERING those of caustics alone.
   * Default: VERTEX_NORMALISED.
   */
  vtkSetClampMacro(Registration, int, FLAT, VERTEX_NORMALISED);
  vtkGetMacro(Registration, int);
  ///@}

  ///@{
  /**
   * The number of photons to stop at, a whole number from 1 to 1e10, rounded up to a multiple of
   * 2048. Four times as many halve the noise of random numbers. Other numbers are refused when the
   * filter runs. ParaView sets it as a double, since its properties of whole numbers end at 2^31.
   * Default: 1000000.
   */
  void SetPhotons(vtkIdType photons);
  vtkGetMacro(Photons, vtkIdType);
  void SetPhotonsAsDouble(double photons);
  vtkGetMacro(PhotonsAsDouble, double);
  ///@}

  ///@{
  /**
   * The relative error to stop at, unless Photons or TimeLimit are reached before: the
   * area-weighted RMS of StandardError over the area-weighted mean of Illuminance, both over the
   * whole surface or over the cells of AccuracyRegionArray; >= 0. 0 is no target, 0.02 is 2 %. If
   * none of 2^20 photons registers on a front, no target can be met, and the run ends. Default: 0.
   */
  virtual void SetTargetRelativeError(double error)
  {
    this->SetAndKeepRun(this->TargetRelativeError, error);
  }
  vtkGetMacro(TargetRelativeError, double);
  ///@}

  ///@{
  /**
   * Name of a cell array of one number a cell that says where accuracy counts: cells whose value is
   * not 0 are the region in which TargetRelativeError is to be met, such as a room with a bright
   * ground outside. Blocks without the array are not in the region. Empty or "None": accuracy
   * counts everywhere, or in all cells of the AccuracyRegionBlocks. Default: empty.
   */
  virtual void SetAccuracyRegionArray(const char* name);
  vtkGetCharFromStdStringMacro(AccuracyRegionArray);
  ///@}

  ///@{
  /**
   * Flat indices of the blocks of a composite data set in which accuracy counts, each with all
   * blocks below it; of their cells those that AccuracyRegionArray chooses, if it is set. Each
   * index must exist. If none is added, all blocks count. They are not used for a single surface.
   * Default: none.
   */
  void AddAccuracyRegionBlock(int flatIndex);
  void RemoveAllAccuracyRegionBlocks();
  int GetNumberOfAccuracyRegionBlocks() const
  {
    return static_cast<int>(this->AccuracyRegionBlocks.size());
  }
  bool HasAccuracyRegionBlock(int flatIndex) const
  {
    return this->AccuracyRegionBlocks.count(flatIndex) != 0;
  }
  ///@}

  ///@{
  /**
   * Count FacetError in TargetRelativeError: the error at each point is then the root of
   * StandardError^2 + FacetError^2. A run that can't reach the target since FacetError alone is
   * more ends as soon as that is known, and StoppedBy says so. Without effect with FINAL_GATHERING.
   * Default: off.
   */
  virtual void SetCountFacetError(bool on) { this->SetAndKeepRun(this->CountFacetError, on); }
  vtkGetMacro(CountFacetError, bool);
  vtkBooleanMacro(CountFacetError, bool);
  ///@}

  ///@{
  /**
   * Seconds of tracing to stop at, >= 0, counted from the start of the run, also where it goes on;
   * 0 is no limit. Default: 0.
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
   * What photons are drawn from. SOBOL: Owen-scrambled Sobol points, which spread the photons of a
   * lamp and their first reflection evenly. RANDOM: independent numbers. Default: SOBOL.
   */
  vtkSetClampMacro(Sampling, int, RANDOM, SOBOL);
  vtkGetMacro(Sampling, int);
  ///@}

  ///@{
  /**
   * Whether diffuse reflection is simulated. This effect and the ones below are simulated only if
   * the scene calls for them; the field array Effects says why or why not. If an effect is switched
   * off, photons that would have taken that way end, and are counted in PhotonsCutOff and
   * FluxSwitchedOff. Default: on.
   */
  vtkSetMacro(Interreflection, bool);
  vtkGetMacro(Interreflection, bool);
  vtkBooleanMacro(Interreflection, bool);
  ///@}

  ///@{
  /**
   * Whether these effects are simulated, as Interreflection. SpecularReflection: as by a mirror.
   * GlossyReflection: in a lobe about the mirror direction. DiffuseTransmission: diffusely to the
   * other side. ClearTransmission: through thin panes, and reflection by them. Refraction: at the
   * surface of solid bodies, and reflection there. Default: on.
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
   * Whether photons have colours, shares of red, green and blue in their luminous flux, if a
   * material or a lamp has one. If this is off, or if nothing has a colour, light has one channel,
   * the luminous one. Default: on.
   */
  vtkSetMacro(Colour, bool);
  vtkGetMacro(Colour, bool);
  vtkBooleanMacro(Colour, bool);
  ///@}

  ///@{
  /**
   * Whether each luminaire's part is kept, as Illuminance_<name>. With PHOTON_TRACING a map of
   * other fluxes, dimming or colours of the lamps then follows from what was traced, its errors
   * too, without a photon (IlluminationRun::Relight). Each lamp gets some photons, whatever its
   * flux (SharesForLampsApart). This takes 152 bytes for each point and lamp, 32 more for each
   * thread, and 240 and 48 more where surfaces have colours. One factor of all light needs neither
   * this nor that method. Default: off.
   */
  vtkSetMacro(LampContributions, bool);
  vtkGetMacro(LampContributions, bool);
  vtkBooleanMacro(LampContributions, bool);
  ///@}

  ///@{
  /**
   * The second, optional, repeatable input. It takes luminaires from vtkLuminaireSource or
   * vtkPhotometricReader, surfaces that shine by a cell array "Exitance" (lm/m^2) and are not part
   * of the scene, and composite data sets, of which every block that is not empty is one of these.
   * Luminaires go where filters move their points. If any is connected, the filter's own lamp is
   * off.
   */
  void AddLuminaireConnection(vtkAlgorithmOutput* luminaire);
  void RemoveAllLuminaires();
  ///@}

  ///@{
  /**
   * Whether light is traced on the curved surface that points and normals tell of, in place of the
   * flat triangles: shadows get round outlines, coarse bodies catch the light that the curved ones
   * would, and coarse facets do not shade themselves. Each triangle whose normals differ is divided
   * along a quadratic patch until the normal turns by about 7 degrees at most along an edge; flat
   * triangles stay whole, and a surface that is flat everywhere is traced as before. The light
   * still counts for the input's points. Illuminances are per area of the curved surface. A part
   * takes about 0.6 KB of memory. Default: off.
   */
  vtkSetMacro(CurvedSurface, bool);
  vtkGetMacro(CurvedSurface, bool);
  vtkBooleanMacro(CurvedSurface, bool);
  ///@}

  ///@{
  /**
   * Whether light on the backs of facets is registered as well, as IlluminanceBack. No warning then
   * says that light fell on backs. Default: off.
   */
  vtkSetMacro(RegisterBackSide, bool);
  vtkGetMacro(RegisterBackSide, bool);
  vtkBooleanMacro(RegisterBackSide, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the arrays with which vtkIlluminationMapSmoothing works best: the maps
   * as means over each of four groups of photons, IlluminanceDirectGroups and
   * IlluminanceIndirectGroups (lx, 4 components). They take no more tracing, and 64 bytes a point.
   * With FINAL_GATHERING there are none, since its noise is independent from point to point.
   * Default: on.
   */
  virtual void SetGroupMeans(bool on) { this->SetAndKeepRun(this->GroupMeans, on); }
  vtkGetMacro(GroupMeans, bool);
  vtkBooleanMacro(GroupMeans, bool);
  ///@}

  ///@{
  /**
   * Hits that the third output, the photon map, has at most, >= 0; 0: none. They are those of the
   * first photons, as many as have no more hits together; these are followed once more, which the
   * run itself does not notice. A hit takes about 0.3 KB of memory. Default: 0.
   */
  virtual void SetMaximumPhotons(int hits) { this->SetAndKeepRun(this->MaximumPhotons, hits); }
  vtkGetMacro(MaximumPhotons, int);
  ///@}

  ///@{
  /**
   * Photons whose paths the fourth output has, 0 to 10000. Default: 0.
   */
  virtual void SetPhotonPaths(int photons) { this->SetAndKeepRun(this->PhotonPaths, photons); }
  vtkGetMacro(PhotonPaths, int);
  ///@}

  ///@{
  /**
   * Length of the data's length unit in metres, > 0: 0.001 for a model in millimetres. Default: 1.
   */
  vtkSetMacro(MetresPerUnit, double);
  vtkGetMacro(MetresPerUnit, double);
  ///@}

  ///@{
  /**
   * Angle between facets, degrees, [0, 180], above which their edge stays sharp where normals are
   * computed. It is used only for blocks without point normals. A point on a sharp edge gets the
   * mean of its sides' illuminances, weighted by area. Default: 30.
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
   * Largest factor by which compensation may raise a hit, [1, 1048576]. With VERTEX_NORMALISED the
   * factor is below 2 where a point normal is the area-weighted mean of the facets around the point
   * and none of them tilts by 60 degrees or more from it. With FACET_RATIO it may be any number.
   * FluxCutByWeightBound tells what was cut off. Default: 16.
   */
  vtkSetMacro(WeightBound, double);
  vtkGetMacro(WeightBound, double);
  ///@}

  ///@{
  /**
   * Number of segments after which a photon ends and is counted in PhotonsCutOff; >= 1. Default:
   * 10000, which no photon reaches if each surface absorbs 1 % or more.
   */
  vtkSetMacro(MaximumPathLength, int);
  vtkGetMacro(MaximumPathLength, int);
  ///@}

  ///@{
  /**
   * GiB of memory that the input's triangles, the run and its results may take together, >= 0; 0 is
   * what the machine has available (on Linux; no limit on other systems). What they need at most is
   * worked out when the input has been cut into triangles, which take about a tenth of it. A run
   * that needs more is refused before the rest is allocated; the cells of Final Gathering count
   * once there is a scene, and under a sky links between them as they are found. MemoryNeeded tells
   * the need. A run that goes on from what it has is not checked again. With CurvedSurface, facets
   * have no more parts than surely fit, at worst none, which Effects tells; a run that has fewer
   * for that reason does not go on with another limit. Default: 0.
   */
  virtual void SetMemoryLimit(double limit) { this->SetAndKeepRun(this->MemoryLimit, limit); }
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /**
   * Whether a window, which calls GetNeedsUpdate now and then, gets a first map of 65,536 photons
   * at once (by Final Gathering one of these photons alone, which Notes says), and a better one at
   * each doubling of the photons while the run goes on in the background. StoppedBy, of the field
   * data, then says that the run goes on. The last map has the bits of a run without this. Scripts,
   * which do not call GetNeedsUpdate, and several ranks get the last map alone. Default: on.
   */
  virtual void SetProgressive(bool on) { this->SetAndKeepRun(this->Progressive, on); }
  vtkGetMacro(Progressive, bool);
  vtkBooleanMacro(Progressive, bool);
  ///@}

  /**
   * Whether there is a better map than that of the last update, which the next update gives out. A
   * run that is not asked for a second pauses until it is asked again.
   */
  bool GetNeedsUpdate();

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
  int Method = PHOTON_TRACING;
  int GatherRays = 0;
  bool AdaptiveRefinement = false;
  double RefinementTolerance = 0.05;
  int MaximumCells = 1000000;
  int Registration = VERTEX_NORMALISED;
  vtkIdType Photons = 1000000;
  double PhotonsAsDouble = 1e6;
  double TargetRelativeError = 0.0;
  std::string AccuracyRegionArray;
  std::set<int> AccuracyRegionBlocks;
  bool CountFacetError = false;
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
  bool CurvedSurface = false;
  bool GroupMeans = true;
  int MaximumPhotons = 0;
  int PhotonPaths = 0;
  double MetresPerUnit = 1.0;
  double FeatureAngle = 30.0;
  int NumberOfThreads = 0;
  double WeightBound = 16.0;
  int MaximumPathLength = 10000;
  double MemoryLimit = 0.0;
  bool Progressive = true;

private:
  // Which need the scene and the light of a map.
  friend class vtkIlluminanceSensors;
  friend class vtkIlluminatedAppearance;
  vtkIlluminationMap(const vtkIlluminationMap&) = delete;
  void operator=(const vtkIlluminationMap&) = delete;

  using Luminaires = std::vector<Illumination::LuminaireInput>;

  // The properties in the core's terms; each throws for values out of range.
  PhotonTransport::Lighting MakeLighting(const Luminaires& luminaires);
  PhotonTransport::TraceSettings MakeTraceSettings();
  PhotonTransport::StopRules MakeStopRules();
  PhotonTransport::AdaptiveLimits MakeAdaptiveLimits();
  Illumination::SurfaceDescription DescribeSurface(bool otherLamps);
  std::uint64_t MemoryLimitInBytes(); ///< 0 for what the machine has.

  /// Adds the properties on which the scene and its light depend as field data.
  /// @param ownLamp Whether the light is that of the filter's own lamp.
  void RememberSettings(vtkFieldData* output, bool ownLamp);
  /// Sets them as they were when a map was made. @return Whether the field data hold any.
  bool RecallSettings(vtkFieldData* output, bool& ownLamp);

  /// The blocks of the output: those of the last execution if nothing has changed that they depend
  /// on. @param origins See PrepareRun; the last tells whether there are luminaires.
  std::shared_ptr<Illumination::SceneBlocks> BlocksOf(
    vtkDataObject* output, const std::vector<vtkMTimeType>& origins);
  /// Builds the scene and a run on it, unless the kept run can go on to so many photons and be that
  /// of the lighting.
  /// @param origins When data and filter last changed.
  void PrepareRun(const Illumination::SceneBlocks& blocks,
    const PhotonTransport::Lighting& lighting, std::vector<vtkMTimeType> origins,
    std::uint64_t photons);
  void MakeRun(const Illumination::SceneBlocks& blocks, const PhotonTransport::Lighting& lighting,
    const PhotonTransport::TraceSettings& settings, std::vector<vtkMTimeType> origins);
  PhotonTransport::StopReason AdvanceRun(
    const PhotonTransport::StopRules& rules, const std::vector<double>& region);
  void StartBackground(PhotonTransport::StopRules rules);
  void StopBackground();
  /// The map of the kept run on a refined surface; nothing if that is not asked for.
  std::optional<PhotonTransport::RefinedMap> RefineMap(const Illumination::SceneBlocks& blocks);
  /// Puts what the kept run has found into the outputs, and warns of what is amiss.
  void WriteMap(const Illumination::SceneBlocks& blocks, const PhotonTransport::Lighting& lighting,
    PhotonTransport::StopReason reason, vtkInformationVector* outputs);

  /// Fills the third and the fourth output.
  void WritePhotons(const Illumination::SceneBlocks& blocks,
    const PhotonTransport::Lighting& lighting, vtkInformationVector* outputs);

  template <typename Value>
  void SetAndKeepRun(Value& property, Value value)
  {
    if (property != value)
    {
      property = value;
      this->Superclass::Modified();
    }
  }

  std::unique_ptr<Illumination::KeptRun> Kept; ///< To go on from.
  std::unique_ptr<Illumination::LuminaireCache> LampsRead;
  bool IsWatched = false;  ///< By a window, which asks whether there is a better map.
  vtkTimeStamp RunChanged; ///< When something changed that a run can't go on after.
};

#endif
