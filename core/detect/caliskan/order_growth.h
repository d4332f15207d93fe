// Chatter that lies on spindle harmonics, or so near to one that a comb of them takes it out with the forced vibration:
// period doubling with an even number of teeth, at orders (k + 1/2) Z, and Hopf chatter near a whole order.
//
// What tells it from forced vibration is growth. Regeneration by Z teeth ties the orders of one rest modulo Z together
// (n and kZ +- n: side lines a tooth passing apart); in a stable cut they hold runout, a share of the vibration that
// stays as it is while the load changes. So the share of every such class is tested against its own learned floor
// (onset_test.h). Near the stability limit a mode amplifies runout as well. A class whose share has grown is chatter
// - where its strongest order turns against the spindle, as a line at n + e does, by e of a turn per turn, and what is
//   forced does not;
// - of period doubling, which stands still itself, where it grows at the rate of an instability (order_stretches.h), or
//   out of less than a fifth of the amplitude further than a stable cut amplifies runout. The latter only in the
//   engagement that the floor was learned in: what runout leaves on an order at one arc says nothing of what it leaves
//   at another, a thousand times as much in a cut far below its limit;
// - of another class, where it grew at that rate, as far, and to more than all other orders together: it has locked to
//   its order.
// Where no share grows, or it takes too long, an order is chatter
// - that has become louder and has turned by a whole turn, faster than the speed is in doubt. Runout on a mode may be
//   nearly all there is (at full immersion tooth passings cancel), and a load that changes moves the phase of a forced
//   vibration by no more than the half turn that a mode has;
// - on a slow spindle, where the learned floor follows slow growth up and what a line leaks into the other orders keeps
//   its share down: whose share, without the leak, is far above a floor that rises by time alone, and which turns for
//   some turns, by a quarter of one in all, further than a mode that comes near its limit turns runout. (An end mill at
//   800 rev/min on thin walls, order 15.03, growing twofold in 0.5 s: 2 s earlier than by the whole turn);
// - that turns by less and grows by itself, not with the load (order_pole.h), while the engagement stays;
// - whose class, not of period doubling, has twice the amplitude of all others together and ten times what it was, by
//   itself and against them: chatter that takes the tracked speed along turns against nothing. (Runout on a mode
//   becomes four times what it was where it is that much, as the width of cut rises to nine tenths of the limit.)
// Not believed are a class that holds no more than teeth which leave the material make of runout on two others, a
// turning that is no more than what an arc which moves pulls the tracked speed by (arc_pull.h), and, in an engagement
// that changes or is not the learned one, an order that has not yet turned by a quarter of a turn beyond that. What is
// louder by turning has to be so by the more, the more its share scatters: noise in a narrow band. For three windows of
// the fit no class (of period doubling: for as long as it does) begins to be chatter while its strongest order surely
// settles (order_pole.h): at 0.95 of the limit a mode beats with runout for tens of turns, turns with it and becomes
// many times louder. Tooth-passing orders are not tested: what grows there may be the load. Not in Caliskan 2018.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <complex>
#include <vector>

#include "core/detect/caliskan/energy_chain.h"
#include "core/detect/growth/arc_pull.h"
#include "core/detect/growth/energy_growth.h"
#include "core/detect/growth/new_line.h"
#include "core/detect/growth/onset_test.h"
#include "core/detect/growth/order_stretches.h"
#include "core/detect/growth/order_turns.h"
#include "core/detect/growth/timed_floor.h"

namespace stillcut::detect {

class OrderGrowth {
 public:
  // eta: of the energy ratio's weights (Caliskan 2018 eq. 28).
  void prepare(int teeth, int eta, int harmonics);
  void setEvidence(double evidence);
  void relearn();
  // Another cut, or after a gap; what was learned stays.
  void restart() { pull_.reset(); }
  // What modes make of runout changes with the speed: beyond a part of their damping's width the floors count as much
  // more as a mode's flank is steep, and where the speed has stepped they are learned anew. So is the floor of period
  // doubling at every such part: runout of alternate teeth on a mode that its order crosses is like the beginning of
  // it, and near the limit a tenfold one. Learning takes eight turns: while the speed changes by more than 0.04 % a
  // turn no doubling with an even number of teeth is found.
  void setSpindle(Hertz spindle);
  // One hop: what the harmonic filter holds of a channel.
  void endHop(const EnergyChain& chain, int channel);
  // Twice a turn, at a steady speed: what has grown by itself (order_pole.h)? Looked at in a cut that is judged, and
  // where it has grown at all.
  void endHalfTurn(const NewLine& vibration, int channel, Hertz spindle, bool judged);
  // By how much of itself a load that changes may change an order in a turn (load_watch.h): no more is no growth.
  void setLoad(double mostOfAnOrder) { byLoad_ = mostOfAnOrder; }
  // speedDoubt: relative standard deviation of the spindle's speed.
  void test(double turns, bool learn, double speedDoubt = 0.0);

