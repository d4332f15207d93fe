#include "ui/report/table.h"

#include <QFontMetricsF>
#include <QTextLayout>
#include <QTextOption>
#include <algorithm>

namespace stillcut::ui {
namespace {

constexpr double kText = 11;
constexpr double kBetween = 10;  // columns

std::vector<double> widthsOf(const std::vector<TableColumn>& columns, double width) {
  double shares = 0.0;
  for (const TableColumn& c : columns) shares += c.share;
  const double all = width - kBetween * static_cast<double>(columns.size() - 1);
  std::vector<double> widths;
  widths.reserve(columns.size());
  for (const TableColumn& c : columns) widths.push_back(c.share / shares * all);
  return widths;
}

QStringList linesOf(const QString& text, const QFont& font, double width) {
  if (QFontMetricsF(font).horizontalAdvance(text) <= width) return {text};
  QTextLayout layout(text, font);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  QStringList lines;
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    lines << text.mid(line.textStart(), line.textLength()).trimmed();
  }
  layout.endLayout();
  return lines;
}

void drawCells(QPainter& painter, const QRectF& line, const std::vector<TableColumn>& columns, const QStringList& cells,
               const QFont& font, const QColor& color, const QColor& lastColor) {
  const std::vector<double> widths = widthsOf(columns, line.width());
  double x = line.left();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double w = widths[i];
    const bool last = i + 1 == columns.size();
    const auto align = columns[i].number ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter;
    drawLine(painter, QRectF(x, line.top(), w, line.height()), cells.value(static_cast<qsizetype>(i)), font,
             last ? lastColor : color, align);
    x += w + kBetween;
  }
}

}  // namespace

std::vector<TableColumn> fitted(const std::vector<TableColumn>& columns, const std::vector<TableRow>& rows,
                                double width, const PageStyle& style) {
  const QFontMetricsF cells(style.font(kText)), titles(style.font(kText, true));
  constexpr double kAir = 2.0;
  double left = width - kBetween * static_cast<double>(columns.size() - 1), shares = 0.0;
  std::vector<TableColumn> out = columns;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    double asked = titles.horizontalAdvance(columns[c].title);
    if (!columns[c].number) {
      shares += columns[c].share;
    } else {
      for (const TableRow& row : rows)
        asked = std::max(asked, cells.horizontalAdvance(row.cells.value(static_cast<qsizetype>(c))));
    }
    out[c].share = asked + kAir;
    if (columns[c].number) left -= out[c].share;
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!columns[c].number) out[c].share = std::max(out[c].share, columns[c].share / shares * left);
  }
  return out;
}

std::vector<TableRow> wrapped(const std::vector<TableColumn>& columns, const std::vector<TableRow>& rows, double width,
                              const PageStyle& style) {
  const std::vector<double> widths = widthsOf(columns, width);
  const QFont font = style.font(kText);
  std::vector<TableRow> all;
  for (const TableRow& row : rows) {
    const std::size_t begin = all.size();
    all.push_back({{}, row.tone});
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const QString cell = row.cells.value(static_cast<qsizetype>(c));
      const QStringList lines = columns[c].number ? QStringList{cell} : linesOf(cell, font, widths[c]);
      while (all.size() < begin + static_cast<std::size_t>(lines.size())) {
        all.push_back({QStringList(static_cast<qsizetype>(c)), row.tone});
      }
      for (std::size_t k = begin; k < all.size(); ++k) {
        all[k].cells << lines.value(static_cast<qsizetype>(k - begin));
      }
    }
  }
  return all;
}

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
