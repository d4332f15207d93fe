// RatioJudge: from the energy-ratio detector's numbers to the state of the cut, hop by hop: air, stable, onset,
// chatter; the chatter's line and its doubt. Thread: worker; real-time.
#pragma once

#include <array>
#include <span>

#include "core/detect/calm_watch.h"
#include "core/detect/energy_growth.h"
#include "core/detect/forced_resonance.h"
#include "core/detect/line_finder.h"
#include "core/detect/load_watch.h"
#include "core/detect/new_line.h"
#include "core/detect/order_growth.h"
#include "core/detect/turn_marks.h"
#include "core/model/channel.h"
#include "core/model/sensor_status.h"
#include "core/model/verdict.h"

namespace stillcut::detect {

struct RatioChannel {
  EnergyGrowth growth;  // of the turn difference
  EnergyGrowth news;    // of the news (turn_difference.h)
  OrderGrowth orders;
  ForcedResonance forced;
  LoadWatch load;
  double ratio = 0.0;  // ER, smoothed
  SensorQuantity quantity = SensorQuantity::Acceleration;
};

// One hop, as the detector saw it.
struct RatioHop {
  CutPhase phase = CutPhase::Air;
  Seconds length{};
  Hertz rate{};
  Hertz spindle{};
  Hertz spindleSd{};
  Hertz highest{};           // up to which harmonics are removed
  double steadyTurns = 0.0;  // since the cut became steady
  bool turnsCompare = true;  // false: the speed changes too fast to compare turns
  double levelTrend = 1.0;   // of the vibration (conditioned_block.h)
  const EnergyChain* chain = nullptr;
  NewLine* newLine = nullptr;        // has heard the vibration
  const TurnMarks* marks = nullptr;  // while a machine tells a change; null: none
  bool loneLine = false;             // a line that cannot be forced holds most of the vibration
};

// Does it hear an integral of the spindle's torque?
bool isIntegral(SensorQuantity q) noexcept;

class RatioJudge {
 public:
  static constexpr double kLineTurns = 16.0;  // window of the line finder
  // A line is looked at every half turn: its spectrum is 16 turns long and the dearest thing here.
  static constexpr int kLookHops = kHopsPerTurn / 2;
  // Energy ratio from which chatter is called by its side lines: a fifth of the vibration's amplitude. What else makes
  // a ratio, as noise, chips and lines that reach the sensor and not the tool, has none whole tooth passings beside it.
  static constexpr double kSidedRatio = 0.04;
  static constexpr double kSettleTurns = 6.0;  // after a restart the filters are not believed

  void prepare(int teeth, double chatterRatio) noexcept;
  // Forgets the cut and all that belongs to it. The channels' own floors are the caller's.
  void leaveCut() noexcept;
  // What is followed through the signal begins anew, in the same cut.
  void restart() noexcept { highTurns_ = 0.0; }
  void setState(CutState state) noexcept { state_ = state; }
  void loseFloor() noexcept { calm_.loseFloor(); }

  // True when an alarm ended: floors are to be learned anew.
  bool judge(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) noexcept;
  void addFeed(double metres) noexcept { feedSinceOnset_ += metres; }

  CutState state() const noexcept { return state_; }
  bool alarming() const noexcept { return state_ == CutState::Onset || state_ == CutState::Chatter; }
  // State, severity, frequency, kind, reason and indicators of a valid verdict whose time and phase are set.
  void fill(Verdict& v, Hertz spindle) const noexcept;

 private:
  static constexpr double kHysteresis = 0.5;  // chatter ends at this part of the ratio at which it began
  static constexpr double kOtherLine = 4.0;   // a line this much stronger than the one followed takes its place

  void gather(std::span<const RatioChannel> channels) noexcept;
  void learnCalm(std::span<const RatioChannel> channels) noexcept;
  bool aboveCalm(std::span<const RatioChannel> channels, const EnergyChain& chain) const noexcept;
  bool toolLeaves(std::span<const RatioChannel> channels, CutPhase phase) noexcept;
  void weigh(const EnergyGrowth& growth) noexcept;
  void gatherGrowth(const RatioChannel& c, int& risingHops) noexcept;
  bool fromEntry(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) noexcept;
  bool lineHasSides(const LineFinder& lines, Hertz spindle) noexcept;
  bool lineStands(LineFinder& lines, const RatioHop& hop) noexcept;
  bool lineCounts(Hertz spindle) const noexcept;
  bool lineGrows(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) noexcept;
  bool grows(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) noexcept;
  bool lineIsNew(std::span<const RatioChannel> channels, Hertz spindle) const noexcept;
  void track(LineFinder& lines, const RatioHop& hop) noexcept;
  ChatterKind kind(Hertz spindle) const noexcept;

  int teeth_ = 0;
  double chatterRatio_ = 0.2;
  CutState state_ = CutState::Air;
  CalmWatch calm_;
  double highTurns_ = 0.0;  // of chatter from the entry
  Hertz entryLine_{};       // ... at this frequency
  double entryMost_ = 0.0;  // the highest joint ratio of these turns
  double calmTurns_ = 0.0;  // of a ratio that no chatter from the entry has
  bool wasCalm_ = false;    // long enough, in this cut: from there growth decides
  bool sided_ = false;      // the alarm is of chatter from the entry, known by its side lines
  double lostTurns_ = 0.0;
  int sinceLook_ = 0;         // hops, at the line that is followed
  int sinceEntryLook_ = 0;    // hops, at the line of chatter from the entry
  double severity_ = 0.0;     // of the worst channel
  double joint_ = 0.0;        // of all channels of a quantity together, by their levels
  double changed_ = 0.0;      // of the channel with the strongest evidence
  double mostChanged_ = 0.0;  // turn difference, of any channel
  double mostGrown_ = 0.0;    // ... of those where it is growing
  double evidence_ = 0.0;
  double floor_ = 0.0;
  bool learned_ = false;
  // Lowest floor of each channel while the ratio was not high, of the difference and of the news; 0: none.
  std::array<double, kMaxChannels> calmFloor_{}, calmNews_{};
  std::array<double, kMaxChannels> alarmEnergy_{};  // that does not repeat, of each channel, while an alarm lasts
  bool grown_ = false;                              // of any channel
  bool growing_ = false;                            // the difference of any, and neither a blow nor what is left of one
  bool newsGrowing_ = false;                        // the same of the news
  bool forced_ = false;                             // most of the forced vibration is a resonance, in any channel
  bool rising_ = false;                             // ... so fast that no spectrum is waited for
  std::array<int, kMaxChannels> risingHops_{};      // on end, of each channel
  double onOrder_ = 0.0;   // where chatter on or near a spindle order stands, in orders; 0: none
  bool doubling_ = false;  // ... and it is period doubling
  bool doubled_ = false;   // the alarm is one of period doubling with even teeth
  Hertz frequency_{};
  double frequencySd_ = 0.0;
  double spread_ = 0.0;  // Hz, of the lines that may be the chatter's
  double purity_ = 0.0;
  FoundLine line_;
  double sinceOnset_ = 0.0;
  double feedSinceOnset_ = 0.0;
};

}  // namespace stillcut::detect
