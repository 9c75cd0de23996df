// SPDX-License-Identifier: BSD-3-Clause
#include "pqIlluminationStart.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqObjectBuilder.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqView.h"

#include "vtkBoundingBox.h"
#include "vtkClientServerStream.h"
#include "vtkPVDataInformation.h"
#include "vtkPVSession.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace
{

using Values = std::vector<double>;

struct UnitOfArray
{
  const char* array;
  const char* unit;
};

/// Arrays whose names other data hardly have.
const UnitOfArray Units[] = { { "Illuminance", "lx" }, { "IlluminanceDirect", "lx" },
  { "IlluminanceIndirect", "lx" }, { "IlluminanceCaustic", "lx" }, { "IlluminanceBack", "lx" },
  { "IlluminanceRGB", "lx" }, { "IlluminanceSmoothed", "lx" },
  { "IlluminanceDirectSmoothed", "lx" }, { "IlluminanceIndirectSmoothed", "lx" },
  { "StandardErrorBack", "lx" }, { "StandardErrorSmoothed", "lx" }, { "FacetError", "lx" },
  { "HorizontalIlluminance", "lx" }, { "VerticalIlluminance", "lx" },
  { "CylindricalIlluminance", "lx" }, { "SemicylindricalIlluminance", "lx" },
  { "HemisphericalIlluminance", "lx" }, { "SphericalIlluminance", "lx" },
  { "Luminance", "cd/m\u00B2" }, { "LuminanceRGB", "cd/m\u00B2" }, { "LuminousIntensity", "cd" },
  { "DaylightFactor", "%" } };

/// ParaView looks for the title of an array's colour bar in its settings.
std::string TitlesOfColourBars()
{
  std::string titles;
  for (const UnitOfArray& of : Units)
  {
    titles += (titles.empty() ? "" : ", ") + std::string("\"") + of.array + "\": {\"Title\": \"" +
      of.array + " (" + of.unit + ")\"}";
  }
  return "{\"array_lookup_tables\": {" + titles + "}}";
}

Values Read(vtkSMProxy* proxy, const char* name)
{
  return vtkSMPropertyHelper(proxy, name).GetDoubleArray();
}

/// Sets what neither a script nor the user's own defaults have set.
void SetIfDefault(vtkSMProxy* proxy, const char* name, const Values& values)
{
  vtkSMProperty* property = proxy->GetProperty(name);
  if (!property || !property->IsValueDefault())
  {
    return;
  }
  vtkSMPropertyHelper helper(property);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    helper.Set(static_cast<unsigned>(i), values[i]);
  }
}

/// Of the active view.
vtkBoundingBox BoundsOfVisibleData(vtkSMSessionProxyManager* manager)
{
  vtkBoundingBox box;
  vtkSMProxySelectionModel* active = manager->GetSelectionModel("ActiveView");
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  auto* view = active ? model->findItem<pqView*>(active->GetCurrentProxy()) : nullptr;
  if (!view)
  {
    return box;
  }
  for (pqRepresentation* representation : view->getRepresentations())
  {
    auto* data = qobject_cast<pqDataRepresentation*>(representation);
    vtkPVDataInformation* information =
      data && data->isVisible() ? data->getInputDataInformation() : nullptr;
    if (information)
    {
      box.AddBounds(information->GetBounds());
    }
  }
  return box;
}

} // namespace

void pqIlluminationStart::onStartup()
{
  // Below the user's own settings, which have the greatest priority.
  vtkSMSettings::GetInstance()->AddCollectionFromString(TitlesOfColourBars(), 0.0);
  QObject::connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::sourceAdded, this, &pqIlluminationStart::watchMap);
  const pqObjectBuilder* builder = pqApplicationCore::instance()->getObjectBuilder();
  QObject::connect(
    builder, &pqObjectBuilder::filterCreated, this, &pqIlluminationStart::placeOwnLamp);
  QObject::connect(
    builder, &pqObjectBuilder::sourceCreated, this, &pqIlluminationStart::placeLuminaire);
}

/// Tells a map that there is a window, which ParaView does now and then, but maybe not before the
/// map's first execution.
void pqIlluminationStart::watchMap(pqPipelineSource* filter)
{
  vtkSMProxy* proxy = filter->getProxy();
  if (std::string(proxy->GetXMLName()) == "IlluminationMap")
  {
    vtkClientServerStream ask;
    ask << vtkClientServerStream::Invoke << VTKOBJECT(proxy) << "GetNeedsUpdate"
        << vtkClientServerStream::End;
    proxy->GetSession()->ExecuteStream(vtkPVSession::DATA_SERVER_ROOT, ask);
  }
}

void pqIlluminationStart::placeOwnLamp(pqPipelineSource* filter)
{
  vtkSMProxy* proxy = filter->getProxy();
  if (std::string(proxy->GetXMLName()) != "IlluminationMap")
  {
    return;
  }
  auto lamp = vtkSmartPointer<vtkSMProxy>::Take(
    proxy->GetSessionProxyManager()->NewProxy("internal_filters", "SuggestedLamp"));
  auto* suggestion = vtkSMSourceProxy::SafeDownCast(lamp);
  if (!suggestion)
  {
    return;
  }
  vtkSMPropertyHelper input(proxy, "Input");
  vtkSMPropertyHelper(suggestion, "Input").Set(input.GetAsProxy(), input.GetOutputPort());
  suggestion->UpdateVTKObjects();
  suggestion->UpdatePipeline();
  suggestion->UpdatePropertyInformation();
  const double size = Read(suggestion, "LampSize").at(0);

  SM_SCOPED_TRACE(PropertiesModified)
    .arg("proxy", proxy)
    .arg("comment", " a lamp that suits the input");
  SetIfDefault(proxy, "LampType", Read(suggestion, "LampType"));
  SetIfDefault(proxy, "LampPosition", Read(suggestion, "LampPosition"));
  SetIfDefault(proxy, "LampDirection", Read(suggestion, "LampDirection"));
  SetIfDefault(proxy, "LampSize", { size, size });
  proxy->UpdateVTKObjects();
}

void pqIlluminationStart::placeLuminaire(pqPipelineSource* source)
{
  vtkSMProxy* proxy = source->getProxy();
  if (std::string(proxy->GetXMLName()) != "Luminaire")
  {
    return;
  }
  const vtkBoundingBox box = BoundsOfVisibleData(proxy->GetSessionProxyManager());
  if (!box.IsValid() || !(box.GetDiagonalLength() > 0.0))
  {
    return;
  }
  // Below the ceiling of what is seen; above it if it is flat.
  const double diagonal = box.GetDiagonalLength();
  const double height = box.GetLength(2);
  const double bottom = box.GetBound(4);
  const double z = bottom + (height > 0.01 * diagonal ? 0.85 * height : 0.5 * diagonal);
  const double size = 0.05 * diagonal;
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy).arg("comment", " placed in what is seen");
  double centre[3];
  box.GetCenter(centre);
  SetIfDefault(proxy, "Position", { centre[0], centre[1], z });
  SetIfDefault(proxy, "Size", { size, size });
  SetIfDefault(proxy, "GlyphSize", { size });
  proxy->UpdateVTKObjects();
}