  bool grown() const;
  // One order stands out of a class that has grown, as a mode does: where it is, in orders; 0: none.
  double order() const { return order_; }
  bool doubling() const { return doubling_; }
  // Part of the weighted energy that the grown classes hold, above their floors.
  double severity() const;

 private:
  // Found to grow by itself (order_pole.h), at the same order and so often on end that it is believed.
  struct Alone {
    int times = 0;
    int order = 0;
    double most = 0.0;  // the class's largest share since that is believed; 0: it is not
    bool stays(double share) const;
    void look(int atOrder, double share, bool found);
  };
  // The orders n = +-rest modulo the teeth.
  struct Class {
    int rest = 0;
    bool flips = false;  // the orders of period doubling with an even number of teeth
    double power = 0.0, weighted = 0.0;
    double strongest = 0.0;
    int order = 0;  // the strongest
    OnsetTest onset;
    TimedFloor timed;
    bool own = false;         // grows, and not because the engagement changes
    bool unstable = false;    // has grown as an instability does since its share began to
    bool counts = false;      // it is chatter
    double alarmTurns = 0.0;  // its share has grown and it does not count
    double turned = 0.0;      // turns of the strongest order, by itself, since it is louder
    double turnedBy = 0.0;    // ... since there is evidence that its share grows
    double apartTurns = 0.0;  // turns since it is far above the timed floor and turns
    double apartBy = 0.0;     // ... and by how many it has turned since
    bool doubles = false;     // far above what runout becomes, by growth of its own
    bool dwarfs = false;      // all others, and what it was
    double settles = 0.0;     // turns for which its strongest order is known to settle
    double held = 0.0;        // ... and since it is, on end
    Alone alone;
  };
  static void relearn(Class& c);
  static double muchLouder(const Class& c);
  static bool isOne(const Class& c);
  static bool withheld(const Class& c);
  void followStretches();
  void followEngagement(double turns, bool learn);
  void followTurning(Class& c, double turns, double speedDoubt) const;
  void followTimed(Class& c, double turns, bool learn, double speedDoubt) const;
  bool doubles(const Class& c) const;
  bool dwarfs(const Class& c) const;
  void relearnNewLoad(Class& c, double turns, bool learn);
  bool counts(const Class& c) const;
  bool begins(const Class& c) const;
  bool mayFit(const Class& c) const;
  bool settles(const Class& c, const NewLine& vibration, int channel, Hertz spindle) const;
  bool growsAlone(const Class& c, const NewLine& vibration, int channel, Hertz spindle) const;
  bool mayGrowByItself(const Class& c) const;
  bool explained(const Class& c) const;
  double products(const Class& c) const;
  double share(const Class& c) const;
  double sense(const Class& c) const;
  double ownDrift(const Class& c) const;
  bool turnsByItself(const Class& c) const;
  bool pulled(const Class& c) const;
  void tell();

  int teeth_ = 0;
  int eta_ = 0;
  int hop_ = 0;
  double all_ = 0.0;
  double weightedAll_ = 0.0;
  double order_ = 0.0;
  double byLoad_ = 0.0;
  bool doubling_ = false;
  Hertz spindle_{};
  Hertz learnedAt_{};
  int halfTurnsThere_ = 0;
  int active_ = 0;              // harmonics there are
  bool alarming_ = false;       // when the cut was tested last
  double standingTurns_ = 0.0;  // of one engagement, in which nothing grows
  std::vector<Class> classes_;  // rests 1 .. teeth / 2
  std::vector<std::complex<double>> now_;
  OrderTurns turns_;
  OrderStretches stretches_;
  ArcPull pull_;
};

}  // namespace stillcut::detect
