// The true spindle speed and angle: told speed (machine or setup), corrected by a comb search on the cut, then held on
// the forced vibration turn by turn. While a machine that measures its speed changes it, the angle follows the
// machine's word, times the ratio of true to told speed found before. Reports its doubt.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <cstdint>

#include "core/dsp/frame_ring.h"
#include "core/model/cut_setup.h"
#include "core/model/machine_state.h"
#include "core/spindle/lone_line.h"
#include "core/spindle/phase_tracker.h"
#include "core/spindle/reported_speed.h"
#include "core/spindle/speed_motion.h"
#include "core/spindle/speed_search.h"
#include "core/spindle/speed_trend.h"

namespace stillcut::detect {

enum class SpeedSource : std::uint8_t { None, Nominal, Machine, Signal };

class SpeedTracker {
 public:
  static constexpr int kSearchChannels = 4;

  // searchRange: how far the told speed may be off, as a ratio (0.03).
  void prepare(const CutSetup& setup, double searchRange);
  void reset() noexcept;
  // After a gap the angle means nothing any more; the speed still holds.
  void restart() noexcept;

  // Before each block of so many frames, up to `end`: what the machine says.
  void setMachineState(const MachineState& machine, int frames, Instant end) noexcept;
  // A new cut began: what was found in the last one is only a hint.
  void beginCut() noexcept;
  // Conditioned samples of a block or a part of it, channel c at samples[c], all equally far apart; fills angle [rad,
  // wrapped] and step [rad] per frame.
  void advance(const double* const* samples, int frames, double* angle, double* step) noexcept;
  // At times that do not depend on how the stream is cut into blocks, `since` the last: searches where one is due.
  // leaving: the tool leaves the cut and takes the forced vibration along, so that a comb already found stays.
  void look(Seconds since, bool leaving) noexcept;

  // What the two line series of the cut say (series_watch.h): a speed that is certain is where the spindle is followed,
  // and no comb found elsewhere is the spindle's.
  void believe(Hertz spindle, double sd, bool certain) noexcept;
  // Around which they are to look, and its doubt as a ratio.
  Hertz centre() const noexcept;
  double centreSd() const noexcept;
  Hertz told() const noexcept { return Hertz(told_); }  // by machine or setup

  Hertz spindle() const noexcept { return Hertz(told_ * ratio_); }
  Hertz sd() const noexcept;
  SpeedSource source() const noexcept { return source_; }
  bool locked() const noexcept { return locked_; }
  // Told, or found in the signal and followed since.
  bool known() const noexcept { return spindle().value > 0.0 && (source_ != SpeedSource::Signal || trusted_); }
  // Without a lock (lone_line.h); 0: none.
  Hertz isolatedLine() const noexcept { return lone_.line(); }
  // The speed changes and the angle follows the machine's word. Where it follows the vibration, what it catches up of
  // its own lag is no turning of the spindle, and turns are told by the speed alone.
  bool riding() const noexcept { return motion_.riding(); }
  // ... faster than vibration can be compared from turn to turn, or it has moved away from what was followed.
  bool moving() const noexcept { return motion_.moving() || astray(); }
  // A tone that most of what is heard was, and that still is its strongest line; 0: none.
  Hertz suspect() const noexcept { return told_ > 0.0 && lone_.heard() ? lone_.suspect() : Hertz(); }
  // Forced vibration at the teeth was found, strong enough to call what is heard a cut.
  bool forced() const noexcept { return locked_ && toothPart_ > kForcedPart; }
  // The speed was found far from the told one.
  bool foundFar() const noexcept { return locked_ && far_ > 0.0; }
  double scatter() const noexcept { return tracker_.scatter(); }

 private:
  static constexpr double kForcedPart = 0.1;

  void forget() noexcept;
  void remember(const double* const* samples, int frames) noexcept;
  struct Look {  // one search and what it said last
    SpeedSearch search;
    SpeedCandidate last;
    FoundSpeed found;
    int agreeing = 0;    // times in a row that a wide search found the same
    long since = 0;      // frames since the last search
    double drift = 0.0;  // that is known, relative, per second
    double gone = 1.0;   // speed now over that in the middle of the window, by that drift
  };
  // Found while the spindle, followed before in this cut, was on its way past, and never followed since; or nothing
  // repeats any more, and what is not the strongest line is not on its comb.
  bool dead() const noexcept;
  // What was followed is no longer where it was.
  bool astray() const noexcept;
  void followMotion(double seconds) noexcept;
  // A speed that has never stood in this cut is looked for all the same, where it moves little in a window.
  bool seeksWhileRiding() const noexcept { return !locked_ && !motion_.moving(); }
  void ride(int frames, double* angle, double* step) noexcept;
  // Mean speed of the turn that has begun [rad/s].
  double turnToCome() const noexcept { return kTwoPi * (tracker_.spindle().value + 0.5 * tracker_.drift()); }
  void catchUp(double angle, double omega) noexcept;
  void lookIfDue(Look& look) noexcept;
  void judge(const Look& look, const SpeedCandidate& before) noexcept;
  void seek(Look& look) noexcept;
  void stepAside(const SpeedSearch& search) noexcept;
  bool believedElsewhere(Hertz spindle) const noexcept;
  void dropUntrusted() noexcept;
  bool believed(const Look& look) const noexcept;
  bool mayBeHum(Hertz spindle) const noexcept;
  void lock(Hertz spindle, Hertz sd, double drift = 0.0) noexcept;

  Look quick_;        // 12 turns: enough for a clean stable cut
  Look thorough_;     // 24 turns: chatter, noise; goes on watching after the lock
  SpeedTrend trend_;  // of what quick_ says
  PhaseTracker tracker_;
  int channels_ = 1;
  double rate_ = 0.0;
  double range_ = 0.03;
  int teeth_ = 0;
  double nominal_ = 0.0;  // Hz, from the setup
  ReportedSpeed machine_;
  SpeedMotion motion_;
  double told_ = 0.0;       // Hz, now
  double toldSd_ = 0.0;     // Hz, because it was read some time ago
  double ratio_ = 1.0;      // true over told
  double before_ = 0.0;     // Hz, told with the block before
  double toldFirst_ = 0.0;  // Hz, told when what is remembered began
  bool measured_ = false;
  SpeedSource source_ = SpeedSource::None;
  bool locked_ = false;
  bool proven_ = false;     // the comb of the lock carried most of the power
  bool returning_ = false;  // found again after it was lost, not yet followed cleanly
  bool followed_ = false;   // in this cut, cleanly
  bool trusted_ = false;    // told roughly, or followed cleanly
  double far_ = 0.0;        // Hz, where the speed was found that is far from the told one; 0: it is not
  Hertz believed_{};        // by the line series, the last time that they were certain
  int believedLooks_ = 0;   // on end in which they were
  double onComb_ = 1.0;     // of what is not the strongest line, where next to nothing repeats
  double toothPart_ = 0.0;
  LoneLine lone_;

  double angle_ = 0.0;
  double slew_ = 0.0;    // rad per frame, by which an angle error is caught up within a turn
  int blockFrames_ = 1;  // of the block that the machine's word came with
  int blockDone_ = 0;
  long inCut_ = 0;  // frames since the cut or the stream began
  FrameRing heard_;
};

}  // namespace stillcut::detect
