// What the oracles are fed: simulated and real signals, through speed changes, as the conditioner hands them on.
#pragma once

#include "tests/support/signals.h"

namespace stillcut::detect::testing {

struct Source {
  const char* name;
  std::filesystem::path file;  // empty: made here
  int teeth;
  double rpm;  // told
  SensorQuantity quantity;
  double seconds;  // as far as it is used
};

// Google Test prints a parameter by this.
inline void PrintTo(const Source& s, std::ostream* out) {  // NOLINT(readability-identifier-naming)
  *out << s.name;
}

inline std::vector<Source> sources() {
  const auto shared = sharedDir();
  using Q = SensorQuantity;
  return {{"growth with a speed ramp", "", 4, 6060.0, Q::Acceleration, 2.0},
          {"c2", shared / "cases/c2_hopf_acc.wav", 2, 11000.0, Q::Acceleration, 1.5},
          {"c6", shared / "cases/c6_air_entry_chatter_exit_disp.wav", 3, 6300.0, Q::Displacement, 2.5},
          {"end mill, its speed falling", shared / "recordings/hurco_end_mill/EBI_T100_0p375IN_7000RPMto6000RPM.csv", 3,
           7000.0, Q::Acceleration, 6.0},
          {"face mill, stable", shared / "recordings/face_mill_audio/Stable.wav", 6, 4489.0, Q::Sound, 3.0},
          {"face mill, chatter", shared / "recordings/face_mill_audio/Chatter.wav", 6, 1656.0, Q::Sound, 3.0}};
}

// The source's signal, two channels (the second is the first, later and with noise, where there is only one).
inline Recording recordingOf(const Source& source) {
  CutSignal s;
  s.growthStart = 1.0;
  s.seconds = source.seconds;
  Recording r = source.file.empty()                 ? makeCut(s)
                : source.file.extension() == ".csv" ? readTable(source.file)
                                                    : readWav(source.file);
  r.channels.resize(1);
  auto& first = r.channels[0];
  first.resize(std::min(first.size(), static_cast<std::size_t>(source.seconds * r.rate)));
  std::mt19937 engine(8);
  float most = 0.0F;
  for (const float v : first) most = std::max(most, std::abs(v));
  std::normal_distribution<float> normal(0.0F, 0.01F * most);
  std::vector<float> second(first.size());
  for (std::size_t k = 0; k < second.size(); ++k) second[k] = (k < 7 ? 0.0F : first[k - 7]) + normal(engine);
  r.channels.push_back(second);
  return r;
}

// Every valid block; a made signal comes with a machine that changes its speed by 4 % and back.
inline void forEachBlock(const Source& source, const Recording& recording,
                         const std::function<void(const ConditionedBlock&)>& use) {
  RunOptions options;
  options.teeth = source.teeth;
  options.rpm = source.rpm;
  options.quantity = source.quantity;
  if (source.file.empty()) {
    options.machine = [&source](double t) {
      MachineState m;
      m.valid = m.linkUp = true;
      const double away = std::clamp(std::min(t - 1.2, 1.7 - t) * 10.0, 0.0, 1.0);
      m.actualSpeed = Rpm(source.rpm * (1.0 + 0.04 * away));
      return m;
    };
  }
  options.onBlock = [&use](const ConditionedBlock& block, const Verdict&) {
    if (block.valid && block.spindle.value > 0.0) use(block);
  };
  run(recording, options, "spectral");
}

// One test per source; those of the shared material need it.
class OnSources : public ::testing::TestWithParam<Source> {};

}  // namespace stillcut::detect::testing

#define STILLCUT_NEEDS_SOURCE(source) \
  if (!(source).file.empty()) STILLCUT_NEEDS((source).file)
