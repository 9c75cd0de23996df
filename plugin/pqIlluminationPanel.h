// SPDX-License-Identifier: BSD-3-Clause
// What the plugin adds to ParaView's panel of properties, by hints in the XML:
//
//   <PanelLabel unit="lm"/>
//   <PanelLabel property="LampType" values="5" text="Lamp Radius" unit="m" fields="1"/>
//   <PanelLabel property="ReflectanceArray" except="None" text="Reflectance (off: there is an
//   array)"/> <ReplacedBy input="Luminaires" show="1"/>
//
// PanelLabel sets the label of a property, which the XML's attribute label can't do, since Python
// names the property by that (see pqPanelLabel). ReplacedBy hides a property while the input has a
// connection; with show="1" it stays, disabled, and the label names what replaces it. Without this
// part of the plugin the hints have no effect.
//
//   <SizeHandles property="LampType" values="4" size="LampSize" axes="tangent bitangent"
//   share="0.5"/>
//
// SizeHandles, of a group with panel_widget="LampHandle", gives a lamp of these kinds a handle for
// each of its lengths: so far from its centre along an axis as this share of the length. Axes are
// those of the core's Frame around the direction: tangent, bitangent, normal.
#ifndef pqIlluminationPanel_h
#define pqIlluminationPanel_h

#include "pqPropertyWidgetInterface.h"

#include <QObject>

class pqIlluminationPanel
  : public QObject
  , public pqPropertyWidgetInterface
{
  Q_OBJECT
  Q_INTERFACES(pqPropertyWidgetInterface)

public:
  explicit pqIlluminationPanel(QObject* parent)
    : QObject(parent)
  {
  }

  /// Of groups with panel_widget="LampHandle".
  pqPropertyWidget* createWidgetForPropertyGroup(
    vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent) override;

  /// Called for the widget of each property.
  void createDefaultWidgetDecorators(pqPropertyWidget* widget) override;
};

#endif
