#include "ui/plots/file/file_spectrum.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/models/history/spectrum_view.h"
#include "ui/plots/axis_painter.h"
#include "ui/plots/file/frequency_axis.h"
#include "ui/plots/touch_input.h"

namespace stillcut::ui {
namespace {

constexpr double kStep_dB = 10.0;
constexpr double kReach_dB = 80.0;  // of the axis
constexpr int kColumns = 120;       // that make a mean, evenly over the stretch

}  // namespace

FileSpectrum::FileSpectrum(AnalyseView& view, QWidget* parent)
    : QWidget(parent), view_(view), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Spectrum"));
  setToolTip(tr("Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom. Double click: all."));
  connect(&view, &AnalyseView::changed, this, &FileSpectrum::refresh);
  TouchInput::Moves fingers;
  fingers.pan = [this](QPointF by) { moveBy(by.x()); };
  fingers.zoom = [this](double factor, QPointF around, Qt::Orientation along) {
    if (along == Qt::Horizontal) view_.zoomFrequency(factor, Hertz(std::max(frequencyAt(around.x()), 0.0)));
  };
  fingers.flings = true;
  new TouchInput(this, std::move(fingers));
}

void FileSpectrum::display(const Shown& shown) {
  shown_ = shown;
  refresh();
}

// At the cursor one column; else the mean power of what is on show.
FileSpectrum::Curve FileSpectrum::curveOf(const Spectra* spectra) const {
  Curve curve;
  if (spectra == nullptr || spectra->columns == 0) return curve;
  curve.binWidth = spectra->binWidth;
  const auto bins = static_cast<std::size_t>(spectra->bins);
  const auto cursor = view_.cursor(AnalyseView::A);
  int first = spectra->columnAt(sinceEpoch(view_.from())), last = spectra->columnAt(sinceEpoch(view_.to()));
  if (cursor) first = last = spectra->columnAt(sinceEpoch(*cursor));
  std::vector<double> power(bins, 0.0);
  int count = 0;
  const int every = std::max((last - first) / kColumns, 1);
  for (int k = first; k <= last; k += every) {
    const float* column = spectra->column(k);
    if (!std::isfinite(column[bins / 2])) continue;  // samples are missing
    ++count;
    for (std::size_t b = 0; b < bins; ++b) power[b] += std::pow(10.0, 0.1 * static_cast<double>(column[b]));
  }
  if (count == 0) return curve;
  curve.level_dB.resize(bins);
  for (std::size_t b = 0; b < bins; ++b)
    curve.level_dB[b] = static_cast<float>(10.0 * std::log10(std::max(power[b] / count, 1e-24)));
  return curve;
}

void FileSpectrum::refresh() {
  main_ = curveOf(shown_.main.get());
  beside_ = curveOf(shown_.beside.get());
  if (!main_.level_dB.empty()) {
    const double loud = *std::max_element(main_.level_dB.begin(), main_.level_dB.end());
    if (loud > high_dB_ || loud < high_dB_ - 3 * kStep_dB) high_dB_ = std::ceil(loud / kStep_dB) * kStep_dB;
    low_dB_ = high_dB_ - kReach_dB;
  }
  setAccessibleDescription(reading());
  update();
}

QString FileSpectrum::reading() const {
  const auto cursor = view_.harmonic();
  if (!cursor || main_.level_dB.empty()) return {};
  const auto bin = static_cast<std::size_t>(
      std::clamp<long>(std::lround(cursor->value / main_.binWidth), 0, static_cast<long>(main_.level_dB.size()) - 1));
  QString text = join(number(cursor->value, main_.binWidth < 5.0 ? 1 : 0), QStringLiteral("Hz"));
  if (shown_.marks.spindle.value > 0.0) text += tr(", order %1").arg(number(*cursor / shown_.marks.spindle, 2));
  text += QStringLiteral(", ") + join(number(static_cast<double>(main_.level_dB[bin]), 1), QStringLiteral("dB"));
  if (bin < beside_.level_dB.size() && beside_.binWidth > 0.0) {
    const auto other = static_cast<std::size_t>(std::clamp<long>(std::lround(cursor->value / beside_.binWidth), 0,
                                                                 static_cast<long>(beside_.level_dB.size()) - 1));
    text +=
        tr(", compared %1").arg(join(number(static_cast<double>(beside_.level_dB[other]), 1), QStringLiteral("dB")));
  }
  return text;
}

void FileSpectrum::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize FileSpectrum::minimumSizeHint() const {
  return {theme_.px(220), theme_.px(160)};
}

QRect FileSpectrum::plotRect() const {
  return rect().adjusted(theme_.px(62), theme_.px(54), -theme_.px(14), -theme_.px(26));
}

