// ShareTest: full chatter told by what stands off the spindle's orders alone (core/detect/MODEL.md, "Level"). It needs
// nothing that was learned before, so that chatter which is there from the entry on is heard, and nothing that was
// learned can raise its limit.
//
// A look counts where one speed is likely, where a tooth passing is heard, which the tool makes by cutting, where there
// are enough lines to tell two series apart, and where all that was looked at is of one cut at one speed.
// Thread: worker; real-time.
#pragma once

#include "core/spindle/series_watch.h"

namespace stillcut::detect {

class ShareTest {
 public:
  // Part of the line power off the orders, of the channel that has the most, from which a cut is in full chatter. Real
  // recordings: 0 to 0.3 in stable cuts, 0.37 to 1 in chatter.
  static constexpr double kFull = 0.35;

  // ... and of all channels of its quantity together, so that a weak axis, whose noise makes lines as well, says
  // nothing against two strong ones: 0 to 0.07 in real stable cuts, 0.22 to 1 in real chatter.
  static constexpr double kJoint = 0.15;

  void reset() { *this = {}; }
  // An alarm ended as the vibration went: looks whose window reaches back before now still hold it.
  void skipStale();
  // After every step; what it says changes with a new look only.
  void see(const SeriesLook& look);

  bool full() const { return above_ >= kLooks; }  // two looks on end
  bool lasts() const { return alarmed_; }         // since it was, not two below half of that
  double share() const { return share_; }         // of the newest look that counts
  Hertz line() const { return line_; }

 private:
  static constexpr int kLooks = 2;        // they overlap by three quarters; one may hold a knock
  static constexpr double kEnds = 0.5;    // of kFull: chatter that beats goes through its lows
  static constexpr double kLikely = 0.6;  // that the speed is the one by which the share is taken
  // Orders: a spindle that slows by 0.3 % within what was looked at leaves the lines of its tenth order so far from it.
  static constexpr double kLeastOffset = 0.03;
  static constexpr int kFewestLines = 4;  // a spindle's series of two, and chatter with a side line

  // Looks on end that tell nothing: two windows.
  static constexpr int kMostUncounted = 2 * SeriesWatch::kLooksPerWindow;

  unsigned seen_ = 0;
  int stale_ = 0;  // looks to come that reach back before the vibration went
  int above_ = 0, below_ = 0, uncounted_ = 0;
  bool alarmed_ = false;
  double share_ = 0.0;
  Hertz line_{};
};

}  // namespace stillcut::detect
