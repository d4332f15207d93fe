// The newest seconds of every channel's samples, in SI units, with the gaps between them. Plain values, GUI thread.
#pragma once

#include <deque>
#include <vector>

#include "core/model/cut_setup.h"
#include "core/model/sample_block.h"

namespace stillcut::ui {

// Lowest and highest sample of a stretch of time; absent where nothing was measured.
struct Extent {
  float low = 0.0F, high = 0.0F;
  bool present = false;
};

class SignalHistory {
 public:
  static constexpr Seconds kKept{30.0};

  // Forgets everything; the scales make SI of what add() brings.
  void prepare(const CutSetup& setup);
  void add(const SampleBlock& block);

  int channels() const { return static_cast<int>(samples_.size()); }
  bool empty() const { return pieces_.empty(); }
  Instant begin() const;
  Instant end() const;

  // [from, to] in `count` equal steps. An unknown channel: nothing present.
  std::vector<Extent> extents(int channel, Instant from, Instant to, int count) const;
  struct Gap {
    Instant from{}, to{};
  };
  std::vector<Gap> gaps() const;

 private:
  // Samples that follow each other on one straight line of time.
  struct Piece {
    Instant time{};
    std::uint64_t first = 0;  // counts frames since prepare()
    std::uint64_t count = 0;
    bool afterGap = false;  // samples were lost; else time has drifted, or the screen was late
  };
  Instant endOf(const Piece& piece) const;
  void forget();

  double rate_ = 0.0;
  std::size_t capacity_ = 0;  // frames
  std::uint64_t frames_ = 0;  // ever taken in
  std::vector<double> scales_;
  std::vector<std::vector<float>> samples_;  // [channel][frame % capacity_]
  std::deque<Piece> pieces_;
  Instant newest_{};  // end of the newest block, as it was stamped
};

}  // namespace stillcut::ui
