// Files of tap tests as programs write them, of one structure with known modes.
#pragma once

#include <complex>
#include <functional>
#include <string>

#include "core/base/units.h"
#include "core/milling/identify/import/measurement_import.h"
#include "core/session/open_recording.h"
#include "tests/support/temp_folder.h"

namespace stillcut::identify::test {

inline ImportOptions options() {
  ImportOptions o;
  o.open = [](const std::string& path, const record::ReadOptions& r) { return record::openRecording(path, r); };
  return o;
}

// 500 Hz, 0.03, 1.2e7 N/m.
inline std::complex<double> compliance(double f) {
  const double r = f / 500.0;
  return 1.0 / (1.2e7 * std::complex<double>(1.0 - r * r, 2.0 * 0.03 * r));
}

// `line` makes a row of a frequency and its compliance, 0 to 1000 Hz.
inline std::string frfText(const std::string& header,
                           const std::function<std::string(double, std::complex<double>)>& line) {
  std::string out = header;
  for (int i = 0; i <= 200; ++i) out += line(5.0 * i, compliance(5.0 * i)) + "\n";
  return out;
}

inline std::string cells(std::initializer_list<double> values, char separator = ',') {
  std::string out;
  for (const double v : values) {
    char cell[40];
    std::snprintf(cell, sizeof cell, "%.9e", v);
    out += (out.empty() ? "" : std::string(1, separator)) + cell;
  }
  return out;
}

// A pulse and an answer of 100 samples a millisecond apart; times, force and response with these factors.
inline std::string tapText(const std::string& header, double time, double force, double response) {
  std::string out = header;
  for (int i = 0; i < 100; ++i) {
    const double push = i >= 10 && i < 13 ? 100.0 : 0.0;
    const double answer = i >= 10 ? 50.0 * std::sin(0.9 * (i - 10)) * std::exp(-0.05 * (i - 10)) : 0.0;
    out += cells({time * 1e-3 * i, force * push, response * answer}) + "\n";
  }
  return out;
}

inline const Frf& frfOf(const Result<Measurement>& measured, std::size_t i = 0) {
  return std::get<std::vector<Frf>>(measured->data)[i];
}
inline const HammerRecord& hammerOf(const Result<Measurement>& measured, std::size_t i = 0) {
  return std::get<std::vector<HammerRecord>>(measured->data)[i];
}

}  // namespace stillcut::identify::test
