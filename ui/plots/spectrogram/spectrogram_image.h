// The picture of a spectrogram: one pixel column per spectrum column, newest at the right edge. A column's place
// follows its time stamp, so lost samples and missed columns leave a gap as long as they lasted. GUI thread.
#pragma once

#include <QImage>
#include <deque>
#include <vector>

#include "core/model/snapshot.h"
#include "ui/base/theme.h"
#include "ui/plots/spectrogram/level_range.h"

namespace stillcut::ui {

class SpectrogramImage {
 public:
  // One place in time, oldest first in cells().
  struct Cell {
    bool present = false;         // false: samples or columns are missing here
    bool afterGap = false;        // samples were lost just before it, even if less than one column
    Tone alarm = Tone::Normal;    // Onset or Chatter: what the verdict was then
    std::vector<float> level_dB;  // kSpectrumBins, empty when not present
  };

  explicit SpectrogramImage(Seconds span) : span_(span) {}

  // Frequencies 0 .. visibleTop on `rows` pixels; `spectrumTop` is the upper edge of the last bin.
  void setAxis(int rows, Hertz visibleTop, Hertz spectrumTop);
  void append(const SpectrumColumn& column, Tone alarm);
  void clear();

  // capacity() x rows; null until two columns have told how far apart columns are.
  const QImage& image() const { return image_; }
  const std::deque<Cell>& cells() const { return cells_; }
  int capacity() const { return capacity_; }
  Seconds period() const { return period_; }
  Seconds span() const { return span_; }
  const LevelRange& range() const { return range_; }
  void setGapColor(QRgb color);

 private:
  void push(Cell cell);
  void start(const SpectrumColumn& second);
  void paintAll();
  void paintCell(int x, const Cell& cell);
  void scrollLeft();

  Seconds span_;
  Seconds period_{};
  int capacity_ = 0;
  int rows_ = 0;
  std::vector<int> firstBin_;  // of every row, from the top; one more at the end
  std::deque<Cell> cells_;
  SpectrumColumn last_;
  Tone lastAlarm_ = Tone::Normal;
  bool hasLast_ = false;
  LevelRange range_;
  QImage image_;
  QRgb gapColor_ = 0;
};

}  // namespace stillcut::ui
