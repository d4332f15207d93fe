// SilentOutput: analog outputs that are looked at and not written, for trying a link out: a write of the programmed
// values is a move of the machine where its knob stands elsewhere. Thread: as AnalogOutput says.
#pragma once

#include <memory>
#include <utility>

#include "core/cnc/analog/analog_link.h"

namespace stillcut::cnc {

class SilentOutput final : public AnalogOutput {
 public:
  explicit SilentOutput(std::unique_ptr<AnalogOutput> card) : card_(std::move(card)) {}
  Status open(const AnalogDevice& device) override { return card_->open(device); }
  bool write(int /*channel*/, double /*volts*/) noexcept override { return true; }

 private:
  std::unique_ptr<AnalogOutput> card_;
};

}  // namespace stillcut::cnc
