// PendingAdvice: what the operator is asked under authority Advise, and the answer: a move, or the return to the
// programmed values. Accept executes that one advice; refuse silences the like of it for a while. Thread: worker.
// Real-time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/model/override_request.h"
#include "core/safety/override_ramp.h"

namespace stillcut::safety {

struct Advice {
  Factors factors;
  OverrideRequest request;
  Rpm programmed{};  // S word that it was made for
};

class PendingAdvice {
 public:
  void clear() STILLCUT_RT {
    open_ = false;
    silentLeft_ = 0.0;
    acceptedLeft_ = 0.0;
  }
  void advance(double dt) STILLCUT_RT {
    silentLeft_ = std::max(0.0, silentLeft_ - dt);
    acceptedLeft_ = std::max(0.0, acceptedLeft_ - dt);
  }
  // The newest wish that is not in force yet. What is on the desk stands still, number and all, while the wish stays
  // alike: whoever reads it has time to, and accepts what he has read.
  void put(const Advice& advice) STILLCUT_RT {
    const bool stands = open_ && isSame(advice.factors, advice_.factors) && stillMeant(advice, advice_);
    open_ = silentLeft_ <= 0.0 || !alike(advice.factors, refused_);
    if (stands) return;
    advice_ = advice;
    ++number_;
  }
  // To a hand and an eye: nearer than the spindle has to come to a speed for the strategy to find that it is there.
  static bool isSame(const Factors& a, const Factors& b) STILLCUT_RT { return within(a, b, kSame); }
  void close() STILLCUT_RT { open_ = false; }
  bool open() const STILLCUT_RT { return open_; }
  const Advice& advice() const STILLCUT_RT { return advice_; }

  std::uint32_t number() const STILLCUT_RT { return number_; }

  // False: not the advice that is on the desk.
  bool accept(std::uint32_t number) STILLCUT_RT {
    if (!open_ || number != number_) return false;
    open_ = false;
    accepted_ = advice_;
    acceptedLeft_ = kAcceptedFor;
    return true;
  }
  bool refuse() STILLCUT_RT {
    if (!open_) return false;
    open_ = false;
    refused_ = advice_.factors;
    silentLeft_ = kSilentFor;
    return true;
  }
  // Accepted and not yet carried out; an acceptance that waits too long for the machine lapses.
  const Advice* accepted() const STILLCUT_RT { return acceptedLeft_ > 0.0 ? &accepted_ : nullptr; }
  // Or given up.
  void carriedOut() STILLCUT_RT { acceptedLeft_ = 0.0; }
  // Accepted for this cut, and still what the strategy asks for. Else nobody has accepted it.
  bool stillMeant(const Advice& now) const STILLCUT_RT { return stillMeant(now, accepted_); }

 private:
  static constexpr double kAcceptedFor = 5.0;  // [s]
  static constexpr double kSilentFor = 30.0;   // [s]
  static constexpr double kAlike = 0.02;       // 2 % of the programmed values
  static constexpr double kSame = 0.008;
  static constexpr double kSameProgram = 1e-3;

  static bool within(const Factors& a, const Factors& b, double by) STILLCUT_RT {
    return std::abs(a.speed - b.speed) <= by && std::abs(a.feed - b.feed) <= by;
  }
  static bool alike(const Factors& a, const Factors& b) STILLCUT_RT { return within(a, b, kAlike); }
  static bool stillMeant(const Advice& now, const Advice& before) STILLCUT_RT {
    const double differs = std::abs((now.programmed - before.programmed).value);
    return now.request.kind == before.request.kind && alike(now.factors, before.factors) &&
           differs <= kSameProgram * before.programmed.value;
  }

  bool open_ = false;
  Advice advice_;
  std::uint32_t number_ = 0;
  Advice accepted_;
  Factors refused_;
  double silentLeft_ = 0.0;
  double acceptedLeft_ = 0.0;
};

}  // namespace stillcut::safety
