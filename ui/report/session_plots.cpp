#include "ui/report/session_plots.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/report/plot_frame.h"
#include "ui/report/spectrogram_picture.h"

namespace stillcut::ui {
namespace {

constexpr double kLeft = 62;    // for the numbers
constexpr double kRight = 58;   // for the level scale beside the spectrogram
constexpr double kTitle = 20;   // above every plot
constexpr double kGap = 8;      // between plots
constexpr double kTimes = 34;   // below the last
constexpr double kStates = 18;  // the band of verdicts
constexpr double kMarkRadius = 7;

struct Row {
  double share;  // of the height that is left
  std::function<void(const QRectF& inside, bool last)> draw;
};

Tone toneOf(CutState state) {
  if (state == CutState::Chatter) return Tone::Chatter;
  return state == CutState::Onset ? Tone::Onset : Tone::Normal;
}

// Worse is higher as well as of another colour.
void drawStates(QPainter& painter, const QRectF& band, const SessionSummary& summary, const PageStyle& style) {
  const ThemeColors& colors = style.colors();
  painter.fillRect(band, colors.raised);
  const double seconds = std::max(summary.length.value, 1e-9);
  const std::size_t n = summary.curve.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SummaryPoint& p = summary.curve[i];
    if (!p.valid || p.state == CutState::AirCutting) continue;
    const double from = i == 0 ? 0.0 : 0.5 * (summary.curve[i - 1].time.value + p.time.value);
    const double to = i + 1 == n ? seconds : 0.5 * (p.time.value + summary.curve[i + 1].time.value);
    const double share = p.state == CutState::Chatter ? 1.0 : p.state == CutState::Onset ? 0.66 : 0.33;
    const QColor color = p.state == CutState::Stable ? colors.fill : style.theme().back(toneOf(p.state));
    const double left = band.left() + from / seconds * band.width();
    const double right = band.left() + to / seconds * band.width();
    painter.fillRect(
        QRectF(left, band.bottom() - share * band.height(), std::max(0.6, right - left), share * band.height()), color);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.border, 1.0));
  painter.drawRect(band);
  drawLine(painter, QRectF(band.left() - 62, band.top(), 56, band.height()), say("Verdict"), style.font(11, true),
           colors.text, Qt::AlignRight | Qt::AlignVCenter);
}

// Below the last plot: what the heights and the numbers mean.
void drawLegend(QPainter& painter, const QPointF& at, const SessionSummary& summary, const PageStyle& style) {
  struct Item {
    double share;
    QColor color;
    QString word;
  };
  const Item items[] = {{0.33, style.colors().fill, say("stable")},
                        {0.66, style.theme().back(Tone::Onset), say("onset")},
                        {1.0, style.theme().back(Tone::Chatter), say("chatter")}};
  constexpr double kHeight = 11;
  const QFont font = style.font(10);
  double x = at.x();
  for (const Item& item : items) {
    painter.fillRect(QRectF(x, at.y() + kHeight * (1.0 - item.share) + 1.5, 9, kHeight * item.share), item.color);
    const double width = QFontMetricsF(font).horizontalAdvance(item.word) + 4;
    drawLine(painter, QRectF(x + 13, at.y(), width, 14), item.word, font, style.colors().secondary);
    x += width + 26;
  }
  if (summary.interventions.empty()) return;
  painter.setPen(QPen(style.colors().advice, 1.0, Qt::DashLine));
  painter.drawLine(QPointF(x + 4, at.y()), QPointF(x + 4, at.y() + 14));
  drawLine(painter, QRectF(x + 13, at.y(), 160, 14), say("Stillcut moved speed or feed"), font,
           style.colors().secondary);
}

void drawGaps(QPainter& painter, const PlotFrame& frame, const SessionSummary& summary, const PageStyle& style) {
  for (std::size_t i = 1; i < summary.curve.size(); ++i) {
    if (!summary.curve[i].gap) continue;
    const double from = frame.atX(summary.curve[i - 1].time.value);
    const double to = frame.atX(summary.curve[i].time.value);
    painter.fillRect(QRectF(from, frame.inside().top(), std::max(1.0, to - from), frame.inside().height()),
                     style.colors().gap);
  }
}

// Steps without a value break the line.
void drawCurve(QPainter& painter, const PlotFrame& frame, const SessionSummary& summary, const QPen& pen,
               const std::function<double(const SummaryPoint&)>& value) {
  QPainterPath path;
  bool open = false;
  for (const SummaryPoint& p : summary.curve) {
    const double v = value(p);
    if (!std::isfinite(v)) {
      open = false;
      continue;
    }
    const QPointF at(frame.atX(p.time.value), frame.atY(v));
    open ? path.lineTo(at) : path.moveTo(at);
    open = true;
  }
  painter.save();
  painter.setClipRect(frame.inside());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawPath(path);
  painter.restore();
}

double largest(const SessionSummary& summary, const std::function<double(const SummaryPoint&)>& value) {
  double most = 0.0;
  for (const SummaryPoint& p : summary.curve) {
    if (std::isfinite(value(p))) most = std::max(most, value(p));
  }
  return most;
}

void drawMoves(QPainter& painter, const QRectF& inside, const SessionSummary& summary, const PageStyle& style) {
  painter.setPen(QPen(style.colors().advice, 1.0, Qt::DashLine));
  for (const Intervention& move : summary.interventions) {
    if (toNs(move.commanded) <= 0) continue;
    const double x = inside.left() + sinceEpoch(move.commanded).value / summary.length.value * inside.width();
    painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
  }
}

