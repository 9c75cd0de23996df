// SPDX-License-Identifier: BSD-3-Clause
#include "pqLampSizeHandles.h"

#include "pqPanelLabel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkAbstractWidget.h"
#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkHandleRepresentation.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkPointHandleRepresentation3D.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkSMNewWidgetRepresentationProxy.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include "PhotonTransport/geometry/Frame.h"

#include <QString>
#include <QStringList>

#include <glm/geometric.hpp>

#include <cmath>

namespace
{

constexpr unsigned MostLengths = 2;

glm::dvec3 VectorOf(vtkSMProperty* property)
{
  const vtkSMUncheckedPropertyHelper value(property);
  return { value.GetAsDouble(0), value.GetAsDouble(1), value.GetAsDouble(2) };
}

/// Those along which the lamp's width and height lie; see PanelLamps in the core.
std::vector<glm::dvec3> AxesOf(const QString& names, const glm::dvec3& direction)
{
  const PhotonTransport::Frame frame{ glm::vec3(direction) };
  std::vector<glm::dvec3> axes;
  for (const QString& name : names.split(' '))
  {
    axes.emplace_back(name == "tangent" ? frame.tangent
        : name == "bitangent"           ? frame.bitangent
                                        : frame.normal);
  }
  return axes;
}

vtkHandleRepresentation* RepresentationOf(vtkSMNewWidgetRepresentationProxy* handle)
{
  vtkAbstractWidget* widget = handle->GetWidget();
  return widget ? vtkHandleRepresentation::SafeDownCast(widget->GetRepresentation()) : nullptr;
}

/// Makes a handle visible behind walls, as lamps are in rooms that are seen from outside, and gives
/// it the mouse before the lamp's ring, which may lie around it.
void Prepare(vtkSMNewWidgetRepresentationProxy* handle)
{
  constexpr float FirstOfAll = 1.0f;
  constexpr double Before = -66000.0; ///< Units of depth, as ParaView's handle of a plane has.
  handle->GetWidget()->SetPriority(FirstOfAll);
  auto* cross = vtkPointHandleRepresentation3D::SafeDownCast(RepresentationOf(handle));
  if (!cross)
  {
    return;
  }
  cross->SetHandleSize(15.0);
  cross->GetProperty()->SetColor(1.0, 0.0, 0.0);
  cross->GetProperty()->SetLineWidth(4.0f);
  cross->GetSelectedProperty()->SetLineWidth(4.0f);
  vtkNew<vtkPropCollection> actors;
  cross->GetActors(actors);
  actors->InitTraversal();
  while (vtkProp* prop = actors->GetNextProp())
  {
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    if (actor && actor->GetMapper())
    {
      actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
      actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, Before);
    }
  }
}

} // namespace

pqLampSizeHandles::pqLampSizeHandles(
  vtkPVXMLElement* hints, vtkSMPropertyGroup* group, vtkSMProxy* lamp, QObject* parent)
  : QObject(parent)
  , Hints(hints)
  , Group(group)
  , Lamp(lamp)
{
  const auto observe = [this](vtkSMProperty* property)
  { this->Observed.add(property, this, &pqLampSizeHandles::follow); };
  observe(group->GetProperty("Origin"));
  observe(group->GetProperty("Normal"));
  for (unsigned i = 0; i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(i);
    if (QString(hint->GetName()) == "SizeHandles")
    {
      observe(lamp->GetProperty(hint->GetAttributeOrEmpty("size")));
      observe(lamp->GetProperty(hint->GetAttributeOrEmpty("property")));
    }
  }
  BEGIN_UNDO_EXCLUDE();
  for (unsigned i = 0; i < MostLengths; ++i)
  {
    vtkSmartPointer<vtkSMProxy> made;
    made.TakeReference(
      lamp->GetSessionProxyManager()->NewProxy("representations", "HandleWidgetRepresentation"));
    Handle handle = vtkSMNewWidgetRepresentationProxy::SafeDownCast(made);
    vtkNew<vtkSMParaViewPipelineController> controller;
    controller->InitializeProxy(handle);
    handle->UpdateVTKObjects();
    handle->PrototypeOn(); // so that undo does not see it
    Prepare(handle);
    handle->AddObserver(vtkCommand::InteractionEvent, this, &pqLampSizeHandles::drag);
    handle->AddObserver(vtkCommand::EndInteractionEvent, this, &pqLampSizeHandles::release);
    this->Handles.push_back(handle);
  }
  END_UNDO_EXCLUDE();
}

