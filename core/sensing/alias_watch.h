// Lines that a missing anti-alias filter let in: an order n of the spindle above half the rate F_s is folded to
// |k F_s - n f_sp|, between the harmonics, where it looks like chatter. At one speed nothing tells it from a line that
// is there. Where the speed changes it goes n times as far, to the next folded place of the same order, and nothing
// else does: chatter f_c + m f_tp that moved as fast would have to begin at k F_s.
// So the strongest line between the harmonics is looked at whenever the speed has moved; found, once it stood on the
// folded place of one and the same order before and after several moves that each went further than its own doubt.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/dsp/harmonic_mask.h"
#include "core/dsp/spectrum.h"
#include "core/sensing/conditioned_block.h"

namespace stillcut::detect {

class AliasWatch {
 public:
  void prepare(int channels, Hertz rate);
  void reset() noexcept;
  // Samples were lost: a stretch that was begun is dropped.
  void interrupt() noexcept { fill_ = 0; }
  void push(const ConditionedBlock& block, bool inCut) noexcept;

  // The line that folds, and the order that it is; order 0: none.
  struct Folded {
    Hertz line{};
    int order = 0;
  };
  Folded folded(int channel) const noexcept { return channels_[static_cast<std::size_t>(channel)].folded; }

 private:
  // One way to fold: n f_sp = k F_s -+ f.
  struct Fold {
    int order = 0;         // 0: nothing stands there
    double spindle = 0.0;  // where it was last seen to have moved to [Hz]
    int moves = 0;
    int misses = 0;
  };
  struct AliasChannel {
    std::vector<double> samples;
    std::array<Fold, 4> folds;  // k = 1, 1, 2, 2
    Folded folded;
  };
  bool begin(const ConditionedBlock& block) noexcept;
  void look(AliasChannel& c) noexcept;
  bool hidden(double line) const noexcept;
  void follow(Fold& fold, double place) const noexcept;

  dsp::kernels::Kernels kernels_;
  dsp::Spectrum spectrum_;
  HarmonicMask mask_;
  std::vector<double> power_;
  std::vector<AliasChannel> channels_;
  double rate_ = 0.0;
  std::size_t window_ = 0;
  std::size_t fill_ = 0;    // frames of the stretch
  std::size_t looked_ = 0;  // channels looked at since it was full
  long waited_ = 0;         // frames since the last stretch
  double lookSpindle_ = 0.0;
  double low_ = 0.0, high_ = 0.0, sum_ = 0.0;  // of the spindle's frequency over the stretch
  double mean_ = 0.0, doubt_ = 0.0;
};

}  // namespace stillcut::detect
