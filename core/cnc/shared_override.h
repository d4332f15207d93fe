// SharedOverride: an override that has one register for everybody. The operator's pendant and we write the same
// percentage, so our factor must be told apart from the operator's: the base is what stood there before us, ours
// multiplies it, and any value that shows up without our having sent it is the operator's hand. Then ours is over: the
// new value is the base, and nothing is sent until the engagement that was running has ended. LinuxCNC's feed and
// spindle override work so, and GRBL's.
// The limits bound what we ask for, never what the operator chose: a base beyond a limit stays where it is.
// Thread: link thread. Real-time safe.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut::cnc {

class SharedOverride {
 public:
  struct Manners {
    // How often on end a foreign value must be read to be a hand: 2 where a report may be false. While one is doubted
    // nothing is sent, and a hand that gives way within seconds to the value of ours that stood there was none.
    int sightings = 1;
    // What was sent and has not shown when a hand does may show after it all the same, and goes home to the hand then.
    bool lateAfterHand = true;
    // What was sent shows in the order in which it was sent: a value older than one that has shown is a hand.
    bool inOrder = true;
    // Until a value that was sent shows; what has not shown by then is lost. LinuxCNC was seen to take up to 4.7 s.
    Duration latestEcho = std::chrono::seconds(6);
  };
  // Percentages that we may ask for.
  SharedOverride(int lowest, int highest) : SharedOverride(lowest, highest, Manners()) {}
  SharedOverride(int lowest, int highest, const Manners& manners)
      : lowest_(lowest), highest_(highest), manners_(manners) {}

  static constexpr int kNoCap = 1000;
  // The peer takes no more than this, %: nothing above it is asked for.
  void cap(int highest) noexcept { cap_ = highest; }

  // The register was read: `percent`. Values that we sent may show up late (Manners::latestEcho).
  void seen(int percent, Instant now) noexcept;
  // Our factor on the base, of engagement `engagement`; ignored while the operator's hand has ended that engagement.
  void want(Ratio factor, std::uint64_t engagement) noexcept;
  // The base comes back; what was sent is forgotten once it has been seen.
  void relinquish() noexcept;
  // A percentage that should be sent now, because the register shows or was last sent another; none before the
  // register has been seen once. Say sent() when it went out.
  std::optional<int> due() const noexcept;
  void sent(int percent, Instant now) noexcept;
  // Nothing could show for so long, because nothing came: what was sent may show that much later.
  void blind(Duration time, Instant now) noexcept;
  // The peer refused: what was sent is not on its way.
  void refused() noexcept;
  // The connection broke: the register must be seen again before anything is sent. What we ever sent on this base is
  // still ours then, however long it has stood: nobody saw whose hand it was, and home is what the operator chose last.
  void lost() noexcept;
  // What the register shows was left by a program of ours that died; `base` is what its operator had. Ignored before
  // the register has been seen, and once anything was sent. due() is then the way home.
  void adopt(Ratio base) noexcept;
  // The peer began anew, with values of its own: as lost(), but nothing that stands there is taken for ours.
  void restarted() noexcept;

  // Nothing of ours stands in the register, or all that is left is on its way out.
  bool atBase() const { return nothingSent() || (shown_ && underway_.value_or(*shown_) == base_); }
  // The base itself was seen, and nothing is on its way.
  bool baseConfirmed() const { return nothingSent() || (shown_ == base_ && !underway_ && !doubted_); }
  // All that was sent has been seen, or was given up.
  bool settled() const { return !underway_; }
  // How long what was sent last has not shown; 0: it has.
  Duration unseen(Instant now) const {
    return underway_ ? now - sent_[(sentCount_ - 1) % sent_.size()].when : Duration::zero();
  }
  bool known() const { return shown_.has_value(); }
  // A foreign value was read, and not often enough to be a hand: the next reading decides.
  bool doubted() const { return doubted_.has_value(); }
  int shown() const { return shown_.value_or(100); }
  // Where it should stand: the base times our factor, within the limits, and not beyond the base the other way.
  int target() const noexcept;
  // The operator's hand has ended the engagement that is running.
  bool grabbed() const { return grabbed_; }
  // The operator's part, 1.0 is 100 %.
  Ratio base() const { return Ratio(base_ * 0.01); }

 private:
  struct Sent {
    int percent = 0;
    Instant when{};
  };
  bool nothingSent() const { return sentCount_ == firstOnBase_ && !lateEchoShown_; }
  bool takeEcho(int percent, Instant now) noexcept;
  bool sentOnBase(int percent) const noexcept;
  void takeHand(int percent) noexcept;
  bool undoHand(int percent, Instant now) noexcept;

  int lowest_, highest_;
  int cap_ = kNoCap;
  Manners manners_;
  std::optional<int> shown_;
  std::optional<int> doubted_;  // a foreign value that has been read, but not often enough
  int timesDoubted_ = 0;
  bool doubtedOverOurs_ = false;  // a factor of ours was wanted when it was read first
  std::optional<int> underway_;   // sent, not seen yet
  int base_ = 100;
  double factor_ = 1.0;
  std::uint64_t engagement_ = 0;
  bool grabbed_ = false;
  bool rejoining_ = false;         // lost, and not seen since
  std::array<Sent, 64> sent_{};    // a ring
  std::uint64_t sentCount_ = 0;    // ever
  std::uint64_t firstOnBase_ = 0;  // number of the first that was sent on this base
  std::uint64_t unseen_ = 0;       // number of the first that has not shown yet
  struct BeforeHand {
    int shown = 0, base = 0;
    double factor = 1.0;  // wanted then, or since
    bool grabbed = false;
    std::uint64_t firstOnBase = 0;
    Instant taken{};
  };
  std::optional<BeforeHand> beforeHand_;  // where a reading may lie
  bool lateEchoShown_ = false;            // of ours, sent before the hand that chose this base
};

}  // namespace stillcut::cnc
