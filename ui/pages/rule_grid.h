// The rule table of a fuzzy strategy: nine sets of the error down, nine of its change across, what each rule asks for,
// and beneath it what learning has made of it. A cell is chosen by touch or arrow keys, plus and minus change it,
// Delete brings back what the paper prints. Knows no parameter. GUI thread.
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>

#include "core/model/rule_tables.h"
#include "ui/base/themed.h"

namespace stillcut::ui {

// The names of the nine sets, "NX" .. "PX", and of the singletons 1 .. 9.
QStringList ruleSetNames();

struct RuleCell {
  double rule = 5.0;     // as set
  double now = 5.0;      // as it is, learned
  bool changed = false;  // not as printed
  bool operator==(const RuleCell&) const = default;
};

class RuleGrid : public QWidget, public Themed {
  Q_OBJECT
 public:
  static constexpr int kCells = kRuleSets * kRuleSets;
  using Cells = std::array<RuleCell, kCells>;  // row by row

  explicit RuleGrid(QWidget* parent = nullptr);

  void display(const Cells& cells);
  void choose(int cell);
  int chosen() const { return chosen_; }
  // "error NB, change PS: 4 (NS), learned 3.4"
  QString cellText(int cell) const;

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void chosenChanged(int cell);
  void stepped(int cell, int direction);
  void reset(int cell);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double side() const;    // of a cell
  double header() const;  // of the words before them
  QRectF place(int row, int column) const;

  Theme theme_;
  Cells cells_{};
  int chosen_ = kCells / 2;
};

}  // namespace stillcut::ui
