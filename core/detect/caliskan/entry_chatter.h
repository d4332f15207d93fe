// Chatter that is there from the entry on: no calm stretch was ever heard that it could have grown from, so a fixed
// ratio decides, for one and the same line over many turns: the paper's (Caliskan 2018, section 5), or, until the cut
// has once been calm and of a line with side lines, a fifth of it. Thread: worker; real-time.
#pragma once

#include <array>
#include <span>

#include "core/detect/caliskan/ratio_hop.h"

namespace stillcut::detect {

class EntryChatter {
 public:
  struct Ratios {
    double worst = 0.0;  // of any channel
    double joint = 0.0;  // of all channels of a quantity together, by their levels
  };

  // chatterRatio: energy ratio of full chatter.
  void prepare(double chatterRatio) { chatterRatio_ = chatterRatio; }
  void leaveCut();
  // What is followed through the signal begins anew, in the same cut.
  void restart() { highTurns_ = 0.0; }
  // An alarm is over, of whatever chatter: the turns count anew.
  void endAlarm() {
    sided_ = false;
    highTurns_ = 0.0;
  }

  // A steady hop without an alarm and below the chatter ratio.
  void learnCalm(std::span<const RatioChannel> channels, double worst, const RatioHop& hop);
  // A hop without an alarm: is such chatter there?
  bool begins(std::span<const RatioChannel> channels, const Ratios& ratios, LineFinder& lines, const RatioHop& hop);
  // The alarm is of such chatter, known by its side lines, which still is as strong.
  bool held(double joint) const { return sided_ && joint >= kHysteresis * sidedRatio(); }
  // A fifth of the vibration's amplitude.
  double sidedRatio() const;
  // The last begins() had to look at the spectrum, and found this line.
  bool looked() const { return looked_; }
  const FoundLine& line() const { return line_; }

 private:
  bool aboveCalm(std::span<const RatioChannel> channels, const EnergyChain& chain) const;
  bool lineHasSides(const LineFinder& lines, const RatioHop& hop);

  double chatterRatio_ = 0.2;
  // Lowest floor of each channel while the ratio was not high, of the difference and of the news; 0: none.
  std::array<double, kMaxChannels> calmFloor_{}, calmNews_{};
  double calmTurns_ = 0.0;   // of a ratio that no chatter from the entry has
  bool wasCalm_ = false;     // long enough, in this cut: from there growth decides
  double highTurns_ = 0.0;   // of a high ratio
  Hertz entryLine_{};        // ... at this frequency,
  bool entrySided_ = false;  // ... which had side lines
  double entryMost_ = 0.0;   // the highest joint ratio of these turns
  bool sided_ = false;
  int sinceLook_ = 0;  // hops
  bool looked_ = false;
  FoundLine line_;
};

}  // namespace stillcut::detect
