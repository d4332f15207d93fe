// SeriesWatch: looks at the lines of every channel a few times a second, and says which spindle speed they belong to
// and how much of each channel stands off its orders (two_series.h, speed_belief.h; core/detect/MODEL.md).
//
// Lines that were there before the cut, as strong, are the machine's: fans, pumps, mains. What was heard in the air
// says nothing of the speed: there the machine's own lines are louder than the spindle's. Thread: worker; everything
// but prepare() is real-time.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/dsp/frame_ring.h"
#include "core/dsp/spectrum.h"
#include "core/model/cut_setup.h"
#include "core/model/sensor_status.h"
#include "core/spindle/line_list.h"
#include "core/spindle/speed_belief.h"
#include "core/spindle/two_series.h"

namespace stillcut::detect {

// The newest look.
struct SeriesLook {
  unsigned count = 0;         // of looks so far: a new one has another number
  Hertz spindle{};            // the most likely speed; 0: nobody told one, or nothing was heard
  double sd = 0.0;            // relative
  double certainty = 0.0;     // probability that it is this one
  bool certain = false;       // no other speed is likely
  bool teethHeard = false;    // a line stands at a multiple of the tooth passing: the tool cuts
  double explained = 0.0;     // of the lines' weight, by the two series at the most likely speed
  int lines = 0;              // that are not the machine's, of all channels
  int seriesLines = 0;        // ... that stand on the orders of the most likely speed, or make a family beside them
  bool familyStands = false;  // most of the line power is one family off the orders, beside a tooth passing
  bool familyLeads = false;   // ... among the orders that blows of teeth make: it is cut
  bool whole = false;         // all that was looked at is of one cut, ...
  bool leaving = false;       // ... which becomes quieter, as where the tool leaves
  bool steady = true;         // the speed was the same in all that was looked at
  bool agreed = true;         // a speed that was found far from the told one is this one
  int channel = 0;            // the one furthest off the orders,
  double joint = 0.0;         // the share in all channels of its quantity together, by their powers
  FreeFamily free;            // ... and what is there; its share is the least that the likely speeds leave
};

class SeriesWatch {
 public:
  static constexpr int kLooksPerWindow = 4;  // so many that follow one another share samples with the first

  // doubt: of the told speed at most, as a ratio.
  void prepare(const CutSetup& setup, double doubt);
  void reset() noexcept;
  // What is remembered is of another speed, or lies before a gap.
  void interrupt() noexcept { remembered_ = 0; }
  void beginCut() noexcept;

  // Conditioned samples, channel c at samples[c], all equally far apart; air: no tool cuts.
  void push(const double* const* samples, int frames, bool air) noexcept;
  // The speed that is followed by the phases of the forced vibration, far from the told one; 0: none is.
  void compare(Hertz followed) noexcept;
  bool due() const noexcept { return remembered_ >= window_ && since_ >= hop_; }
  // Where the tone of an axis drive stands (core/sensing/drive_tone.h), by any channel; 0: none does. What is beside it
  // within kDriveRipple is the machine's in every channel.
  void setDrives(std::span<const double> hertz) noexcept;
  // told: the speed around which to look. sd: its doubt, relative.
  void look(Hertz told, double sd) noexcept;
  // A cut fills all that is remembered, as one that nothing quieter preceded does.
  void allIsCut() noexcept { inCut_ = remembered_; }

  const SeriesLook& newest() const noexcept { return look_; }

 private:
  void learnAir() noexcept;
  void markMachines(std::size_t channel) noexcept;
  bool besideDrive(Hertz line) const noexcept;
  void gather(Hertz told) noexcept;
  void judge(Hertz told) noexcept;
  void judgeFamily() noexcept;
  void watchSpeed(Hertz newest) noexcept;
  double expectedShare(std::size_t channel, Hertz told) const noexcept;

  int channels_ = 0;
  std::vector<SensorQuantity> quantities_;
  int teeth_ = 0;
  double rate_ = 0.0;
  double doubt_ = 0.03;
  long window_ = 0, hop_ = 0;  // frames
  long remembered_ = 0, since_ = 0, inAir_ = 0, inCut_ = 0;
  double centre_ = 0.0;  // Hz, of the belief
  FrameRing heard_;
  dsp::Spectrum spectrum_;
  std::vector<std::vector<double>> powers_;  // of the newest look, by channel
  std::vector<std::vector<double>> air_;     // the most of each bin that was heard in the air, by channel
  bool airHeard_ = false;
  static constexpr std::size_t kLevels = 8;
  std::array<double, kLevels> levels_{};  // power of the lines of the last looks
  std::array<double, kLevels> forced_{};  // ... on the orders
  static constexpr std::size_t kSpeeds = kLooksPerWindow;
  std::array<double, kSpeeds> speeds_{};       // Hz, of the looks of a window
  std::array<double, kMaxChannels> drives_{};  // Hz
  std::vector<LineList> lists_;
  TwoSeries series_;
  SpeedBelief belief_;
  SeriesLook look_;
};

}  // namespace stillcut::detect
