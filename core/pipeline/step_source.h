// StepSource: fills a step's input from a device or a recording.
// Thread: read() on the driver thread.
#pragma once

#include "core/daq/daq_source.h"
#include "core/model/step_record.h"

namespace stillcut::pipeline {

class StepSource {
 public:
  virtual ~StepSource() = default;
  // Fills step.block (and, from a session, the recorded machine state and inputs). False: no more.
  virtual bool read(StepInput& step) noexcept = 0;
  // Ends a read() that waits, and all after it. Any thread.
  virtual void stop() noexcept = 0;
};

// Any device: the block only.
class DeviceStepSource final : public StepSource {
 public:
  explicit DeviceStepSource(daq::DaqSource& source) : source_(source) {}
  bool read(StepInput& step) noexcept override { return source_.read(step.block); }
  void stop() noexcept override { source_.stop(); }

 private:
  daq::DaqSource& source_;
};

}  // namespace stillcut::pipeline
