// The head of the window: machine, tool, whether the machine is a simulated one, the pages, the display.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/base/themed.h"
#include "ui/facade/session_info.h"

namespace stillcut::ui {

class TouchButton;

class HeaderBar : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit HeaderBar(QWidget* parent = nullptr);

  void setSession(const SessionInfo& info);
  // `name`: the button's object name.
  void addPage(const QString& title, const QKeySequence& key, const QString& name);
  void setCurrentPage(int index);
  bool clipped() const override { return clipped_; }
  // Where it stands that the machine is a simulated one; empty: it is none. In two lines where one has no room.
  QRectF badgeBox() const { return badgeBox_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void pageAsked(int index);
  void displayAsked();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void placeButtons();
  double badgeWidth(bool oneLine) const;

  Theme theme_;
  QString machine_, tool_, badge_;
  std::vector<TouchButton*> pages_;
  TouchButton* displayButton_;
  QRectF badgeBox_;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
