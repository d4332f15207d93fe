// A table of text on paper: a head, thin rules, rows of one line each. GUI thread.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <vector>

#include "ui/report/page_style.h"

namespace stillcut::ui {

struct TableColumn {
  QString title;
  double share = 1.0;   // of the width
  bool number = false;  // aligned to the right
};

struct TableRow {
  QStringList cells;
  Tone tone = Tone::Normal;  // of the last cell
};

inline constexpr double kTableRow = 19;  // height of a row and of the head [1/96 inch]

// Shares by what stands in the columns: numbers are never cut, texts share the rest and wrap in it.
std::vector<TableColumn> fitted(const std::vector<TableColumn>& columns, const std::vector<TableRow>& rows,
                                double width, const PageStyle& style);

// The same rows with as many lines for each as its longest cell needs in a table of `width`: broken between words, and
// within what has none (Chinese, a path). Numbers stay whole.
std::vector<TableRow> wrapped(const std::vector<TableColumn>& columns, const std::vector<TableRow>& rows, double width,
                              const PageStyle& style);

// Draws rows from `first` on as long as they fit into `area`; returns how many. `used` is the height taken.
int drawTable(QPainter& painter, const QRectF& area, const std::vector<TableColumn>& columns,
              const std::vector<TableRow>& rows, int first, const PageStyle& style, double& used);

}  // namespace stillcut::ui
