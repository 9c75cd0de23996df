// SPDX-License-Identifier: BSD-3-Clause
// Handles for the size of a lamp, which are dragged in the view.
#ifndef pqLampSizeHandles_h
#define pqLampSizeHandles_h

#include "pqObservedProperties.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <QObject>
#include <QPointer>

#include <glm/vec3.hpp>

#include <vector>

class pqView;
class vtkPVXMLElement;
class vtkSMNewWidgetRepresentationProxy;
class vtkSMProperty;
class vtkSMPropertyGroup;
class vtkSMProxy;

/// Up to two points that are dragged along axes of a lamp. How far one is from the lamp's centre is
/// a share of a length, by hints of the group; see pqIlluminationPanel.h.
class pqLampSizeHandles : public QObject
{
  Q_OBJECT

public:
  /// @param group With the properties of the functions Origin, the centre, and Normal, the
  /// direction. Lengths and directions are the values in the panel, which may not be applied yet.
  pqLampSizeHandles(
    vtkPVXMLElement* hints, vtkSMPropertyGroup* group, vtkSMProxy* lamp, QObject* parent);
  ~pqLampSizeHandles() override;

  void setView(pqView* view);
  void setVisible(bool visible);

Q_SIGNALS:
  void changeAvailable();
  void changeFinished();

private:
  using Handle = vtkSmartPointer<vtkSMNewWidgetRepresentationProxy>;
  /// How the lamp's present kind uses its size.
  struct Use
  {
    vtkSMProperty* size = nullptr;
    double share = 1.0;
    std::vector<glm::dvec3> axes; ///< One for each length, unit.
  };

  Use use() const;
  glm::dvec3 centre() const;
  void follow();
  void drag();
  void release();

  vtkPVXMLElement* Hints;
  vtkSmartPointer<vtkSMPropertyGroup> Group;
  vtkWeakPointer<vtkSMProxy> Lamp;
  std::vector<Handle> Handles;
  pqObservedProperties Observed;
  QPointer<pqView> View;
  bool Visible = false;
  bool IsDragged = false;
};

#endif
