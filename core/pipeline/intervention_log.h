// InterventionLog: follows alarms and commands and keeps one card per alarm: what was before, what we did, what came of
// it, so that the screen can prove that the advice worked. Also the totals of time in the cut, judged and in chatter.
// Thread: worker, real-time. Fixed size.
#pragma once

#include <array>
#include <cstdint>

#include "core/model/event.h"
#include "core/model/snapshot.h"
#include "core/model/step_record.h"
#include "core/safety/gate_io.h"

namespace stillcut::pipeline {

// What the conditioner made of the block.
struct CutNow {
  double vibrationRms = 0.0;            // first channel, SI
  MetresPerSecond feed{};               // also of a cut without a machine's link, as set up; 0: unknown
  safety::GateOutput::Judged judged{};  // what came of a move, when it was judged in this block
};

class InterventionLog {
 public:
  // Appends "chatter began / ended" to the output's events.
  void follow(const StepInput& input, StepOutput& output, const CutNow& cut, Seconds dt) noexcept;
  void reset() noexcept { *this = InterventionLog(); }

  std::uint64_t count() const { return count_; }
  // Card `number`, good for the newest kInterventionsShown.
  const Intervention& card(std::uint64_t number) const { return cards_[number % kInterventionsShown]; }
  Seconds cutTime() const { return cutTime_; }
  Seconds judgedTime() const { return judgedTime_; }
  Seconds chatterTime() const { return chatterTime_; }
  Metres chatterLength() const { return chatterLength_; }
  // Of its events, those that found no room or took it from a less important one.
  std::uint64_t eventsLost() const { return eventsLost_; }

 private:
  void judge(const safety::GateOutput::Judged& judged) noexcept;
  void begin(const StepInput& input, StepOutput& output, const Verdict& verdict, const CutNow& cut) noexcept;
  void update(const StepInput& input, StepOutput& output, const Verdict& verdict, const CutNow& cut,
              Seconds dt) noexcept;

  std::array<Intervention, kInterventionsShown> cards_{};
  std::uint64_t count_ = 0;
  bool open_ = false;
  bool alarming_ = false;
  Instant lastAlarm_{};
  Seconds sinceAlarm_{};  // of valid verdicts
  Seconds cutTime_{}, judgedTime_{}, chatterTime_{};
  Metres chatterLength_{};
  void append(StepOutput& output, EventLevel level, Instant time, const Reason& reason) noexcept;

  std::uint64_t eventNumber_ = 0;
  std::uint64_t eventsLost_ = 0;
};

}  // namespace stillcut::pipeline
