// The one verdict, readable at three metres: shape, word and colour, then frequency, kind, time and length in chatter.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/models/verdict_view.h"

namespace stillcut::ui {

class VerdictSign : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit VerdictSign(QWidget* parent = nullptr);

  void display(const VerdictView& view);
  const VerdictView& view() const { return view_; }
  // Whether the last painting had to cut text off.
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override { return minimumSizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  VerdictView view_;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
