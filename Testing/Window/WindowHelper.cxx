// SPDX-License-Identifier: BSD-3-Clause
// Lets a Python script that runs in ParaView use its window as a user does. The script loads this
// library by ctypes (window.py). Widgets and actions go by the names that ParaView's own tests use.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPixmap>
#include <QRegularExpression>
#include <QScreen>
#include <QStringList>
#include <QThread>
#include <QWidget>

namespace
{

QMainWindow* MainWindow()
{
  for (QWidget* widget : QApplication::topLevelWidgets())
  {
    if (auto* window = qobject_cast<QMainWindow*>(widget))
    {
      return window;
    }
  }
  return nullptr;
}

QWidget* Panel()
{
  return MainWindow()->findChild<QWidget*>("propertiesPanel");
}

} // namespace

extern "C"
{
  /// Lets the window do what it has to do, for so many milliseconds.
  __attribute__((visibility("default"))) void window_wait(int milliseconds)
  {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds)
    {
      QApplication::processEvents(QEventLoop::AllEvents, 20);
      QThread::msleep(5);
    }
  }

  __attribute__((visibility("default"))) void window_resize(int width, int height)
  {
    MainWindow()->setGeometry(0, 0, width, height);
  }

  /// Of the panel of properties and what stands above it.
  __attribute__((visibility("default"))) void window_panel_width(int width)
  {
    MainWindow()->resizeDocks(
      { MainWindow()->findChild<QDockWidget*>("propertiesDock") }, { width }, Qt::Horizontal);
  }

  /// @return 1: triggered, 0: there is no such action, -1: it is disabled.
  __attribute__((visibility("default"))) int window_trigger(const char* action)
  {
    auto* found = MainWindow()->findChild<QAction*>(action);
    if (!found || !found->isEnabled())
    {
      return found ? -1 : 0;
    }
    found->trigger();
    return 1;
  }

  /// @param button Its name, or the text of one in the properties panel. @return As of
  /// window_trigger.
  __attribute__((visibility("default"))) int window_click(const char* button)
  {
    auto* found = MainWindow()->findChild<QAbstractButton*>(button);
    for (auto* other : Panel()->findChildren<QAbstractButton*>())
    {
      found = found || other->text() != button || !other->isVisible() ? found : other;
    }
    if (!found || !found->isEnabled())
    {
      return found ? -1 : 0;
    }
    found->click();
    return 1;
  }

  /// Types into a line edit of a property's widget.
  __attribute__((visibility("default"))) int window_enter(
    const char* property, int number, const char* text)
  {
    auto* widget = Panel()->findChild<QWidget*>(property);
    const auto edits = widget ? widget->findChildren<QLineEdit*>() : QList<QLineEdit*>();
    if (number >= edits.size() || !edits[number]->isVisible())
    {
      return 0;
    }
    edits[number]->setText(text);
    QMetaObject::invokeMethod(edits[number], "editingFinished");
    return 1;
  }

  /// Whether an action has a picture.
  __attribute__((visibility("default"))) int window_has_icon(const char* action)
  {
    auto* found = MainWindow()->findChild<QAction*>(action);
    return found && !found->icon().pixmap(16, 16).isNull() ? 1 : 0;
  }

  /// The visible labels of the properties panel, one a line. Valid until the next call.
  __attribute__((visibility("default"))) const char* window_labels()
  {
    static QByteArray text;
    QStringList lines;
    for (QLabel* label : Panel()->findChildren<QLabel*>())
    {
      if (label->isVisible())
      {
        lines << label->text()
                   .remove(QRegularExpression("<[^>]*>"))
                   .replace('\n', ' ')
                   .replace("&#39;", "'");
      }
    }
    text = lines.join('\n').toUtf8();
    return text.constData();
  }

  /// Whether a widget of the properties panel is there, visible and enabled.
  __attribute__((visibility("default"))) int window_offers(const char* widget)
  {
    for (QWidget* found : Panel()->findChildren<QWidget*>(widget))
    {
      if (found->isVisible() && found->isEnabled())
      {
        return 1;
      }
    }
    return 0;
  }

  /// The whole screen as a PNG file.
  __attribute__((visibility("default"))) int window_picture(const char* file)
  {
    return QApplication::primaryScreen()->grabWindow(0).save(file, "PNG", 0) ? 1 : 0; // smallest
  }

  __attribute__((visibility("default"))) void window_close()
  {
    QApplication::closeAllWindows();
  }
}
