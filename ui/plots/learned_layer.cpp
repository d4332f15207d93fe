#include "ui/plots/learned_layer.h"

#include <QLineF>
#include <algorithm>
#include <utility>

#include "ui/base/format.h"
#include "ui/plots/lobe_marks.h"

namespace stillcut::ui {
namespace {

constexpr double kDarkest = 0.5;   // of the tone, where chatter is certain: limit, grid and dots stay in sight
constexpr double kDot = 6.0;       // radius, before scaling
constexpr double kTouched = 20.0;  // how near counts as on a dot: a finger covers it

}  // namespace

void LearnedLayer::set(std::shared_ptr<const LearnedLobes> learned) {
  learned_ = std::move(learned);
  shade();
}

void LearnedLayer::applyTheme(const Theme& theme) {
  theme_ = theme;
  shade();
}

void LearnedLayer::shade() {
  shading_ = {};
  if (learned_ == nullptr || learned_->speeds.empty() || learned_->depths.empty()) return;
  const auto wide = learned_->speeds.size(), high = learned_->depths.size();
  shading_ = QImage(static_cast<int>(wide), static_cast<int>(high), QImage::Format_ARGB32);
  QColor color = theme_.back(Tone::Chatter);
  for (std::size_t x = 0; x < wide; ++x) {
    for (std::size_t y = 0; y < high; ++y) {
      color.setAlphaF(static_cast<float>(kDarkest * std::clamp(1.0 - learned_->at(x, y), 0.0, 1.0)));
      shading_.setPixelColor(static_cast<int>(x), static_cast<int>(high - 1 - y), color);
    }
  }
}

// A pixel of the shading reaches half a step to either side of its speed, and from the depth above to its own.
void LearnedLayer::draw(QPainter& p, const Map& map) const {
  if (learned_ == nullptr) return;
  if (!shading_.isNull() && learned_->speeds.size() > 1) {
    const Rpm half = (learned_->speeds[1] - learned_->speeds[0]) * 0.5;
    const Metres between = learned_->depths.front() * 0.5;
    const QRectF box(map({learned_->speeds.front() - half, learned_->depths.back() + between}),
                     map({learned_->speeds.back() + half, between}));
    p.setRenderHint(QPainter::SmoothPixmapTransform);
    p.drawImage(box, shading_);
    drawLine(p, map, 0.9, Qt::DashLine);
    drawLine(p, map, 0.5, Qt::SolidLine);
    drawLine(p, map, 0.1, Qt::DotLine);
  }
  for (const LearnedCut& cut : learned_->cuts) drawCut(p, map(cut.at), cut.chatter);
}

// At each speed the deepest cut that is stable with at least this probability; it falls with the depth.
void LearnedLayer::drawLine(QPainter& p, const Map& map, double probability, Qt::PenStyle style) const {
  QPolygonF line;
  for (std::size_t x = 0; x < learned_->speeds.size(); ++x) {
    std::size_t y = 0;
    while (y < learned_->depths.size() && learned_->at(x, y) >= probability) ++y;
    const double above = y == 0 ? 1.0 : learned_->at(x, y - 1);
    const Metres from = y == 0 ? Metres{} : learned_->depths[y - 1];
    const bool open = y == learned_->depths.size();
    const double fall = open ? 0.0 : above - learned_->at(x, y);
    const double share = fall > 0.0 ? (above - probability) / fall : 0.0;
    line << map({learned_->speeds[x], from + learned_->depths.front() * share});
  }
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(theme_.colors.chatterText, theme_.px(1.5), style));
  p.drawPolyline(line);
  if (line.isEmpty()) return;
  p.setFont(theme_.font(type_size::kTick, true));
  const QString text = percent(probability);
  const QRectF plot = p.clipBoundingRect();
  const double wide = p.fontMetrics().horizontalAdvance(text);
  const double x = plot.right() - wide - theme_.px(3);
  const auto end = std::ranges::find_if(line, [x](const QPointF& at) { return at.x() >= x; });
  p.drawText(QPointF(x, (end == line.end() ? line.back() : *end).y() - theme_.px(3)), text);
}

void LearnedLayer::drawCut(QPainter& p, const QPointF& at, bool chatter) const {
  const double radius = theme_.px(kDot);
  p.setPen(QPen(theme_.colors.panel, theme_.px(1.5)));
  if (chatter) {
    p.setBrush(theme_.back(Tone::Chatter));
    p.drawPolygon(cornered(at, radius, 8));
    return;
  }
  p.setBrush(theme_.colors.text);
  p.drawEllipse(at, radius, radius);
  p.setBrush(theme_.colors.panel);
  p.setPen(Qt::NoPen);
  p.drawEllipse(at, 0.5 * radius, 0.5 * radius);
}

const LearnedCut* LearnedLayer::cutAt(const QPointF& at, const Map& map) const {
  if (learned_ == nullptr) return nullptr;
  const LearnedCut* found = nullptr;
  double least = theme_.px(kTouched);
  for (const LearnedCut& cut : learned_->cuts) {
    const double away = QLineF(map(cut.at), at).length();
    if (away > least) continue;
    least = away;
    found = &cut;
  }
  return found;
}

}  // namespace stillcut::ui
