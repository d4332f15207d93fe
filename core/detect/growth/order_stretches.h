// What the last stretch of turns has added to a class of spindle orders, and to the one before: is it growth of its
// own?
//
// Runout drives a vibration on every order, and that grows without any chatter in two cases. Where the arc of
// engagement changes, what runout leaves on an order depends on it as strongly as what the teeth leave on theirs: the
// pattern of the tooth passings, one order against the other in size and phase, changes by at least as much (an
// immersion ramp: the class by 0.05 to 0.4, the pattern by 0.35 to 0.45; where chatter begins in a constant arc: 0.02
// to 0.8 against 0.01). And where the cut comes nearer to its limit a mode amplifies runout by 1 / (1 - depth / limit):
// as fast as the load rises, which moves in tenths of a second, and no longer than it does. Beyond the limit a
// disturbance grows by its multiplier, an e-fold in 5 to 50 ms: then each stretch adds more than twice what any of the
// four before it did (what follows a ramp may pause on its way and go on), and by that much more than the load's own
// steps grow, for where a ramp begins all that it changes does so ever faster. Of a stretch that added no more than the
// pattern scatters by nobody knows how much it added; it counts as all that it may have hidden, or noise that happens
// to be little would make growth of the noise after it. All in complex amplitudes over the amplitude of the tooth
// passings. Not in Caliskan 2018. Thread: worker; everything but prepare() is real-time.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/units.h"

namespace stillcut::detect {

class OrderStretches {
 public:
  void prepare(int teeth, std::size_t orders);
  void setSpindle(Hertz spindle);
  // What came before is of another cut or load: growth is compared with none of its stretches but the last.
  void forget() { known_ = 0; }
  // One turn: complex amplitudes against the spindle's angle of the orders 1, 2, ...
  void endTurn(std::span<const std::complex<double>> now);

  // Of the orders n = +-rest modulo the teeth; rest 1 .. teeth / 2: has the last stretch added more than the engagement
  // has changed,
  bool ownGrowth(int rest) const;
  // ... and made it larger, sooner than a mode near its limit follows a load,
  bool growsOn(int rest) const;
  // ... or added to it at the rate of an instability, as period doubling does that grows out of runout?
  bool unstableGrowth(int rest) const;
  // ... at that rate far more than the engagement changes, as a line does that has locked to its order?
  bool lockedGrowth(int rest) const;
  // Is the tooth passings' pattern another one than a stretch ago?
  bool engagementChanges() const;
  // That pattern of now is the one that floors are learned in, as far as its sizes go.
  void learnEngagement();
  // Is it another one by now?
  bool otherEngagement() const;

 private:
  using Row = std::span<const std::complex<double>>;
  static constexpr std::size_t kStretch = 8;  // rows
  static constexpr std::size_t kStretches = 5;
  static constexpr std::size_t kRows = kStretches * kStretch + 1;
  Row ago(std::size_t rows) const;
  double teethOf(Row row) const;
  // Root of the sum of squares of what amplitude(order - 1) says of the class's orders.
  template <class Amplitude>
  double ofClass(int rest, const Amplitude& amplitude) const;
  double added(int rest, std::size_t rowsAgo) const;
  // Amplitude of the class over that of the tooth passings.
  double size(int rest, std::size_t rowsAgo) const;
  double patternChange() const;
  // Relative change of the load in the stretch that ended so many rows ago.
  double loadChange(std::size_t rowsAgo) const;

  std::size_t teeth_ = 0;
  std::size_t orders_ = 0;
  std::size_t newest_ = 0;
  std::size_t known_ = 0;  // rows since forget()
  int turnsPerRow_ = 1;
  int turns_ = 0;                           // since the newest row
  double pattern_ = 1.0;                    // change in the last stretch
  double faster_ = 1.0;                     // added in a stretch over the one before, of an instability
  double settling_ = 1.0;                   // ... of a mode near its limit at most
  std::vector<std::complex<double>> rows_;  // [row * orders + order - 1]
  std::vector<double> learned_;             // [order - 1], amplitudes
};

}  // namespace stillcut::detect