pqLampSizeHandles::~pqLampSizeHandles()
{
  this->setView(nullptr);
  for (const Handle& handle : this->Handles)
  {
    handle->RemoveObservers(vtkCommand::InteractionEvent);
    handle->RemoveObservers(vtkCommand::EndInteractionEvent);
  }
}

void pqLampSizeHandles::setView(pqView* view)
{
  for (const Handle& handle : this->Handles)
  {
    // Quiet, since a view of another kind, such as a chart, has no such property.
    if (this->View)
    {
      vtkSMPropertyHelper(this->View->getProxy(), "HiddenRepresentations", true).Remove(handle);
      this->View->getProxy()->UpdateVTKObjects();
    }
    if (view)
    {
      vtkSMPropertyHelper(view->getProxy(), "HiddenRepresentations", true).Add(handle);
      view->getProxy()->UpdateVTKObjects();
    }
  }
  this->View = view;
  this->follow();
}

void pqLampSizeHandles::setVisible(bool visible)
{
  this->Visible = visible;
  this->follow();
}

glm::dvec3 pqLampSizeHandles::centre() const
{
  return VectorOf(this->Group->GetProperty("Origin"));
}

pqLampSizeHandles::Use pqLampSizeHandles::use() const
{
  const glm::dvec3 direction = VectorOf(this->Group->GetProperty("Normal"));
  const double length = glm::length(direction);
  for (unsigned i = 0; i < this->Hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* hint = this->Hints->GetNestedElement(i);
    vtkSMProperty* size = this->Lamp->GetProperty(hint->GetAttributeOrEmpty("size"));
    if (QString(hint->GetName()) == "SizeHandles" && size && length > 0.0 &&
      pqPanelLabel::holds(hint, this->Lamp))
    {
      return { size, QString(hint->GetAttributeOrEmpty("share")).toDouble(),
        AxesOf(hint->GetAttributeOrEmpty("axes"), direction / length) };
    }
  }
  return {};
}

/// Places the handles where the values in the panel have them. One of length 0 is not shown, as it
/// would lie under the handle that moves the lamp.
void pqLampSizeHandles::follow()
{
  if (!this->Lamp || this->IsDragged)
  {
    return;
  }
  const Use use = this->use();
  for (std::size_t i = 0; i < this->Handles.size(); ++i)
  {
    vtkSMNewWidgetRepresentationProxy* handle = this->Handles[i];
    const double distance = i < use.axes.size()
      ? use.share * vtkSMUncheckedPropertyHelper(use.size).GetAsDouble(static_cast<unsigned>(i))
      : 0.0;
    const bool shown = this->Visible && this->View && std::isfinite(distance) && distance > 0.0;
    if (shown)
    {
      const glm::dvec3 place = this->centre() + distance * use.axes[i];
      vtkSMPropertyHelper(handle, "WorldPosition").Set(&place.x, 3);
      handle->UpdateProperty("WorldPosition", 1); // even if the view alone has moved it
    }
    vtkSMPropertyHelper(handle, "Visibility", true).Set(shown);
    vtkSMPropertyHelper(handle, "Enabled", true).Set(shown);
    handle->UpdateVTKObjects();
  }
  if (this->View)
  {
    this->View->render();
  }
}

/// Takes the lengths from where the handles are; one of the two has been dragged.
void pqLampSizeHandles::drag()
{
  const Use use = this->use();
  this->IsDragged = true;
  for (std::size_t i = 0; i < use.axes.size(); ++i)
  {
    vtkHandleRepresentation* place = RepresentationOf(this->Handles[i]);
    if (place && vtkSMPropertyHelper(this->Handles[i], "Visibility", true).GetAsInt() != 0)
    {
      glm::dvec3 at;
      place->GetWorldPosition(&at.x);
      vtkSMUncheckedPropertyHelper(use.size).Set(
        static_cast<unsigned>(i), std::abs(glm::dot(at - this->centre(), use.axes[i])) / use.share);
    }
  }
  this->IsDragged = false;
  Q_EMIT this->changeAvailable();
}

void pqLampSizeHandles::release()
{
  this->follow(); // back to the axis
  Q_EMIT this->changeFinished();
}
