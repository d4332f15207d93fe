// The nine triangular sets of a fuzzy strategy over the normalised error: each from its left neighbour's peak to its
// right neighbour's. GUI thread.
#pragma once

#include <QWidget>
#include <array>

#include "ui/base/themed.h"

namespace stillcut::ui {

class MembershipPlot : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit MembershipPlot(QWidget* parent = nullptr);

  // Peaks of small, medium and big, 0 .. 1.
  void display(const std::array<double, 3>& centres);
  // Of the nine sets, -1 .. 1.
  std::array<double, 9> peaks() const;

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override { return {theme_.px(420), theme_.px(110)}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  std::array<double, 3> centres_{0.25, 0.5, 0.75};
};

}  // namespace stillcut::ui
