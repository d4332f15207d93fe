// Whether the sensors can be believed over tenths of seconds; what one block shows is input_check.h's. Always on. A
// channel that cannot be believed is left out (left_out.h); a rate that cannot makes the verdicts invalid.
//
// Every channel is looked at in windows of a tenth of a second, 256 samples at the least:
//   loose mount      in the cut, much of the energy lies in knocks at no fixed spindle angle (knock_finder.h),
//                    three windows long
//   broken cable     falls silent in the cut while another channel goes on, or at once (cable_watch.h)
//   dead             a force, current or displacement stands still while others of its kind are in the cut
//   offset           the mean has left its place by more than anything the channel has shown, and more than gravity
//                    can turn: a sensor of what changes (acceleration, velocity, sound) has lost its bias. An
//                    accelerometer that starts that far from zero is off from its first second on
//   mains hum        more than half of what is there (hum_watch.h)
//   noise            white and loud, with no structure in it: no cut is
//   same axis twice  two axes deliver the same (pair_watch.h)
//   values repeated  each sample comes two to eight times: a lower rate was stretched (repeat_watch.h)
//   wrong rate       against the clock (rate_watch.h): a device's first seconds are not believed until its rate is
//                    known. Of a device joined to the first, its source says so (daq/joined_source.h)
//   aliased          a line between the harmonics goes with the speed as a folded order does (alias_watch.h)
// Which of two axes is x cannot be told from a cut: the forces turn with the tool and both axes hear the same lines at
// strengths that tool, feed direction and structure decide. Knocks tell it when sensors are set up (daq/axis_knock.h).
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <cstdint>
#include <vector>

#include "core/dsp/finding.h"
#include "core/dsp/rate_watch.h"
#include "core/dsp/repeat_watch.h"
#include "core/model/cut_setup.h"
#include "core/model/sample_block.h"
#include "core/model/sensor_status.h"
#include "core/sensing/alias_watch.h"
#include "core/sensing/cable_watch.h"
#include "core/sensing/conditioned_block.h"
#include "core/sensing/cut_gate.h"
#include "core/sensing/hum_watch.h"
#include "core/sensing/input_check.h"
#include "core/sensing/knock_finder.h"
#include "core/sensing/pair_watch.h"

namespace stillcut::detect {

class SensorCheck {
 public:
  void prepare(const CutSetup& setup);
  void reset() noexcept;
  // A block that cannot be used at all: what was collected is dropped, what was found stands.
  void interrupt(const SampleBlock& raw, const Reason& why) noexcept;
  // The block as delivered and as conditioned, and what it shows of each channel. None: its rate can be believed;
  // each channel's own fault is in status().
  Reason check(const SampleBlock& raw, const ConditionedBlock& block, const InputCheck& input,
               const CutGate& gate) noexcept;

  const SensorStatus& status() const noexcept { return status_; }

 private:
  struct SensorChannel {
    SensorQuantity quantity = SensorQuantity::Acceleration;
    double scale = 1.0;
    std::vector<double> samples, before;  // of the window, conditioned, and of the one before it
    std::vector<std::uint8_t> angles;
    std::size_t fill = 0, length = 0, beforeFill = 0;
    double sum = 0.0;                   // as delivered [SI]
    double place = 0.0, largest = 0.0;  // usual mean, and the largest magnitude shown [SI]
    double peak = 0.0;                  // of the window before
    double seconds = 0.0;               // looked at so far
    KnockFinder knocks;
    HumWatch hum;
    dsp::RepeatWatch repeats;
    dsp::Finding loose, off, noise, still;
  };
  void begin() noexcept;
  void drop(int index) noexcept;
  Reason faultOfAll(const SampleBlock& raw) const noexcept;
  void take(const SampleBlock& raw, const ConditionedBlock& block, int index, const CutGate& gate) noexcept;
  void look(int index, const CutGate& gate) noexcept;
  void watchMean(SensorChannel& c, double mean, double peak) noexcept;
  void watchStill(int index, const CutGate& gate) noexcept;
  int windowsIn(double seconds) const noexcept;
  Reason faultOf(int index, const CutGate& gate) const noexcept;

  double windowSeconds_ = 0.1;
  std::size_t window_ = 0;
  std::vector<SensorChannel> channels_;
  CableWatch cable_;
  PairWatch pairs_;
  dsp::RateWatch rate_;
  AliasWatch alias_;
  SensorStatus status_;
};

}  // namespace stillcut::detect
