// Sensor: one channel of the simulated measurement. From the modal motion to device units:
// place in the structure, echoes (microphone), bandwidth, encoder, gain, white noise, fault, clipping, quantisation.
// It is fed at a multiple of the channel rate, so that its low-pass of 4th order also keeps out what would fold back.
// Thread: one. After construction nothing allocates; push() and take() are real-time safe.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/milling/regenerative_cut.h"
#include "core/milling/simulation/low_pass.h"
#include "core/milling/simulation/noise.h"
#include "core/milling/simulation/spindle_drive.h"
#include "core/model/channel.h"

namespace stillcut::milling {

struct Echo {
  Seconds delay{};
  double gain = 0.0;
  bool operator==(const Echo&) const = default;
};

enum class SensorFault { None, Loose, Dead };

struct SensorSettings {
  std::string name;
  SensorQuantity quantity = SensorQuantity::Acceleration;
  std::string axis;           // "x" or "y"; empty for sound, speed, current
  std::vector<double> place;  // weight of each mode at the sensor; empty: 1, it sits at the tool tip
  double gain = 1.0;          // device units per SI unit (sound: per m/s of tip velocity, both axes together)
  Hertz bandwidth{};          // -3 dB; 0: 0.45 of the rate
  double noise = 0.0;         // white, rms in device units
  double fullScale = 0.0;     // clipping level in device units; 0: none
  double step = 0.0;          // quantisation in device units; 0: none
  double counts = 0.0;        // speed: places of an encoder in a revolution, of which it is made; 0: as it is
  std::vector<Echo> echoes;   // sound: the direct way is the first
  SensorFault fault = SensorFault::None;
  Seconds faultFrom{};
};

class Sensor {
 public:
  Sensor(const SensorSettings& settings, Hertz rate, int oversampling, std::uint64_t seed);

  // The undisturbed quantity in SI units, now.
  double quantity(const RegenerativeCut& cut, const SpindleDrive& drive) const noexcept;
  // One value at the oversampled rate, and the sample in device units it leads to.
  void push(double si) noexcept;
  float take(double seconds) noexcept;
  bool clipped() const { return clipped_; }  // the last taken sample was

 private:
  double weight(int mode) const noexcept;
  double withFault(double value, double seconds) noexcept;
  void settle(double si) noexcept;
  double counted() noexcept;

  SensorSettings settings_;
  int axis_;
  LowPass4 lowPass_;
  struct Tap {
    std::size_t delay = 0;
    double gain = 0.0;
  };
  std::vector<Tap> taps_;
  std::vector<double> line_;
  std::size_t head_ = 0;
  NoiseSource noise_;
  double filtered_ = 0.0, looseGain_ = 1.0;
  double finePerMinute_, samplesPerMinute_;
  double turned_ = 0.0, place_ = 0.0;  // revolutions; the encoder's last place [counts]
  bool clipped_ = false;
  bool settled_ = false, counting_ = false;
};

}  // namespace stillcut::milling
