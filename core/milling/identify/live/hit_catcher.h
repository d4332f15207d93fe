// HitCatcher: cuts the hits of a tap test out of a stream of samples: waits until it is quiet, takes what comes once
// the trigger channel leaves its own noise, with a little before it, and waits until the structure has rung down.
// Thread: one. Allocates; not for the path to the machine.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stillcut::identify {

struct CatcherOptions {
  double length = 0.5;          // of a hit [s]; half as long halves the resolution: 2 Hz with 0.5 s
  double before = 0.01;         // kept before the trigger [s]; the offset is taken from it
  double noises = 12.0;         // trigger over the rms of the quiet channel; below 6 noise itself triggers
  double least = 0.0;           // trigger at least [unit of the channel]: 2 N for a hammer
  double quietShare = 0.02;     // of a hit's largest response: less is quiet again
  double settle = 0.25;         // over which the noise is learned [s]
  double longestRinging = 3.0;  // then the next hit is waited for in any case [s]
};

struct CaughtHit {
  std::vector<double> force;     // empty: there is no hammer channel
  std::vector<double> response;  // [SI unit]
  double time = 0.0;             // of the trigger, since the stream began [s]
  double noise = 0.0;            // rms of the trigger channel before it
  bool gap = false;              // samples are missing in it
  bool tooSoon = false;          // the one before still rang
};

class HitCatcher {
 public:
  enum class State { Settling, Waiting, Catching, Ringing };

  // `withForce`: the force is the trigger, else the response.
  HitCatcher(double rate, bool withForce, const CatcherOptions& options);

  // Samples that follow those before, or after a gap. `force` is empty where there is none. Gives what is complete.
  std::vector<CaughtHit> feed(std::span<const double> force, std::span<const double> response, bool gap);
  State state() const { return state_; }
  double level() const { return level_; }  // of the trigger; 0 while the noise is learned

 private:
  void learn(double trigger);
  void begin(std::size_t index);
  bool ringsDown(double response);
  std::size_t samples(double seconds) const;

  double rate_;
  bool withForce_;
  CatcherOptions options_;
  State state_ = State::Settling;
  double level_ = 0.0, noise_ = 0.0;
  double sum_ = 0.0, squares_ = 0.0;  // of the trigger channel, in a piece of what is learned
  int pieces_ = 0;
  double mean_ = 0.0;
  std::size_t learned_ = 0;
  std::vector<double> force_, response_;  // what may still be needed
  std::size_t seen_ = 0;                  // samples since the stream began
  CaughtHit hit_;
  std::size_t missing_ = 0;  // samples until the hit is complete
  double largest_ = 0.0;     // response of the last hit
  double recent_ = 0.0;      // mean square of the response, over 20 ms
  std::size_t ringing_ = 0;  // samples for which it has
};

}  // namespace stillcut::identify