FrequencyScale FileSpectrum::scale() const {
  return {view_.options().low, view_.options().high, shown_.look.log};
}

double FileSpectrum::xOf(double hertz) const {
  const QRect plot = plotRect();
  return plot.left() + scale().placeOf(hertz) * plot.width();
}

double FileSpectrum::frequencyAt(double x) const {
  const QRect plot = plotRect();
  return scale().at((x - plot.left()) / std::max(plot.width(), 1));
}

void FileSpectrum::drawCurve(QPainter& p, const Curve& curve, const QPen& pen) const {
  if (curve.level_dB.empty()) return;
  const QRect plot = plotRect();
  QPolygonF line;
  double crest = low_dB_;
  for (std::size_t b = 1; b < curve.level_dB.size(); ++b) {
    const double x = xOf(static_cast<double>(b) * curve.binWidth);
    if (x < plot.left() - 20 || x > plot.right() + 20) continue;
    const double level = std::clamp(static_cast<double>(curve.level_dB[b]), low_dB_ - 5.0, high_dB_ + 5.0);
    // Of several bins on one pixel the strongest is drawn.
    const bool same = !line.isEmpty() && x - line.last().x() < 1.0;
    crest = same ? std::max(crest, level) : level;
    const double y = plot.bottom() + 1 - (crest - low_dB_) / (high_dB_ - low_dB_) * plot.height();
    if (same) {
      line.last().setY(y);
    } else {
      line << QPointF(x, y);
    }
  }
  p.setPen(pen);
  p.setBrush(Qt::NoBrush);
  p.drawPolyline(line);
  if (pen.style() == Qt::SolidLine) p.drawPolyline(line.translated(0.0, 1.0));
}

void FileSpectrum::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), theme_.colors.panel);
  p.setRenderHint(QPainter::Antialiasing);
  const QRect plot = plotRect();
  if (plot.width() < 40 || plot.height() < 20) return;
  const auto cursor = view_.cursor(AnalyseView::A);
  p.setFont(theme_.font(type_size::kLabel, true));
  p.setPen(theme_.colors.secondary);
  const QString title =
      cursor ? tr("SPECTRUM AT A, %1").arg(join(number(sinceEpoch(*cursor).value, 2), QStringLiteral("s")))
             : tr("SPECTRUM, MEAN");
  p.drawText(QRect(theme_.px(12), 0, width(), theme_.px(26)), Qt::AlignVCenter | Qt::AlignLeft, title);
  p.setPen(theme_.colors.text);
  const QString read = reading();
  const QRect line(theme_.px(12), theme_.px(22), width() - theme_.px(24), theme_.px(22));
  if (read.isEmpty() && shown_.beside) {
    drawNames(p, line);
  } else {
    p.setFont(theme_.font(type_size::kLabel, true));
    p.drawText(line, Qt::AlignVCenter | Qt::AlignLeft, read);
  }
  p.fillRect(plot, theme_.colors.track);
  if (main_.level_dB.empty()) return;
  const bool order = shown_.look.order && shown_.marks.spindle.value > 0.0;
  drawFrequencyBottom(p, plot, scale(), order ? 1.0 / shown_.marks.spindle.value : 1.0,
                      order ? tr("order") : QStringLiteral("Hz"), theme_);
  drawLeftAxis(p, plot, {low_dB_, high_dB_}, QStringLiteral("dB"), theme_);
  p.save();
  p.setClipRect(plot);
  drawCurve(p, beside_, QPen(theme_.colors.advice, 1, Qt::DashLine));
  drawCurve(p, main_, QPen(theme_.colors.text, 1));
  p.restore();
  drawMarks(p);
  if (!hasFocus()) return;
  p.setPen(QPen(theme_.colors.text, theme_.px(1.5), Qt::DotLine));
  p.setBrush(Qt::NoBrush);
  p.drawRect(plot.adjusted(0, 0, -1, -1));
}

// Which curve is of which file.
void FileSpectrum::drawNames(QPainter& p, const QRect& line) const {
  p.setFont(theme_.font(type_size::kLabel));
  const int half = line.width() / 2, sample = theme_.px(18), gap = theme_.px(6);
  int x = line.left();
  for (const auto& [name, pen] :
       {std::pair(shown_.name, QPen(theme_.colors.text, theme_.px(2))),
        std::pair(shown_.besideName, QPen(theme_.colors.advice, theme_.px(2), Qt::DashLine))}) {
    p.setPen(pen);
    p.drawLine(x, line.center().y(), x + sample, line.center().y());
    p.setPen(theme_.colors.text);
    const QRect words(x + sample + gap, line.top(), half - sample - 2 * gap, line.height());
    p.drawText(words, Qt::AlignVCenter | Qt::AlignLeft,
               p.fontMetrics().elidedText(name, Qt::ElideMiddle, words.width()));
    x += half;
  }
}

