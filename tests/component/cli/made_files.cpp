#include "tests/component/cli/made_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <numbers>
#include <random>

#include "core/milling/simulation/scenario.h"

namespace stillcut::cli_test {

std::vector<float> cutSignal(bool chatters) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 2e-3);
  const double turn = 2.0 * std::numbers::pi;
  const double spindle_Hz = kSpeed / 60.0;
  std::vector<float> signal(static_cast<std::size_t>(kLength * kRate));
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double t = static_cast<double>(i) / kRate;
    double x = 0.0;
    for (int h = 1; h <= 12; ++h)
      x += (h % kTeeth == 0 ? 0.1 * kTeeth / h : 0.01) * std::sin(turn * h * spindle_Hz * t);
    if (chatters) x += 0.2 * std::clamp((t - kOnset) * 4.0, 0.0, 1.0) * std::sin(turn * kChatter * t);
    signal[i] = static_cast<float>((t < 0.3 ? 0.0 : x) + noise(random));
  }
  return signal;
}

void writeSound(const std::string& path, const std::vector<std::vector<float>>& channels, int format) {
  SF_INFO info{};
  info.channels = static_cast<int>(channels.size());
  info.samplerate = static_cast<int>(kRate);
  info.format = format;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  ASSERT_NE(file, nullptr) << path;
  std::vector<float> frames;
  for (std::size_t f = 0; f < channels.front().size(); ++f) {
    for (const auto& channel : channels) frames.push_back(channel[f]);
  }
  sf_write_float(file, frames.data(), static_cast<sf_count_t>(frames.size()));
  sf_close(file);
}

void writeTable(const std::string& path, const std::vector<float>& signal, const std::string& header) {
  std::ofstream out(path);
  if (!header.empty()) out << header << '\n';
  for (std::size_t i = 0; i < signal.size(); ++i) {
    if (!header.empty()) {
      out << std::fixed << std::setprecision(9) << static_cast<double>(i) / kRate << ',' << std::defaultfloat;
    }
    out << std::setprecision(9) << signal[i] << '\n';
  }
}

void writeScenario(const std::string& path) {
  auto scenario = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml");
  ASSERT_TRUE(scenario.ok()) << scenario.error().line();
  scenario->strategy = kStrategy;
  scenario->programme.duration = Seconds(2.0);
  scenario->programme.depth = milling::Schedule();
  scenario->programme.depth.segments.push_back({.from = 0.0, .to = 2.0, .fromValue = 1.5e-3, .toValue = 1.5e-3});
  scenario->programme.entry = milling::Passage{milling::Along::Time, 0.2};
  scenario->programme.exit = milling::Passage{milling::Along::Time, 1.9};
  const Status saved = milling::saveScenario(*scenario, path);
  ASSERT_TRUE(saved.ok()) << saved.error().line();
}

void replaceIn(const std::string& path, const std::string& from, const std::string& to) {
  std::ifstream in(path);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  in.close();
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << path << " holds no '" << from << "'";
  std::ofstream(path) << text.replace(at, from.size(), to);
}

}  // namespace stillcut::cli_test
