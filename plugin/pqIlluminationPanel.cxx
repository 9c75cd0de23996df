// SPDX-License-Identifier: BSD-3-Clause
#include "pqIlluminationPanel.h"

#include "pqLampHandle.h"
#include "pqPanelLabel.h"

#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"

#include <cstring>

pqPropertyWidget* pqIlluminationPanel::createWidgetForPropertyGroup(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
{
  const char* kind = group->GetPanelWidget();
  return kind && std::strcmp(kind, "LampHandle") == 0 ? new pqLampHandle(proxy, group, parent)
                                                      : nullptr;
}

void pqIlluminationPanel::createDefaultWidgetDecorators(pqPropertyWidget* widget)
{
  vtkPVXMLElement* hints = widget->property() ? widget->property()->GetHints() : nullptr;
  if (hints &&
    (hints->FindNestedElementByName("PanelLabel") || hints->FindNestedElementByName("ReplacedBy")))
  {
    new pqPanelLabel(hints, widget);
  }
}
