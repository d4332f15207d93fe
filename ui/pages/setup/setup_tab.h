// One part of the Set up page. GUI thread.
#pragma once

#include "ui/base/themed.h"
#include "ui/facade/session_info.h"
#include "ui/models/setup_draft.h"
#include "ui/widgets/panel.h"

class QBoxLayout;
class QLineEdit;

namespace stillcut::ui {

class TextLabel;
class TouchButton;

class SetupTab : public Panel {
  Q_OBJECT
 public:
  SetupTab(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);

  // The draft or what the desk knows has changed.
  virtual void refresh() = 0;
  virtual void display(const Picture& /*picture*/) {}
  void applyTheme(const Theme& theme) override;

 signals:
  void tabAsked(int tab);
  void started();                         // another cut runs
  void fileAsked();                       // somebody wants to look at a recording
  void manualAsked(const QString& link);  // "hardware.md#microphone"

 protected:
  static TouchButton* makeButton(const QString& caption, const QString& spoken, const QString& name);
  QLineEdit* makeEdit(const QString& spoken, const QString& name);
  const Theme& theme() const { return theme_; }

  SetupController& controller_;
  SetupDraft& draft_;

 private:
  Theme theme_;
  std::vector<QLineEdit*> edits_;
};

// What the program can be told of a first run, and what is still missing; ends in a running cut.
class SetupGuide : public SetupTab {
  Q_OBJECT
 public:
  SetupGuide(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;

 private:
  std::vector<TouchButton*> steps_;
  TextLabel* note_;
  TouchButton* begin_;
};

}  // namespace stillcut::ui
