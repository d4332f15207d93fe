// The heat map of a stretch of history as a picture, one pixel column for each instant of a fixed grid, so that a
// picture that follows the cut is moved along and only what is new is painted. Where several spectra fall on one pixel
// the strongest counts; where none is, the gap's colour stays. GUI thread.
#pragma once

#include <QImage>
#include <QSize>
#include <array>
#include <vector>

#include "ui/models/history/run_history.h"

namespace stillcut::ui {

struct HeatWindow {
  QSize size;
  Instant from{};
  Seconds span{};
  Hertz low{}, high{};
  bool order = false;                    // every column stretched by its own spindle speed against the newest
  bool linear = false;                   // amplitude instead of decibel
  double low_dB = -80.0, high_dB = 0.0;  // ends of the palette
  QRgb gap = 0;
};

class HeatImage {
 public:
  const QImage& draw(const RunHistory& history, const HeatWindow& window);
  // Pixel columns painted by the last draw().
  int painted() const { return painted_; }

 private:
  using Levels = std::array<float, kSpectrumBins>;
  std::int64_t pixelOf(Instant t) const;
  bool moveAlong(const HeatWindow& window, Hertz spindle, Hertz top);
  void fitRows(double stretch, Hertz top);
  void paint(const Levels& levels, std::int64_t from, std::int64_t to);

  HeatWindow window_;
  Hertz spindle_{}, top_{};
  QImage image_;
  std::int64_t first_ = 0;  // pixel of the grid at the left edge
  std::int64_t next_ = 0;   // first pixel not painted for good
  double stretch_ = -1.0;
  std::vector<int> bins_;  // lower bin of every row from the top, one more at the end
  int painted_ = 0;
};

// Seconds between columns where nothing is missing: the smallest distance among the newest.
double columnHop(const std::deque<SpectrumColumn>& columns);

}  // namespace stillcut::ui