void drawMoveNumbers(QPainter& painter, const QRectF& band, const SessionSummary& summary, const PageStyle& style) {
  constexpr std::size_t kMostNumbers = 20;  // more would cover each other
  if (summary.interventions.size() > kMostNumbers) return;
  for (const Intervention& move : summary.interventions) {
    if (toNs(move.commanded) <= 0) continue;
    const double x = band.left() + sinceEpoch(move.commanded).value / summary.length.value * band.width();
    const QRectF disc(x - kMarkRadius, band.top() - 17, 2 * kMarkRadius, 2 * kMarkRadius);
    painter.setPen(Qt::NoPen);
    painter.setBrush(style.colors().advice);
    painter.drawEllipse(disc);
    drawLine(painter, disc, QString::number(move.number + 1), style.font(10, true), style.colors().onAdvice,
             Qt::AlignCenter);
  }
}

QString unitOf(const SessionSummary& summary) {
  if (summary.sensors.empty() || !summary.sensors.front().calibrated) return say("uncalibrated");
  const std::string_view unit = siUnit(summary.sensors.front().info.quantity);
  return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString firstName(const SessionSummary& summary) {
  return summary.sensors.empty() ? QString() : QString::fromStdString(summary.sensors.front().info.name);
}

class Plots {
  Q_DECLARE_TR_FUNCTIONS(Plots)

 public:
  Plots(QPainter& painter, const SessionSummary& summary, const PageStyle& style)
      : painter_(painter), summary_(summary), style_(style), x_{0.0, std::max(summary.length.value, 1e-9)} {}

  std::vector<Row> rows() {
    std::vector<Row> all;
    all.push_back({3.0, [this](const QRectF& r, bool last) { spectrogram(r, last); }});
    all.push_back({1.5, [this](const QRectF& r, bool last) { vibration(r, last); }});
    if (summary_.session) all.push_back({1.2, [this](const QRectF& r, bool last) { severity(r, last); }});
    const bool speeds = largest(summary_, [](const SummaryPoint& p) { return p.speed.value; }) > 0.0;
    if (speeds) all.push_back({1.2, [this](const QRectF& r, bool last) { speed(r, last); }});
    return all;
  }

 private:
  void spectrogram(const QRectF& inside, bool last) {
    const Hertz top = visibleTop(summary_);
    const PlotFrame frame(inside, x_, {0.0, std::max(top.value, 1.0) / 1e3});
    drawSpectrogram(painter_, inside, summary_, top, style_);
    drawMoves(painter_, inside, summary_, style_);
    frame.drawEdge(painter_, style_, tr("Spectrogram of %1 [kHz]").arg(firstName(summary_)), 6, last);
  }
  void vibration(const QRectF& inside, bool last) {
    const auto value = [](const SummaryPoint& p) { return p.vibration; };
    curve(inside, last, {0.0, 1.08 * std::max(largest(summary_, value), 1e-12)}, style_.colors().text, value,
          tr("Vibration of %1, rms [%2]").arg(firstName(summary_), unitOf(summary_)));
  }
  void severity(const QRectF& inside, bool last) {
    curve(
        inside, last, {0.0, 1.0}, style_.colors().chatterText,
        [](const SummaryPoint& p) { return p.valid ? p.severity : NAN; }, tr("Energy ratio, chatter to all"));
  }
  void speed(const QRectF& inside, bool last) {
    const auto value = [](const SummaryPoint& p) { return p.speed.value > 0.0 ? p.speed.value : NAN; };
    double low = INFINITY;
    double high = 0.0;
    for (const SummaryPoint& p : summary_.curve) {
      if (p.speed.value > 0.0) low = std::min(low, p.speed.value);
      high = std::max(high, p.speed.value);
    }
    const double margin = std::max(0.08 * (high - low), 0.01 * high);
    curve(inside, last, {low - margin, high + margin}, style_.colors().advice, value, tr("Spindle speed [rpm]"));
  }
  void curve(const QRectF& inside, bool last, PlotScale y, const QColor& color,
             const std::function<double(const SummaryPoint&)>& value, const QString& title) {
    constexpr int kTicks = 4;
    const PlotFrame frame(inside, x_, y);
    frame.drawGrid(painter_, style_, kTicks);
    drawGaps(painter_, frame, summary_, style_);
    drawMoves(painter_, inside, summary_, style_);
    drawCurve(painter_, frame, summary_, QPen(color, 1.2), value);
    frame.drawEdge(painter_, style_, title, kTicks, last);
  }

  QPainter& painter_;
  const SessionSummary& summary_;
  const PageStyle& style_;
  PlotScale x_;
};

}  // namespace

void drawSessionPlots(QPainter& painter, const QRectF& area, const SessionSummary& summary, const PageStyle& style) {
  painter.setRenderHint(QPainter::Antialiasing);
  const double left = area.left() + kLeft;
  const double width = area.width() - kLeft - kRight;
  double y = area.top();
  if (summary.session) {
    const QRectF band(left, y + kTitle, width, kStates);
    drawStates(painter, band, summary, style);
    drawMoveNumbers(painter, band, summary, style);
    y = band.bottom() + kGap;
  }
  Plots plots(painter, summary, style);
  const std::vector<Row> rows = plots.rows();
  double shares = 0.0;
  for (const Row& row : rows) shares += row.share;
  const double each = (area.bottom() - kTimes - y - static_cast<double>(rows.size()) * (kTitle + kGap) + kGap) / shares;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const QRectF inside(left, y + kTitle, width, rows[i].share * each);
    rows[i].draw(inside, i + 1 == rows.size());
    y = inside.bottom() + kGap;
  }
  if (summary.session) drawLegend(painter, QPointF(left, area.bottom() - 17), summary, style);
}

}  // namespace stillcut::ui
