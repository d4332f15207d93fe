// DivergenceWatch: tells when an adaptive loop runs away or is at its end, from what goes out and what comes back.
// Its five rules: resources/manual/developers/laws.md#divergence-watch. Thread: one, real-time.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/realtime.h"
#include "core/base/units.h"

namespace stillcut::safety {

enum class LoopHealth { Fine, Diverging, Saturated, Worse, DeadSensor, Silenced };

class DivergenceWatch {
 public:
  // `amplitude`: the largest output.
  void prepare(Hertz rate, double amplitude) noexcept;
  // The output begins; what was listened to counts.
  void reset() noexcept;
  // Once a sample while nothing goes out.
  void listen(double error) STILLCUT_RT;
  // Once a sample: the error read, what it would be without output (the error itself when nobody knows), what was
  // written, and whether a limit had cut it off.
  LoopHealth watch(double error, double without, double output, bool limited) STILLCUT_RT;

 private:
  static constexpr std::size_t kWindows = 64;  // a quarter second
  static constexpr std::size_t kGrowing = 4;
  struct Window {
    double error = 0.0, without = 0.0, output = 0.0;
    int limited = 0;
  };
  LoopHealth judge() STILLCUT_RT;
  bool atEnd(std::size_t windows) const STILLCUT_RT;
  bool louderThanBefore() const STILLCUT_RT;
  bool growing() const STILLCUT_RT;
  bool loud() const STILLCUT_RT;
  bool silenced() const STILLCUT_RT;
  bool worse() const STILLCUT_RT;
  const Window& back(std::size_t windows) const STILLCUT_RT { return ring_[(newest_ + kWindows - windows) % kWindows]; }

  std::array<Window, kWindows> ring_{};
  std::size_t newest_ = 0;
  std::size_t filled_ = 0;
  Window open_;
  int length_ = 20;  // samples in a window
  int count_ = 0;
  int still_ = 0;  // samples without any change
  int silence_ = 25;
  double usual_ = 0.0, quietest_ = 0.0;  // error of a window: of late, and the least of that
  double forgets_ = 1.0;                 // the least, and what was before, from window to window
  double before_ = 0.0;                  // error of a window before the output began
  std::size_t heard_ = 0;                // windows of it, up to a quarter second
  double slight_ = 0.0;                  // energy of an output in a window that does no harm
  double atStake_ = 0.0;                 // and of one that may run away
  double last_ = 0.0;
};

}  // namespace stillcut::safety
