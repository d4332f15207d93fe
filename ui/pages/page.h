// What every page of the window is. A page wires itself, shows pictures and asks by signals; it knows neither the
// window nor the session, and what it needs beyond the picture it is given as an interface (ui/models) when it is made.
// How to add one: ADDING.md beside this file. GUI thread.
#pragma once

#include <QWidget>

#include "core/model/operator_input.h"
#include "ui/base/themed.h"
#include "ui/facade/session_info.h"

class QSettings;

namespace stillcut::ui {

class Page : public QWidget, public Themed {
  Q_OBJECT
 public:
  using QWidget::QWidget;

  // Every display tick, on screen or not: takes in what must not be missed. Cheap.
  virtual void see(const Picture& picture) { static_cast<void>(picture); }
  // Every display tick while the page is on screen, after see().
  virtual void display(const Picture& picture) = 0;
  // Another cut, replay or machine was opened: what was seen of the one before is forgotten.
  virtual void restart() {}
  // Closes what lies over the page, if anything does.
  virtual bool closeTop() { return false; }
  // A file that somebody wants to look at, on a page that shows files; empty: it asks which.
  virtual void openFile(const QString& path) { static_cast<void>(path); }
  // What outlives a restart: its own group of the settings. Who has something to keep emits stateChanged().
  virtual void keep(QSettings& settings) const { static_cast<void>(settings); }
  virtual void restore(const QSettings& settings) { static_cast<void>(settings); }

 signals:
  // Shows another page of the window, by its id.
  void pageAsked(const QString& id);
  // A recording is to be looked at as a whole; empty: the page for that asks which.
  void fileAsked(const QString& path);
  // A part of the manual, as its chapters link to each other.
  void manualAsked(const QString& link);
  void asked(const stillcut::OperatorInput& input);
  // What has ended is to be run once more.
  void againAsked();
  // What keep() writes has changed: it is on the disk a second later, whatever becomes of the program.
  void stateChanged();
};

}  // namespace stillcut::ui
