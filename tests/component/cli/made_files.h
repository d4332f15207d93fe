// Small files the tests make for themselves.
#pragma once

#include <sndfile.h>

#include <string>
#include <vector>

namespace stillcut::cli_test {

// In Hz, rev/min and s.
inline constexpr double kRate = 12800.0;
inline constexpr int kTeeth = 4;
inline constexpr double kSpeed = 8500.0;
inline constexpr double kChatter = 937.0;
inline constexpr double kOnset = 1.2;
inline constexpr double kLength = 2.5;

// A cut as a sensor might hear it, within +-1: air up to 0.3 s, then every harmonic of the spindle with the tooth
// passing the strongest; from kOnset on, where `chatters`, a line at kChatter that grows to twice the tooth
// passing.
std::vector<float> cutSignal(bool chatters);

// One or more signals of equal length as the channels of a sound file in libsndfile's `format`.
void writeSound(const std::string& path, const std::vector<std::vector<float>>& channels,
                int format = SF_FORMAT_WAV | SF_FORMAT_FLOAT);

// "Time (s),a (m/s^2)" and the signal; without times where `header` is empty.
void writeTable(const std::string& path, const std::vector<float>& signal, const std::string& header);

inline constexpr const char* kStrategy = "lobe-center";

// The demonstration's cut with kStrategy, deep enough to chatter from its entry, over in 2 s.
void writeScenario(const std::string& path);

// `path` with its text changed: the first `from` becomes `to`.
void replaceIn(const std::string& path, const std::string& from, const std::string& to);

}  // namespace stillcut::cli_test
