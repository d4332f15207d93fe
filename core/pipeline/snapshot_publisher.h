// SnapshotPublisher: hop 7. Puts together the picture of the newest step and swaps it into place for the screen, and
// hands on the samples for its trace.
// Thread: publish() on the worker, real-time; read() and signal() on one other thread.
#pragma once

#include "core/model/cut_setup.h"
#include "core/model/snapshot.h"
#include "core/model/step_record.h"
#include "core/pipeline/chain.h"
#include "core/pipeline/intervention_log.h"
#include "core/pipeline/signal_tap.h"
#include "core/pipeline/spectrum_tap.h"
#include "core/rt/triple_buffer.h"

namespace stillcut::pipeline {

class SnapshotPublisher {
 public:
  void prepare(const CutSetup& setup, bool simulated, bool autoAllowed);

  void publish(const StepInput& input, const StepOutput& output, const Chain::Step& step, const InterventionLog& log,
               const PathHealth& health) noexcept;

  // The newest picture, or nullptr before the first. Good until the next call.
  const Snapshot* read() noexcept { return buffer_.read(); }
  SignalTap& signal() { return signal_; }
  // Any thread: which channel the spectrogram is of.
  void showChannel(int channel) noexcept { spectrum_.show(channel); }

 private:
  void collectEvents(const StepOutput& output) noexcept;

  SpectrumTap spectrum_;
  SignalTap signal_;
  rt::TripleBuffer<Snapshot> buffer_;
  std::array<Event, kEventsShown> events_{};
  std::uint64_t eventCount_ = 0;
  std::uint64_t number_ = 0;
  CommandRecord lastCommand_;
  bool commanding_ = false;
  bool simulated_ = false;
  bool autoAllowed_ = false;
};

}  // namespace stillcut::pipeline
