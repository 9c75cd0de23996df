// SPDX-License-Identifier: BSD-3-Clause
// The label of a property in ParaView's panel, with its unit.
#ifndef pqPanelLabel_h
#define pqPanelLabel_h

#include "pqPropertyWidgetDecorator.h"

#include "vtkSMProperty.h"
#include "vtkWeakPointer.h"

#include <QString>

#include <utility>
#include <vector>

class QLabel;

class pqPanelLabel : public pqPropertyWidgetDecorator
{
  Q_OBJECT

public:
  /// @param hints The property's hints, see pqIlluminationPanel.h.
  pqPanelLabel(vtkPVXMLElement* hints, pqPropertyWidget* parent);
  ~pqPanelLabel() override;

  /// ParaView asks whenever it lays the panel out anew, so the label is set here.
  bool canShowWidget(bool showAdvanced) const override;
  bool enableWidget() const override;

  /// "Lamp Radius (m)": of an entry in the hints, or of a property by itself.
  static QString textOf(vtkPVXMLElement* entry, vtkSMProperty* property);

private:
  void observe(const char* name);
  bool isReplaced() const;
  vtkPVXMLElement* entry() const;
  QLabel* label() const;

  std::vector<std::pair<vtkWeakPointer<vtkSMProperty>, unsigned long>> Observed;
  mutable QString Shown; ///< What the label was set to.
};

#endif
