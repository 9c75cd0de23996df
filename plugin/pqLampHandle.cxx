// SPDX-License-Identifier: BSD-3-Clause
#include "pqLampHandle.h"

#include "pqLampSizeHandles.h"
#include "pqPanelLabel.h"

#include "vtkCollection.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMNewWidgetRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QAbstractButton>
#include <QLabel>

namespace
{

constexpr double RingSize = 0.3; ///< Of ParaView's, which is for planes through all of the data.

/// Whether the decorators in a property's hints show it, as ParaView's GenericDecorator does.
bool IsShown(vtkSMProperty* property, vtkSMProxy* proxy)
{
  vtkNew<vtkCollection> decorators;
  if (vtkPVXMLElement* hints = property->GetHints())
  {
    hints->FindNestedElementByName("PropertyWidgetDecorator", decorators);
  }
  for (int i = 0; i < decorators->GetNumberOfItems(); ++i)
  {
    auto* decorator = vtkPVXMLElement::SafeDownCast(decorators->GetItemAsObject(i));
    vtkSMProperty* other = proxy->GetProperty(decorator->GetAttributeOrEmpty("property"));
    if (other && !pqPanelLabel::holds(decorator, proxy))
    {
      return false;
    }
  }
  return true;
}

} // namespace

pqLampHandle::pqLampHandle(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqDisplaySizedImplicitPlanePropertyWidget(proxy, group, parent)
{
  // The input is no property of the group, which would then stand first in the panel.
  if (vtkSMProperty* input = proxy->GetProperty("Input"))
  {
    this->setDataSource(vtkSMPropertyHelper(input).GetAsProxy());
  }
  vtkSMPropertyHelper(this->widgetProxy(), "RadiusMultiplier", true).Set(RingSize);
  this->setDrawOutlineAndIntersectionEdges(false);
  this->rename("show3DWidget", "Show Lamp Handle",
    "Show a ball and an arrow in the view, which move and turn the lamp.");
  this->rename("useXNormal", "Along &X", "Direct the light along +x.");
  this->rename("useYNormal", "Along &Y", "Direct the light along +y.");
  this->rename("useZNormal", "Along &Z", "Direct the light along +z.");
  this->rename("useCameraNormal", "As Camera", "Direct the light as the camera looks.");
  for (const char* name : { "showOutlineAndIntersectionEdges", "resetToDataBounds",
         "resetCameraToNormal", "resetRadiusSize", "pickLabel" })
  {
    if (auto* widget = this->findChild<QWidget*>(name))
    {
      widget->hide();
    }
  }
  this->label("labelOrigin", group->GetProperty("Origin"));
  this->label("labelNormal", group->GetProperty("Normal"));
  if (vtkPVXMLElement* hints = group->GetHints())
  {
    new pqPanelLabel(hints, this);
    this->SizeHandles = new pqLampSizeHandles(hints, group, proxy, this);
    this->connect(
      this->SizeHandles, &pqLampSizeHandles::changeAvailable, this, &pqLampHandle::changeAvailable);
    this->connect(
      this->SizeHandles, &pqLampSizeHandles::changeFinished, this, &pqLampHandle::changeFinished);
  }
}

void pqLampHandle::setView(pqView* view)
{
  this->pqDisplaySizedImplicitPlanePropertyWidget::setView(view);
  if (this->SizeHandles)
  {
    this->SizeHandles->setView(this->view());
  }
}

void pqLampHandle::updateWidgetVisibility()
{
  this->pqDisplaySizedImplicitPlanePropertyWidget::updateWidgetVisibility();
  if (this->SizeHandles)
  {
    this->SizeHandles->setVisible(this->isSelected() && this->isWidgetVisible());
  }
}

void pqLampHandle::rename(const char* widget, const QString& text, const QString& help)
{
  if (auto* button = this->findChild<QAbstractButton*>(widget))
  {
    button->setText(text);
    button->setToolTip(help);
  }
}

void pqLampHandle::label(const char* widget, vtkSMProperty* property)
{
  auto* label = this->findChild<QLabel*>(widget);
  if (label && property)
  {
    vtkPVXMLElement* hints = property->GetHints();
    const QString text = pqPanelLabel::textOf(
      hints ? hints->FindNestedElementByName("PanelLabel") : nullptr, property);
    label->setText(QString(text).replace(" (", "\n(")); // narrow, for the sake of the numbers
  }
}

void pqLampHandle::show(std::initializer_list<const char*> widgets, vtkSMProperty* property)
{
  const bool shown = property && IsShown(property, this->proxy());
  for (const char* name : widgets)
  {
    if (auto* widget = this->findChild<QWidget*>(name))
    {
      widget->setVisible(shown);
    }
  }
}

void pqLampHandle::updateWidget(bool showAdvanced)
{
  this->pqDisplaySizedImplicitPlanePropertyWidget::updateWidget(showAdvanced);
  this->show({ "labelOrigin", "originX", "originY", "originZ" },
    this->propertyGroup()->GetProperty("Origin"));
  this->show({ "labelNormal", "normalX", "normalY", "normalZ", "useXNormal", "useYNormal",
               "useZNormal", "useCameraNormal" },
    this->propertyGroup()->GetProperty("Normal"));
}
