// SPDX-License-Identifier: BSD-3-Clause
// A handle for the place and the direction of a lamp, which is dragged in the view: ParaView's
// handle of a plane, whose origin and normal they are.
#ifndef pqLampHandle_h
#define pqLampHandle_h

#include "pqDisplaySizedImplicitPlanePropertyWidget.h"

#include <initializer_list>

class pqLampSizeHandles;

/// The group has a property of the function Origin and one of the function Normal. Of hints for the
/// group see pqIlluminationPanel.h; a property's row is hidden where its own decorators say so.
class pqLampHandle : public pqDisplaySizedImplicitPlanePropertyWidget
{
  Q_OBJECT

public:
  pqLampHandle(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent);

  void updateWidget(bool showAdvanced) override;
  void setView(pqView* view) override;

protected:
  void updateWidgetVisibility() override;

private:
  void rename(const char* widget, const QString& text, const QString& help);
  void label(const char* widget, vtkSMProperty* property);
  void show(std::initializer_list<const char*> widgets, vtkSMProperty* property);

  pqLampSizeHandles* SizeHandles = nullptr; ///< Null for lamps without a size.
};

#endif
