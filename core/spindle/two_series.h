// TwoSeries: how well the lines of a cut fit a spindle speed, where chatter may be among them.
//
// Model (core/detect/MODEL.md): forced vibration stands at whole orders n f_sp of the spindle. Chatter stands at
// f_c + k f_sp: a second series of the same spacing, at one offset from the first. Both are looked for together; the
// spacing is what tells the spindle from the chatter, and no single line decides, for a line counts by the logarithm
// of its power, from 0 at 30 dB below the strongest to 6.9.
//   score(f_sp) = sum_i w_i on_i + max(0, max over d of sum_i w_i (1 - on_i) at_i(d) - log 100)
// on_i: line i lies on an order, a Gaussian of its distance over its doubt; at_i(d): its order's fraction is d. The
// second series pays for the choice among a hundred offsets, or a single loud line would always find one of its own.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/units.h"
#include "core/spindle/line_list.h"

namespace stillcut::detect {

// What does not stand on the spindle's orders, of one channel.
struct FreeFamily {
  double power = 0.0;   // off the orders, as the spectrum gives it
  double share = 0.0;   // of the power of all lines that are not the machine's, 0..1
  Hertz line{};         // the strongest of them; 0: none
  double offset = 0.0;  // of that line from the nearest order, in orders, -0.5..0.5
  int members = 0;      // lines whole orders away from it, itself included, no weaker than 20 dB below it
};

class TwoSeries {
 public:
  // Forgets the lines. doubt: to which a line's frequency is known.
  void begin(Hertz doubt) noexcept;
  // The lines of one channel; those that are the machine's do not count. What several channels receive is one line of
  // the cut, and counts once, as where it is strongest. At most kMostLines in all are taken.
  void add(std::span<const SpectralLine> lines) noexcept;
  int lines() const noexcept { return static_cast<int>(count_); }

  struct Fit {
    double score = 0.0;   // nepers
    double offset = 0.0;  // of the second series, orders
  };
  Fit fit(Hertz spindle) const noexcept;
  // How many lines stand on orders of the spindle.
  int onOrders(Hertz spindle) const noexcept;
  // Part of the lines' weight that stands on one of the two series.
  double explained(Hertz spindle) const noexcept;
  // spindleDoubt: relative; a line at a high order is known to be on it to no better.
  FreeFamily freeOf(std::span<const SpectralLine> lines, Hertz spindle, double spindleDoubt) const noexcept;

 private:
  static constexpr std::size_t kMostLines = 192;
  static constexpr int kCells = 100;  // of an order
  struct Weighted {
    double frequency = 0.0;
    double weight = 0.0;
  };
  Weighted* heardBefore(double frequency, std::size_t others) noexcept;
  double onOrder(double frequency, double spindle, double relative) const noexcept;

  double doubt_ = 1.0;  // Hz
  std::array<Weighted, kMostLines> lines_{};
  std::size_t count_ = 0;
};

}  // namespace stillcut::detect
