// The bar that is in the same place on every page: authority, who is in command since when, hold, back to 100 %.
#pragma once

#include <QWidget>
#include <array>

#include "core/model/operator_input.h"
#include "ui/base/themed.h"
#include "ui/models/strip_view.h"

namespace stillcut::ui {

class TextPainter;
class TouchButton;

class CommandBar : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit CommandBar(QWidget* parent = nullptr);

  // `nowMs`: the screen's own clock; the question for a second touch is withdrawn after a few seconds.
  void display(const CommandView& view, qint64 nowMs);
  // On pages that show neither verdict nor advice, the bar does: no alarm and no question goes unseen.
  void setTellsVerdict(bool tells);
  const CommandView& view() const { return view_; }
  // Esc. True: it was asking for a second touch.
  bool withdrawAsked();
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void asked(const stillcut::OperatorInput& input);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void touchAuthority(Authority authority);
  void touchAuto();
  void withdrawQuestion();
  void showButtons();
  void placeButtons();
  void paintVerdict(TextPainter& text, QPainter& p, const QRectF& box) const;

  Theme theme_;
  CommandView view_;
  std::array<TouchButton*, 3> authority_;
  TouchButton* hold_;
  TouchButton* back_;
  TouchButton* accept_;  // of an advice that waits, where the page has no button for it
  qint64 nowMs_ = 0;
  qint64 askedMs_ = -1;   // when the second touch was asked for; -1: not asking
  qint64 touchedMs_ = 0;  // AUTO, last
  bool tellsVerdict_ = false;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
