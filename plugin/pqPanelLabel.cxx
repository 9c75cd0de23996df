// SPDX-License-Identifier: BSD-3-Clause
#include "pqPanelLabel.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"

#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStringList>

namespace
{

/// The names in the pipeline browser of what is connected to an input.
QStringList Connected(vtkSMProperty* input)
{
  QStringList names;
  vtkSMUncheckedPropertyHelper helper(input);
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (unsigned i = 0; i < helper.GetNumberOfElements(); ++i)
  {
    if (auto* source = model->findItem<pqPipelineSource*>(helper.GetAsProxy(i)))
    {
      names << source->getSMName();
    }
  }
  return names;
}

/// Shows as many fields of a property of several as the lamp has use for.
void ShowFields(pqPropertyWidget* widget, const char* number)
{
  const QList<QLineEdit*> fields = widget->findChildren<QLineEdit*>();
  const int used = number ? QString(number).toInt() : static_cast<int>(fields.size());
  for (int i = 0; i < fields.size(); ++i)
  {
    fields[i]->setVisible(i < used);
  }
}

} // namespace

pqPanelLabel::pqPanelLabel(vtkPVXMLElement* hints, pqPropertyWidget* parent)
  : pqPropertyWidgetDecorator(hints, parent)
{
  for (unsigned i = 0; i < hints->GetNumberOfNestedElements(); ++i)
  {
    for (const char* name : { "property", "input" })
    {
      this->Observed.add(
        parent->proxy()->GetProperty(hints->GetNestedElement(i)->GetAttributeOrEmpty(name)), this,
        &pqPanelLabel::visibilityChanged);
    }
  }
}

bool pqPanelLabel::holds(vtkPVXMLElement* entry, vtkSMProxy* proxy)
{
  const char* name = entry->GetAttribute("property");
  vtkSMProperty* property = name ? proxy->GetProperty(name) : nullptr;
  if (!property)
  {
    return name == nullptr;
  }
  const QString value = vtkSMUncheckedPropertyHelper(property).GetAsVariant(0).ToString().c_str();
  if (const char* excepted = entry->GetAttribute("except"))
  {
    return !QString(excepted).split(' ').contains(value);
  }
  return QString(entry->GetAttributeOrEmpty("values")).split(' ').contains(value);
}

QString pqPanelLabel::textOf(vtkPVXMLElement* entry, vtkSMProperty* property)
{
  const char* text = entry ? entry->GetAttribute("text") : nullptr;
  const char* unit = entry ? entry->GetAttribute("unit") : nullptr;
  const QString name = text ? text : property->GetXMLLabel();
  return unit ? QString("%1 (%2)").arg(name, QString::fromUtf8(unit)) : name;
}

vtkPVXMLElement* pqPanelLabel::entry() const
{
  vtkPVXMLElement* last = nullptr;
  for (unsigned i = 0; i < this->xml()->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = this->xml()->GetNestedElement(i);
    if (QString(element->GetName()) == "PanelLabel" &&
      pqPanelLabel::holds(element, this->parentWidget()->proxy()))
    {
      last = element;
    }
  }
  return last;
}

/// The one in front of the widget. There is none where a panel has its labels as widgets' parts.
QLabel* pqPanelLabel::label() const
{
  QWidget* panel = this->parentWidget()->parentWidget();
  auto* grid = panel ? qobject_cast<QGridLayout*>(panel->layout()) : nullptr;
  const int index = grid ? grid->indexOf(this->parentWidget()) : -1;
  if (index < 0)
  {
    return nullptr;
  }
  int row = 0;
  int column = 0;
  int rows = 0;
  int columns = 0;
  grid->getItemPosition(index, &row, &column, &rows, &columns);
  QLayoutItem* item = column > 0 ? grid->itemAtPosition(row, 0) : nullptr;
  return item ? qobject_cast<QLabel*>(item->widget()) : nullptr;
}

bool pqPanelLabel::isReplaced() const
{
  vtkPVXMLElement* hint = this->xml()->FindNestedElementByName("ReplacedBy");
  vtkSMProperty* input =
    hint ? this->parentWidget()->proxy()->GetProperty(hint->GetAttribute("input")) : nullptr;
  return input && !Connected(input).isEmpty();
}

bool pqPanelLabel::canShowWidget(bool) const
{
  vtkSMProperty* property = this->parentWidget()->property();
  vtkPVXMLElement* hint = this->xml()->FindNestedElementByName("ReplacedBy");
  const bool replaced = this->isReplaced();
  if (QLabel* label = property ? this->label() : nullptr)
  {
    vtkPVXMLElement* entry = this->entry();
    QString text = pqPanelLabel::textOf(entry, property);
    if (replaced)
    {
      vtkSMProperty* input =
        this->parentWidget()->proxy()->GetProperty(hint->GetAttribute("input"));
      text = QString("%1 (off: %2 are connected: %3)")
               .arg(text, input->GetXMLLabel(), Connected(input).join(", "));
    }
    if (this->Shown != text)
    {
      label->setText(QString("<p>%1</p>").arg(text.toHtmlEscaped()));
      this->Shown = text;
    }
    ShowFields(this->parentWidget(), entry ? entry->GetAttribute("fields") : nullptr);
  }
  return !replaced || hint->GetAttribute("show");
}

bool pqPanelLabel::enableWidget() const
{
  return !this->isReplaced();
}
