// SPDX-License-Identifier: BSD-3-Clause
// The label of a property in ParaView's panel, with its unit.
#ifndef pqPanelLabel_h
#define pqPanelLabel_h

#include "pqObservedProperties.h"
#include "pqPropertyWidgetDecorator.h"

#include "vtkSMProperty.h"

#include <QString>

class QLabel;

class pqPanelLabel : public pqPropertyWidgetDecorator
{
  Q_OBJECT

public:
  /// @param hints The property's hints, see pqIlluminationPanel.h.
  pqPanelLabel(vtkPVXMLElement* hints, pqPropertyWidget* parent);

  /// ParaView asks whenever it lays the panel out anew, so the label is set here.
  bool canShowWidget(bool showAdvanced) const override;
  bool enableWidget() const override;

  /// "Lamp Radius (m)": of an entry in the hints, or of a property by itself.
  static QString textOf(vtkPVXMLElement* entry, vtkSMProperty* property);

  /// Whether an entry of the hints holds: its property has one of its values, or none of those that
  /// are excepted, or it asks for no property.
  static bool holds(vtkPVXMLElement* entry, vtkSMProxy* proxy);

private:
  bool isReplaced() const;
  vtkPVXMLElement* entry() const;
  QLabel* label() const;

  pqObservedProperties Observed;
  mutable QString Shown; ///< What the label was set to.
};

#endif
