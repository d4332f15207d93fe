#include "core/session/step_sink.h"

#include <deque>
#include <optional>
#include <utility>

namespace stillcut::record {
namespace {

class OneFile : public StepSink {
 public:
  explicit OneFile(std::unique_ptr<SessionWriter> writer) : writer_(std::move(writer)) {}
  Status add(const StepInput& input, const StepOutput& output) override { return writer_->add(input, output); }
  Status flush() override { return writer_->flush(); }
  Status close() override { return writer_->close(); }
  void setPowerSafe() override { writer_->setPowerSafe(); }
  std::string path() const override { return writer_->path(); }
  SessionWriter* writer() override { return writer_.get(); }

 private:
  std::unique_ptr<SessionWriter> writer_;
};

// One file after the other.
class ManyFiles : public StepSink {
 public:
  ManyFiles(const SessionHeader& header, NextPath nextPath, const SessionWriterOptions& options)
      : header_(header), nextPath_(std::move(nextPath)), options_(options) {}
  Status flush() override { return writer_ ? writer_->flush() : Status(Done{}); }
  Status close() override {
    if (!writer_) return Done{};
    Status closed = writer_->close();
    writer_.reset();
    return closed;
  }
  void setPowerSafe() override {
    options_.powerSafe = true;
    if (writer_) writer_->setPowerSafe();
  }
  std::string path() const override { return writer_ ? writer_->path() : last_; }
  SessionWriter* writer() override { return writer_.get(); }

 protected:
  Status openNext() {
    Result<std::unique_ptr<SessionWriter>> made = createUnderNextName(nextPath_, header_, options_);
    if (!made) return made.error();
    writer_ = std::move(*made);
    last_ = writer_->path();
    return Done{};
  }

 private:
  SessionHeader header_;
  NextPath nextPath_;
  SessionWriterOptions options_;
  std::unique_ptr<SessionWriter> writer_;
  std::string last_;
};

// An alarm that lasts calls all the time: what came of it is to be seen after its end, not after its beginning.
bool calls(const StepInput& input, const StepOutput& output) {
  if (output.verdictCount > 0 && output.verdicts[static_cast<std::size_t>(output.inCharge)].alarming()) return true;
  for (int i = 0; i < input.inputCount; ++i) {
    if (input.inputs[static_cast<std::size_t>(i)].action >= OperatorAction::TrueAlarm) return true;
  }
  for (int i = 0; i < output.eventCount; ++i) {
    if (output.events[static_cast<std::size_t>(i)].level >= EventLevel::Warning) return true;
  }
  return false;
}

class AroundEvents final : public ManyFiles {
 public:
  AroundEvents(const SessionHeader& header, const RecordPlan& plan, NextPath nextPath,
               const SessionWriterOptions& options)
      : ManyFiles(header, std::move(nextPath), options), plan_(plan) {}

  Status add(const StepInput& input, const StepOutput& output) override {
    if (calls(input, output)) {
      lastCall_ = input.block.end();
      if (writer() == nullptr) {
        if (Status s = begin(); !s) return s;
      }
    }
    if (writer() == nullptr) {
      keep(input, output);
      return Done{};
    }
    if (Status s = writer()->add(input, output); !s) return s;
    return secondsBetween(lastCall_, input.block.end()) >= plan_.after ? close() : Status(Done{});
  }

 private:
  Status begin() {
    if (Status s = openNext(); !s) return s;
    // Half a minute in one go. To wait for the disk after every half second of it could take longer than the recorder
    // can hold what comes meanwhile, and that is the alarm itself.
    writer()->commitLater(true);
    for (const StepRecord& step : before_) {
      if (Status s = writer()->add(step.input, step.output); !s) return s;
    }
    before_.clear();
    writer()->commitLater(false);
    return writer()->flush();
  }
  void keep(const StepInput& input, const StepOutput& output) {
    before_.push_back({input, output});
    const Instant end = input.block.end();
    while (!before_.empty() && secondsBetween(before_.front().input.block.firstSample, end) > plan_.before) {
      before_.pop_front();
    }
  }

  RecordPlan plan_;
  std::deque<StepRecord> before_;
  Instant lastCall_{};
};

class Features final : public ManyFiles {
 public:
  Features(const SessionHeader& header, const RecordPlan& plan, NextPath nextPath, const SessionWriterOptions& options)
      : ManyFiles(header, std::move(nextPath), withoutSamples(options)), plan_(plan) {}

  Status add(const StepInput& input, const StepOutput& output) override {
    constexpr Seconds kFileLength{3600.0};
    const Instant now = input.block.end();
    if (writer() != nullptr && secondsBetween(opened_, now) >= kFileLength) {
      if (Status s = close(); !s) return s;
    }
    if (writer() == nullptr) {
      if (Status s = openNext(); !s) return s;
      opened_ = now;
      kept_.reset();
    }
    const bool due = !kept_ || secondsBetween(*kept_, now) >= plan_.interval;
    if (!changes(input, output) && !due) {
      notKept_ = StepRecord{input, output};
      return Done{};
    }
    notKept_.reset();
    kept_ = now;
    return writer()->add(input, output);
  }

  // With the last step, which says how long it was as it was.
  Status close() override {
    if (writer() != nullptr && notKept_) {
      Status added = writer()->add(notKept_->input, notKept_->output);
      notKept_.reset();
      if (!added) return added;
    }
    return ManyFiles::close();
  }

 private:
  static SessionWriterOptions withoutSamples(SessionWriterOptions options) {
    options.samples = false;
    return options;
  }
  bool changes(const StepInput& input, const StepOutput& output) {
    bool other = input.inputCount > 0 || output.hasCommand || output.eventCount > 0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(output.verdictCount); ++d) {
      const Judged now{output.verdicts[d].state, output.verdicts[d].valid};
      other = other || now != judged_[d];
      judged_[d] = now;
    }
    return other;
  }

  struct Judged {
    CutState state{};
    bool valid = false;
    bool operator==(const Judged&) const = default;
  };

  RecordPlan plan_;
  Instant opened_{};
  std::optional<Instant> kept_;
  std::optional<StepRecord> notKept_;  // the last one
  std::array<Judged, kMaxDetectors> judged_{};
};

}  // namespace

std::unique_ptr<StepSink> oneFile(std::unique_ptr<SessionWriter> writer) {
  return std::make_unique<OneFile>(std::move(writer));
}

std::unique_ptr<StepSink> aroundEvents(const SessionHeader& header, const RecordPlan& plan, NextPath nextPath,
                                       const SessionWriterOptions& options) {
  return std::make_unique<AroundEvents>(header, plan, std::move(nextPath), options);
}

std::unique_ptr<StepSink> features(const SessionHeader& header, const RecordPlan& plan, NextPath nextPath,
                                   const SessionWriterOptions& options) {
  return std::make_unique<Features>(header, plan, std::move(nextPath), options);
}

}  // namespace stillcut::record
