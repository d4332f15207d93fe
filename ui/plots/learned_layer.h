// What was learned from judged cuts, as a layer of the stability diagram: the probability of chatter as shading, lines
// where a stable cut is probable with 90, 50 and 10 %, and a dot for every judged cut. GUI thread.
#pragma once

#include <QImage>
#include <QPainter>
#include <functional>
#include <memory>

#include "ui/base/theme.h"
#include "ui/facade/learned_lobes.h"

namespace stillcut::ui {

class LearnedLayer {
 public:
  using Map = std::function<QPointF(SpeedDepth)>;  // onto what is painted; linear along both axes

  // Null: nothing is drawn.
  void set(std::shared_ptr<const LearnedLobes> learned);
  void applyTheme(const Theme& theme);
  // `p` is clipped to the plot.
  void draw(QPainter& p, const Map& map) const;
  // The judged cut whose dot is there, the nearest; null: none.
  const LearnedCut* cutAt(const QPointF& at, const Map& map) const;

 private:
  void shade();
  void drawLine(QPainter& p, const Map& map, double probability, Qt::PenStyle style) const;
  void drawCut(QPainter& p, const QPointF& at, bool chatter) const;

  Theme theme_ = makeTheme(ThemeKind::Light, 1.0);
  std::shared_ptr<const LearnedLobes> learned_;
  QImage shading_;  // a pixel for each speed and depth, the deepest on top
};

}  // namespace stillcut::ui
