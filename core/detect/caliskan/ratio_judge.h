// RatioJudge: from the energy-ratio detector's numbers to the state of the cut, hop by hop: air, stable, onset,
// chatter. Chatter from the entry is entry_chatter.h, its line and doubt chatter_line.h. Thread: worker; real-time.
#pragma once

#include <array>
#include <span>

#include "core/detect/caliskan/chatter_line.h"
#include "core/detect/caliskan/entry_chatter.h"
#include "core/detect/caliskan/ratio_hop.h"
#include "core/detect/growth/calm_watch.h"
#include "core/detect/share_test.h"
#include "core/model/verdict.h"

namespace stillcut::detect {

class RatioJudge {
 public:
  void prepare(int teeth, double chatterRatio);
  // Forgets the cut and all that belongs to it. The channels' own floors are the caller's.
  void leaveCut();
  // What is followed through the signal begins anew, in the same cut.
  void restart() {
    entry_.restart();
    growsFor_ = notGrowing_ = 0.0;
  }
  void setState(CutState state) { state_ = state; }
  void loseFloor() { calm_.loseFloor(); }

  // True when an alarm ended: floors are to be learned anew.
  bool judge(std::span<RatioChannel> channels, LineFinder& lines, const RatioHop& hop);
  void addFeed(double metres) { feedSinceOnset_ += metres; }

  CutState state() const { return state_; }
  // Ratio of full chatter in the channel that is furthest beyond what it may be, and whether that is more than was set.
  double full() const { return full_; }
  bool usualIsHigh() const { return full_ > chatterRatio_; }
  bool alarming() const { return state_ == CutState::Onset || state_ == CutState::Chatter; }
  // State, severity, frequency, kind, reason and indicators of a valid verdict whose time and phase are set.
  void fill(Verdict& v, Hertz spindle) const;

 private:
  void gather(std::span<const RatioChannel> channels);
  void gatherRatio(const RatioChannel& c);
  bool toolLeaves(std::span<const RatioChannel> channels, CutPhase phase);
  void weigh(const EnergyGrowth& growth);
  void gatherGrowth(const RatioChannel& c, int& risingHops);
  bool lineCounts(Hertz line, Hertz spindle) const;
  bool lineGrows(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop);
  bool grows(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop);
  bool growsLongEnough(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop);
  bool lineIsNew(std::span<const RatioChannel> channels, Hertz line, Hertz spindle) const;
  void follow(LineFinder& lines, const RatioHop& hop);

  int teeth_ = 0;
  double chatterRatio_ = 0.2;
  CutState state_ = CutState::AirCutting;
  CalmWatch calm_;
  EntryChatter entry_;
  ShareTest share_;
  bool byShare_ = false;      // the alarm is of what stands off the orders, and nothing was heard to grow
  ChatterLine line_;          // of the alarm
  double severity_ = 0.0;     // of the channel that is furthest beyond what it may be,
  double full_ = 0.0;         // ... which is this to be full chatter,
  double limit_ = 0.0;        // ... or that to stay so,
  double over_ = 0.0;         // ... and what it is over, in full chatter
  double worst_ = 0.0;        // of any channel
  bool quiet_ = true;         // none is over what full chatter may become less to
  bool wasFull_ = false;      // chatter once, in this alarm and of this line
  double joint_ = 0.0;        // of all channels of a quantity together, by their levels
  double changed_ = 0.0;      // of the channel with the strongest evidence
  double mostChanged_ = 0.0;  // turn difference, of any channel
  double mostGrown_ = 0.0;    // ... of those where it is growing
  double evidence_ = 0.0;
  double floor_ = 0.0;
  bool learned_ = false;
  std::array<double, kMaxChannels> alarmEnergy_{};  // that does not repeat, of each channel, while an alarm lasts
  bool grown_ = false;                              // of any channel
  bool growing_ = false;                            // the difference of any, and neither a blow nor what is left of one
  bool newsGrowing_ = false;                        // the same of the news
  bool forced_ = false;                             // most of the forced vibration is a resonance, in any channel
  bool rising_ = false;                             // ... so fast that no spectrum is waited for
  std::array<int, kMaxChannels> risingHops_{};      // on end, of each channel
  double growsFor_ = 0.0, notGrowing_ = 0.0;        // s, before an alarm
  double onOrder_ = 0.0;   // where chatter on or near a spindle order stands, in orders; 0: none
  bool doubling_ = false;  // ... and it is period doubling
  double purity_ = 0.0;    // of the line that was looked at last
  double sinceOnset_ = 0.0;
  double feedSinceOnset_ = 0.0;
};

}  // namespace stillcut::detect
