// A converter or amplifier at its limit, seen in the samples alone: the waveform is cut flat, at the same value again
// and again, and nothing goes beyond. A natural peak is a parabola: where n samples of it fall on one step of the
// converter, its neighbours lie at most (1 + 2/n)^2 steps lower. A flat of three or more whose neighbours on both sides
// lie deeper than that is none. The value of three flats in a row is the limit, until something goes beyond it
// or they settle elsewhere (the gain was turned). What rests at one value between pulses, near zero, is no limit.
// Thread: one; real-time.
#pragma once

#include <array>
#include <span>

namespace stillcut::dsp {

class ClipWatch {
 public:
  // True: the limit is known, and a sample of these reaches it.
  bool see(std::span<const float> samples) noexcept;

 private:
  struct Limit {
    float value = 0.0F;
    int flats = 0;
  };
  void endFlat(float next) noexcept;
  void learnStep(float change) noexcept;

  float last_ = 0.0F, before_ = 0.0F;  // the present value, and the one before it that differs
  int run_ = 0;                        // samples at last_
  bool turned_ = false;                // before_ is known
  float step_ = 0.0F;                  // of the converter: least difference of two values; 0: none yet
  float loud_ = 0.0F;                  // largest magnitude, forgotten slowly
  std::array<Limit, 2> limits_{};      // below, above
};

}  // namespace stillcut::dsp
