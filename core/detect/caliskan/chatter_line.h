// The line that an alarm is of: its frequency and doubt, followed through the alarm; which kind of chatter that is, and
// whether there is such a line at all. Thread: worker; real-time.
#pragma once

#include "core/detect/caliskan/ratio_hop.h"

namespace stillcut::detect {

// Growth or a high ratio alone may be a knock or a lost speed; chatter is a line between the spindle harmonics.
bool lineStands(const FoundLine& line, const RatioHop& hop);

class ChatterLine {
 public:
  // What the energies say of it.
  struct Evidence {
    double onOrder = 0.0;   // where chatter on or near a spindle order stands, in orders; 0: none
    bool doubling = false;  // ... and it is period doubling
    double changed = 0.0;   // turn difference over vibration, of any channel
    double severity = 0.0;
    bool ringing = false;  // the speed was changed and little is left: lines are the modes' own
  };

  // No alarm: there is none.
  void forget();
  // One hop of an alarm.
  void follow(LineFinder& lines, const RatioHop& hop, const Evidence& evidence);

  Hertz frequency() const { return frequency_; }  // 0: not known yet
  Hertz sd() const;
  double purity() const { return purity_; }
  // It has sunk into the noise for so long that there was none, or it is over.
  bool lost() const;
  // The strongest line of the last turns mostly was this one, or one whole tooth passings away from it.
  bool stays() const;
  // With the last look it became another one.
  bool another() const { return another_; }
  // teeth: 0 where nobody told.
  ChatterKind kind(int teeth, Hertz spindle) const;

 private:
  void stayOnOrder(double order, const RatioHop& hop);
  void move(Hertz next, const RatioHop& hop, int hops);
  bool sameAs(Hertz line, const RatioHop& hop) const;

  Hertz frequency_{};
  double frequencySd_ = 0.0;
  double spread_ = 0.0;  // Hz, of the lines that may be the chatter's
  double purity_ = 0.0;
  double lostTurns_ = 0.0;
  double same_ = 0.0;  // part of the last looks whose strongest line was this one
  int sinceLook_ = 0;  // hops
  bool another_ = false;
  bool doubled_ = false;  // period doubling with even teeth
};

}  // namespace stillcut::detect
