#include "ui/plots/file/spectra_map.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ui/base/format.h"
#include "ui/models/history/spectrum_view.h"
#include "ui/plots/file/frequency_axis.h"
#include "ui/plots/spectrogram/colormap.h"
#include "ui/plots/spectrogram/level_key.h"

namespace stillcut::ui {
namespace {

constexpr double kStep_dB = 5.0;
constexpr double kMost_dB = 90.0;  // of the palette
constexpr double kLeast_dB = 40.0;
constexpr std::size_t kLooks = 20000;  // at levels, to lay out the palette

}  // namespace

SpectraMap::SpectraMap(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("SPECTROGRAM"), parent) {
  setToolTip(
      tr("Drag: move. Wheel: zoom in time, with Ctrl in frequency. Ctrl and drag: zoom to a stretch. Double "
         "click: all. Click: cursor A, with Shift B."));
}

void SpectraMap::display(std::shared_ptr<const Spectra> spectra, const FileLook& look, const FileMarks& marks,
                         const QString& unit) {
  const bool other = spectra != spectra_;
  spectra_ = std::move(spectra);
  look_ = look;
  marks_ = marks;
  unit_ = unit;
  if (other && spectra_) fitLevels();
  update();
}

QSize SpectraMap::minimumSizeHint() const {
  return {theme().px(300), theme().px(150)};
}

FrequencyScale SpectraMap::scale() const {
  return {view().options().low, view().options().high, look_.log};
}

// From the noise, which most of the picture is, to the loudest. A closer look keeps the palette, so that colours mean
// the same.
void SpectraMap::fitLevels() {
  const SpectraRequest& asked = spectra_->request;
  const bool same = fitted_.channel == asked.channel && fitted_.length == asked.length &&
                    fitted_.window == asked.window && asked.to - asked.from < fitted_.to - fitted_.from;
  if (same || spectra_->columns == 0) return;
  std::vector<float> levels;
  const std::size_t every = std::max<std::size_t>(spectra_->level_dB.size() / kLooks, 1) | 1U;
  float loudest = -240.0F;
  for (std::size_t k = 0; k < spectra_->level_dB.size(); ++k) {
    const float level = spectra_->level_dB[k];
    if (!std::isfinite(level)) continue;
    loudest = std::max(loudest, level);
    if (k % every == 0) levels.push_back(level);
  }
  if (levels.empty()) return;
  const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
  std::nth_element(levels.begin(), middle, levels.end());
  fitted_ = asked;
  high_dB_ = std::ceil(loudest / kStep_dB) * kStep_dB;
  low_dB_ = std::clamp(std::floor(*middle / kStep_dB) * kStep_dB, high_dB_ - kMost_dB, high_dB_ - kLeast_dB);
}

void SpectraMap::panUp(double share) {
  const FrequencyScale axis = scale();
  if (!look_.log) return view().panFrequency(Hertz((axis.high() - axis.low()) * share));
  view().showFrequencies(Hertz(axis.at(share)), Hertz(std::min(axis.at(1.0 + share), view().top().value)));
}

void SpectraMap::zoomUp(double factor, double y) {
  const QRect plot = plotRect();
  const double place = (plot.bottom() + 1 - y) / std::max(plot.height(), 1);
  view().zoomFrequency(factor, Hertz(std::max(scale().at(place), 0.0)));
}

void SpectraMap::drawPlot(QPainter& p, const QRect& plot) {
  if (!spectra_) return;
  const Drawn wanted{spectra_.get(),        view().from(), view().options().span, view().options().low,
                     view().options().high, look_.log,     plot.size(),           theme().colors.gap.rgb()};
  if (!(wanted == drawn_)) paintImage(wanted);
  p.drawImage(plot.topLeft(), image_);
  const double per = look_.order && marks_.spindle.value > 0.0 ? 1.0 / marks_.spindle.value : 1.0;
  drawFrequencyLeft(p, plot, scale(), per, per == 1.0 ? QStringLiteral("Hz") : tr("order"), theme());
  drawMarks(p, plot);
  const QRect row(plot.left(), 0, plot.width(), plot.top());
  drawLevelKey(p, row, LevelKeyKind::Colors, number(low_dB_), join(number(high_dB_), decibelUnit(unit_)), theme());
}

void SpectraMap::paintImage(const Drawn& wanted) {
  drawn_ = wanted;
  const Spectra& s = *spectra_;
  if (image_.size() != wanted.size) image_ = QImage(wanted.size, QImage::Format_RGB32);
  image_.fill(wanted.gap);
  if (s.columns == 0) return;
  const FrequencyScale axis = scale();
  // Bins of each row from the top, one more at the end: the strongest of them counts.
  std::vector<int> edges(static_cast<std::size_t>(wanted.size.height()) + 1);
  for (std::size_t y = 0; y < edges.size(); ++y) {
    const double f = axis.at(1.0 - static_cast<double>(y) / wanted.size.height());
    edges[y] = std::clamp(static_cast<int>(std::lround(f / s.binWidth)), 0, s.bins - 1);
  }
  const ColorTable& colors = viridis();
  const double gain = 255.0 / (high_dB_ - low_dB_);
  const double begin = s.first.value - 0.5 * s.step.value, end = begin + s.columns * s.step.value;
  // What is shorter than a spectrum at the ends of the recording belongs to the first and the last.
  const double lead = std::max(begin - s.request.from.value, 0.0), tail = std::max(s.request.to.value - end, 0.0);
  for (int x = 0; x < wanted.size.width(); ++x) {
    const double t = sinceEpoch(wanted.from).value + wanted.span.value * (x + 0.5) / wanted.size.width();
    if (t < begin - lead || t > end + tail) continue;
    const float* column = s.column(s.columnAt(Seconds(t)));
    for (int y = 0; y < wanted.size.height(); ++y) {
      const int low = edges[static_cast<std::size_t>(y) + 1],
                high = std::max(edges[static_cast<std::size_t>(y)], low + 1);
      float level = column[low];
      for (int b = low + 1; b < std::min(high, s.bins); ++b) level = std::max(level, column[b]);
      if (!std::isfinite(level)) continue;
      const double place = std::clamp((static_cast<double>(level) - low_dB_) * gain, 0.0, 255.0);
      reinterpret_cast<QRgb*>(image_.scanLine(y))[x] = colors[static_cast<std::size_t>(place)];
    }
  }
}

void SpectraMap::drawMarks(QPainter& p, const QRect& plot) const {
  const FrequencyScale axis = scale();
  const auto yOf = [&](double f) { return plot.bottom() + 1 - axis.placeOf(f) * plot.height(); };
  p.setPen(QPen(theme().colors.text, theme().px(1.4)));
  for (const double f : passingMarks(marks_, axis.low(), axis.high()))
    p.drawLine(QPointF(plot.right() + 2, yOf(f)), QPointF(plot.right() + theme().px(8), yOf(f)));
  p.setPen(QPen(theme().colors.chatterText, theme().px(1.4)));
  for (const double f : chatterFamily(marks_, axis.low(), axis.high()))
    p.drawLine(QPointF(plot.right() + theme().px(10), yOf(f)), QPointF(plot.right() + theme().px(16), yOf(f)));
  const double chatter = marks_.chatter.value;
  if (!(chatter > axis.low()) || chatter > axis.high()) return;
  p.setPen(QPen(Qt::white, theme().px(1), Qt::DashLine));
  p.drawLine(QPointF(plot.left(), yOf(chatter)), QPointF(plot.right(), yOf(chatter)));
  p.setFont(theme().font(type_size::kTick, true));
  const QString label = tr("chatter %1").arg(join(number(chatter), QStringLiteral("Hz")));
  const int wide = p.fontMetrics().horizontalAdvance(label) + theme().px(10), tall = theme().px(19);
  const double top = yOf(chatter) - tall > plot.top() ? yOf(chatter) - tall : yOf(chatter);
  const QRectF tag(plot.right() - wide, top, wide, tall);
  p.fillRect(tag, theme().back(Tone::Chatter));
  p.setPen(theme().front(Tone::Chatter));
  p.drawText(tag, Qt::AlignCenter, label);
}

}  // namespace stillcut::ui
