// What commands share that read the files of a tap test: units, channels, axes, hammer analysis.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/modal_measurement.h"

namespace stillcut::app {

class TapOptions {
 public:
  void add(CLI::App& command);
  // Checks what was given; one line names the option.
  Result<identify::ModalRequest> understand() const;

 private:
  identify::ModalRequest request_;
  std::vector<std::string> axes_;
  std::string band_, quantity_, estimate_ = "h1";
  double scale_ = 0.0;  // 0: the file's
  double forceWindowMs_ = 0.0;
  double rate_ = 0.0;
  std::string timeUnit_;
  long dataset_ = -1;
};

// "600:3100", either end may be left out.
Status readBand(const std::string& text, identify::ModalOptions& fit);

}  // namespace stillcut::app
