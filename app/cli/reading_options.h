// --rate, --time-unit, --quantity, --channel and --scale: what a person knows about a recording and the file does not
// say.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/recording_reader.h"

namespace stillcut::app {

// --time-unit, of commands that read recordings; empty: not given.
void addTimeUnit(CLI::App& command, std::string& unit);
std::optional<double> secondsOfTimeUnit(const std::string& unit);

class ReadingOptions {
 public:
  void add(CLI::App& command);
  // Checks what was given; one line names the option.
  Result<record::ReadOptions> understand() const;

 private:
  std::string quantity_, timeUnit_;
  std::vector<int> channels_;
  double rate_ = 0.0, scale_ = 0.0;
  CLI::Option* rateGiven_ = nullptr;
  CLI::Option* scaleGiven_ = nullptr;
};

}  // namespace stillcut::app
