#include "ui/report/table.h"

#include <algorithm>

namespace stillcut::ui {
namespace {

constexpr double kText = 11;
constexpr double kBetween = 10;  // columns

void drawCells(QPainter& painter, const QRectF& line, const std::vector<TableColumn>& columns, const QStringList& cells,
               const QFont& font, const QColor& color, const QColor& lastColor) {
  double shares = 0.0;
  for (const TableColumn& c : columns) shares += c.share;
  const double width = line.width() - kBetween * static_cast<double>(columns.size() - 1);
  double x = line.left();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double w = columns[i].share / shares * width;
    const bool last = i + 1 == columns.size();
    const auto align = columns[i].number ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter;
    drawLine(painter, QRectF(x, line.top(), w, line.height()), cells.value(static_cast<qsizetype>(i)), font,
             last ? lastColor : color, align);
    x += w + kBetween;
  }
}

}  // namespace

int drawTable(QPainter& painter, const QRectF& area, const std::vector<TableColumn>& columns,
              const std::vector<TableRow>& rows, int first, const PageStyle& style, double& used) {
  const ThemeColors& colors = style.colors();
  QStringList titles;
  for (const TableColumn& c : columns) titles << c.title;
  QRectF line(area.left(), area.top(), area.width(), kTableRow);
  drawCells(painter, line, columns, titles, style.font(kText, true), colors.secondary, colors.secondary);
  painter.setPen(QPen(colors.hatch, 1.0));
  painter.drawLine(line.bottomLeft(), line.bottomRight());
  int drawn = 0;
  for (std::size_t i = static_cast<std::size_t>(first); i < rows.size(); ++i, ++drawn) {
    line.translate(0, kTableRow);
    if (line.bottom() > area.bottom() + 0.5) break;
    drawCells(painter, line, columns, rows[i].cells, style.font(kText), colors.text,
              rows[i].tone == Tone::Normal ? colors.text : style.theme().onPanel(rows[i].tone));
    painter.setPen(QPen(colors.track, 0.7));
    painter.drawLine(line.bottomLeft(), line.bottomRight());
  }
  used = kTableRow * (drawn + 1);
  return drawn;
}

}  // namespace stillcut::ui