void FileSpectrum::drawMarks(QPainter& p) const {
  const QRect plot = plotRect();
  const FrequencyScale axis = scale();
  p.setPen(QPen(theme_.colors.text, theme_.px(1.4)));
  for (const double f : passingMarks(shown_.marks, axis.low(), axis.high()))
    p.drawLine(QPointF(xOf(f), plot.top() - theme_.px(6)), QPointF(xOf(f), plot.top()));
  p.setPen(QPen(theme_.colors.chatterText, theme_.px(1.2)));
  for (const double f : chatterFamily(shown_.marks, axis.low(), axis.high()))
    p.drawLine(QPointF(xOf(f), plot.top()), QPointF(xOf(f), plot.top() + theme_.px(8)));
  if (const auto cursor = view_.harmonic(); cursor && cursor->value > 0.0) {
    p.setPen(QPen(theme_.colors.onsetText, theme_.px(1.2), Qt::DashLine));
    for (int k = 1; k <= 20 && cursor->value * k <= axis.high(); ++k) {
      if (const double x = xOf(cursor->value * k); x >= plot.left())
        p.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    }
  }
  const double chatter = shown_.marks.chatter.value;
  if (!(chatter > axis.low()) || chatter > axis.high()) return;
  p.setFont(theme_.font(type_size::kTick, true));
  const QString label = tr("chatter %1").arg(join(number(chatter), QStringLiteral("Hz")));
  const double w = p.fontMetrics().horizontalAdvance(label) + theme_.px(10), x = xOf(chatter);
  const QRectF tag(std::clamp(x - w / 2, double(plot.left()), plot.right() - w), plot.top() + theme_.px(10), w,
                   theme_.px(19));
  p.setPen(QPen(theme_.colors.chatterText, theme_.px(1.5)));
  p.drawLine(QPointF(x, tag.bottom()), QPointF(x, plot.bottom()));
  p.fillRect(tag, theme_.back(Tone::Chatter));
  p.setPen(theme_.front(Tone::Chatter));
  p.drawText(tag, Qt::AlignCenter, label);
}

void FileSpectrum::wheelEvent(QWheelEvent* event) {
  view_.zoomFrequency(std::pow(0.8, event->angleDelta().y() / 120.0),
                      Hertz(std::max(frequencyAt(event->position().x()), 0.0)));
  event->accept();
}

void FileSpectrum::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  dragged_ = false;
}

void FileSpectrum::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  if (!dragged_ && std::abs(event->position().x() - pressed_->x()) < 6.0) return;
  dragged_ = true;
  const double by = event->position().x() - last_.x();
  last_ = event->position();
  moveBy(by);
}

void FileSpectrum::moveBy(double right) {
  view_.panFrequency((view_.options().high - view_.options().low) * (-right / std::max(plotRect().width(), 1)));
}

void FileSpectrum::mouseReleaseEvent(QMouseEvent* event) {
  const bool click = pressed_ && !dragged_;
  pressed_.reset();
  const double f = frequencyAt(event->position().x());
  if (click && f > 0.0) view_.setHarmonic(Hertz(f));
}

void FileSpectrum::mouseDoubleClickEvent(QMouseEvent*) {
  view_.showFrequencies(Hertz(), view_.top());
}

void FileSpectrum::keyPressEvent(QKeyEvent* event) {
  const FrequencyScale axis = scale();
  const double step = (axis.high() - axis.low()) * 0.002;
  switch (event->key()) {
    case Qt::Key_H: {
      double loudest = -400.0, at = 0.0;
      for (std::size_t b = 1; b < main_.level_dB.size(); ++b) {
        const double f = static_cast<double>(b) * main_.binWidth;
        if (f < axis.low() || f > axis.high() || static_cast<double>(main_.level_dB[b]) <= loudest) continue;
        loudest = static_cast<double>(main_.level_dB[b]);
        at = f;
      }
      if (at > 0.0) view_.setHarmonic(Hertz(at));
      return;
    }
    case Qt::Key_Left:
    case Qt::Key_Right: {
      const double from = view_.harmonic() ? view_.harmonic()->value : 0.5 * (axis.low() + axis.high());
      return view_.setHarmonic(Hertz(std::max(from + (event->key() == Qt::Key_Left ? -step : step), step)));
    }
    case Qt::Key_Delete:
      return view_.setHarmonic({});
    case Qt::Key_PageUp:
      return view_.zoomFrequency(1.25, Hertz(axis.low()));
    case Qt::Key_PageDown:
      return view_.zoomFrequency(0.8, Hertz(axis.low()));
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace stillcut::ui
