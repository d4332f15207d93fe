// What to do: the target, its reason, what follows and what it costs, and the two answers.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/models/advice_view.h"

namespace stillcut::ui {

class TouchButton;

class AdvicePanel : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit AdvicePanel(QWidget* parent = nullptr);

  void display(const AdviceView& view);
  const AdviceView& view() const { return view_; }
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override { return minimumSizeHint(); }

 signals:
  void accepted();
  void againAsked();
  void refused();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void placeButtons();

  Theme theme_;
  AdviceView view_;
  TouchButton* accept_;
  TouchButton* refuse_;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
