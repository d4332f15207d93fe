#include "ui/plots/file/wave_plot.h"

#include <QFileInfo>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/base/format.h"
#include "ui/plots/axis_painter.h"

namespace stillcut::ui {
namespace {

double roundUp(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double lead : {1.0, 2.0, 5.0}) {
    if (lead * decade >= value) return lead * decade;
  }
  return 10.0 * decade;
}

const FileChannel* channelOf(const WavePlot::Shown& shown) {
  if (!shown.file || shown.channel < 0 || shown.channel >= static_cast<int>(shown.file->channels.size()))
    return nullptr;
  return &shown.file->channels[static_cast<std::size_t>(shown.channel)];
}

// Least and greatest of the samples from .. to: from themselves where they are at hand.
WaveExtent extentOf(const WavePlot::Shown& shown, const FileChannel& channel, std::int64_t from, std::int64_t to) {
  const Spectra* s = shown.spectra.get();
  const bool close = s != nullptr && s->request.channel == shown.channel && from >= s->firstSample &&
                     to <= s->firstSample + static_cast<std::int64_t>(s->samples.size());
  if (!close) return channel.wave.over(from, to);
  WaveExtent extent;
  for (std::int64_t k = from; k < to; ++k) extent.take(s->samples[static_cast<std::size_t>(k - s->firstSample)]);
  return extent;
}

}  // namespace

WavePlot::WavePlot(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("SIGNAL"), parent) {
  setToolTip(
      tr("Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Double click: all. Click: cursor A, with "
         "Shift B."));
}

void WavePlot::display(const Shown& main, const Shown& beside) {
  main_ = main;
  beside_ = beside;
  setLegend(beside.file ? tr("below: %1").arg(QFileInfo(beside.file->path).fileName()) : QString());
  update();
}

void WavePlot::setHeard(std::optional<Seconds> heard) {
  if (heard == heard_) return;
  heard_ = heard;
  update();
}

QSize WavePlot::minimumSizeHint() const {
  return {theme().px(300), theme().px(90)};
}

void WavePlot::drawPlot(QPainter& p, const QRect& plot) {
  if (!main_.file) return;
  if (beside_.file) {
    const int half = (plot.height() - theme().px(6)) / 2;
    drawWave(p, QRect(plot.left(), plot.top(), plot.width(), half), main_);
    drawWave(p, QRect(plot.left(), plot.bottom() + 1 - half, plot.width(), half), beside_);
  } else {
    drawWave(p, plot, main_);
  }
  if (!heard_) return;
  const double x = xOf(Instant{} + toDuration(*heard_));
  p.setPen(QPen(theme().colors.advice, theme().px(2)));
  if (x >= plot.left() && x <= plot.right() + 1) p.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
}

// Longer than a screen: one picture, column by column
void WavePlot::drawWave(QPainter& p, const QRect& box, const Shown& shown) const {
  const FileChannel* channel = channelOf(shown);
  if (channel == nullptr) return;
  const WaveExtent whole = channel->wave.whole();
  const double peak =
      whole.present() ? std::max(std::abs(static_cast<double>(whole.low)), std::abs(static_cast<double>(whole.high)))
                      : 0.0;
  const double full = peak > 0.0 && std::isfinite(peak) ? roundUp(peak) : 1.0;
  const double rate = shown.file->rate.value, from = sinceEpoch(view().from()).value * rate;
  const double perPixel = view().options().span.value * rate / std::max(box.width(), 1);
  const double middle = box.center().y() + 0.5, perUnit = box.height() / (2.0 * full);
  const auto yOf = [&](double v) { return middle - v * perUnit; };
  const std::int64_t end = channel->wave.samples();
  p.save();
  p.setClipRect(box);
  p.setRenderHint(QPainter::Antialiasing, false);
  QList<QLineF> lines, holes;
  for (int k = 0; k < box.width(); ++k) {
    const auto first = static_cast<std::int64_t>(std::floor(from + perPixel * k));
    // One sample more than fits, so that neighbours touch.
    const auto last = std::max(static_cast<std::int64_t>(std::floor(from + perPixel * (k + 1))), first) + 1;
    if (last <= 0 || first >= end) continue;
    const WaveExtent e = extentOf(shown, *channel, std::max<std::int64_t>(first, 0), std::min(last, end));
    const double x = box.left() + k;
    if (!e.present()) {
      holes << QLineF(x, box.top(), x, box.bottom());
      continue;
    }
    lines << QLineF(x, yOf(e.high), x, yOf(e.low));
  }
  p.setPen(theme().colors.gap);
  p.drawLines(holes);
  p.setPen(theme().colors.text);
  p.drawLines(lines);
  p.restore();
  constexpr qsizetype kRoom = 6;  // letters beside the plot; "full scale" stands at the spectrogram's colours
  drawLeftAxis(p, box, {-full, full}, channel->unit.size() > kRoom ? QString() : channel->unit, theme());
}

}  // namespace stillcut::ui
