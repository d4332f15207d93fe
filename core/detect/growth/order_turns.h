// How the vibration at each spindle order turns against the spindle, from turn to turn: a line at n + e turns by e of a
// turn per turn, and what is forced stands still. Not in Caliskan 2018. Thread: worker; everything but prepare() is
// real-time.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace stillcut::detect {

class OrderTurns {
 public:
  static constexpr double kMemoryTurns = 6.0;

  void prepare(int orders);
  // One turn: complex amplitudes against the spindle's angle of the orders 1, 2, ...
  void endTurn(std::span<const std::complex<double>> now);

  // Of an order that there is not: nothing. In turns per turn, which is where its line stands beside it, in orders; ...
  double drift(int order) const;
  // ... is it all one line, and further from the order than the spindle's speed is in doubt?
  bool turns(int order) const;
  // By how much of itself it changes in a turn; infinite where nothing was there.
  double change(int order) const;
  // Of the energy of a line there, what all other orders hold of it.
  double leak(int order, double energy) const;

  static constexpr double kLeastDrift = 0.012;  // orders: what a spindle known to 0.1 % leaves at the twelfth order

 private:
  struct Order {
    std::complex<double> before;   // a turn ago
    std::complex<double> product;  // of now and a turn ago, over some turns: its phase is the turn per turn
    double power = 0.0;            // the same without phases
    double past = 0.0;             // energy a turn ago
  };
  const Order* at(int order) const;
  std::vector<Order> orders_;
};

}  // namespace stillcut::detect
