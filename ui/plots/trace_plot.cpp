#include "ui/plots/trace_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/plots/axis_painter.h"

namespace stillcut::ui {
namespace {

constexpr double kShrink = 0.98;  // per picture, so that one loud hit does not flatten the trace for good

double roundUp(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double lead : {1.0, 2.0, 5.0}) {
    if (lead * decade >= value) return lead * decade;
  }
  return 10.0 * decade;
}

}  // namespace

TracePlot::TracePlot(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("SIGNAL"), parent) {}

void TracePlot::display(const SignalHistory* signal, const QString& unit) {
  signal_ = signal;
  unit_ = unit;
  update();
}

QSize TracePlot::minimumSizeHint() const {
  return {theme().px(420), theme().px(90)};
}

void TracePlot::drawPlot(QPainter& p, const QRect& plot) {
  if (signal_ == nullptr || signal_->empty()) {
    p.setFont(theme().font(type_size::kBody));
    p.setPen(theme().colors.text);
    p.drawText(plot, Qt::AlignCenter, tr("No samples kept of this stretch"));
    return;
  }
  const std::vector<Extent> extents =
      signal_->extents(view().options().channel, view().from(), view().to(), plot.width());
  double peak = 0.0;
  for (const Extent& e : extents) {
    if (e.present) peak = std::max({peak, std::abs(static_cast<double>(e.low)), std::abs(static_cast<double>(e.high))});
  }
  full_ = std::max(peak, full_ * kShrink);
  const double full = full_ > 0.0 && std::isfinite(full_) ? roundUp(full_) : 1.0;
  const double middle = plot.center().y() + 0.5, perUnit = plot.height() / (2.0 * full);
  p.save();
  p.setClipRect(plot);
  p.setRenderHint(QPainter::Antialiasing, false);
  QList<QLine> lines, holes;
  for (std::size_t k = 0; k < extents.size(); ++k) {
    const int x = plot.left() + static_cast<int>(k);
    if (!extents[k].present) {
      holes << QLine(x, plot.top(), x, plot.bottom());
      continue;
    }
    const auto y = [&](float v) { return static_cast<int>(std::lround(middle - v * perUnit)); };
    lines << QLine(x, y(extents[k].high), x, y(extents[k].low));
  }
  p.setPen(theme().colors.gap);
  p.drawLines(holes);
  p.setPen(theme().colors.text);
  p.drawLines(lines);
  p.setPen(Qt::NoPen);
  for (const SignalHistory::Gap& gap : signal_->gaps()) {
    const double left = xOf(gap.from), right = std::max(xOf(gap.to), left + 2.0);
    p.fillRect(QRectF(left, plot.top(), right - left, plot.height()), QBrush(theme().colors.hatch, Qt::BDiagPattern));
  }
  p.restore();
  drawLeftAxis(p, plot, {-full, full}, unit_, theme());
  const QRectF header(plot.left(), plot.top() - theme().px(17), plot.width(), theme().px(17));  // hides no sample
  for (const AnalyseView::Cursor c : {AnalyseView::A, AnalyseView::B}) {
    const auto t = view().cursor(c);
    const int at = t ? static_cast<int>(xOf(*t)) - plot.left() : -1;
    if (at < 0 || at >= static_cast<int>(extents.size()) || !extents[static_cast<std::size_t>(at)].present) continue;
    const Extent& e = extents[static_cast<std::size_t>(at)];
    const double most = std::max(std::abs(static_cast<double>(e.low)), std::abs(static_cast<double>(e.high)));
    drawReading(p, header, *t, tr("peak %1").arg(join(significant(most), unit_)));
  }
}

}  // namespace stillcut::ui
