// HumSurvey: which channels of a recording hold mains hum and little else, from its first second to its last, where
// another one holds vibration. While a cut is watched that takes two seconds of a cut to tell (core/sensing/
// hum_watch.h); the file tells it before. In the air every sensor may measure hum alone, so that a channel counts as
// hum only where it is hum in nearly all that was looked at, and as strong throughout: what is forced comes with the
// cut. Thread: one; set-up.
#pragma once

#include <span>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/butterworth.h"
#include "core/sensing/hum_watch.h"

namespace stillcut::evaluate {

class HumSurvey {
 public:
  explicit HumSurvey(std::size_t channels, Hertz rate);
  void see(std::size_t channel, std::span<const float> samples);
  // By channel: the mains frequency where it is hum; 0: it is none, or all are. `told`: spindle speed; where one of its
  // harmonics may be the mains frequency nothing is called hum. 0: nobody told one.
  std::vector<Hertz> hums(Hertz told) const;

  static constexpr Seconds kLongest{60.0};  // of a recording that is looked at

 private:
  struct HumChannel {
    detect::HumWatch watch;
    dsp::Butterworth highPass;
    std::vector<double> second;
    int seconds = 0, ofHum = 0;
    double least = 0.0, most = 0.0;  // mean square of the hum in a second
    Hertz mains{};
  };
  void finishSecond(HumChannel& channel) const;
  static bool isHum(const HumChannel& channel);

  std::size_t length_;  // samples of a second
  std::vector<HumChannel> channels_;
};

}  // namespace stillcut::evaluate
