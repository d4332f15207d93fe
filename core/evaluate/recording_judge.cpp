#include "core/evaluate/recording_judge.h"

#include <algorithm>
#include <utility>

#include "core/evaluate/hearing_limit.h"
#include "core/evaluate/speed_answer.h"

namespace stillcut::evaluate {

RecordingJudge::RecordingJudge(const pipeline::Chain& chain, JudgedRecording recording)
    : chain_(&chain), recording_(std::move(recording)), faults_(recording_.setup.channels.size()), own_(chain) {
  for (const auto& detector : chain.parts().detectors)
    detectors_.push_back({VerdictLog(detector->describe().id, Instant{}), {}, {}});
}

void RecordingJudge::observe(const StepInput& input, const StepOutput& output) {
  const SampleBlock& block = input.block;
  if (!begin_) {
    begin_ = block.firstSample;
    for (Judged& d : detectors_) d.log = VerdictLog(d.log.summary().detector, *begin_);
  }
  const Seconds took(block.frames / block.rate.value);
  for (std::size_t d = 0; d < detectors_.size(); ++d) {
    const Verdict& verdict = output.verdicts[d];
    detectors_[d].log.observe(verdict);
    detectors_[d].alarms.observe(secondsBetween(*begin_, verdict.time), verdict);
    if (block.has(kBlockGap))
      detectors_[d].time.addMissing(Seconds(static_cast<double>(block.lostFrames) / block.rate.value));
    detectors_[d].time.observe(verdict, took);
    if (verdict.alarming() && verdict.spindle.value > 0.0) {
      detectors_[d].alarmTime += took.value;
      detectors_[d].alarmTurns += took.value * spindleOf(verdict).value;
    }
  }
  observeChannels(output, took);
  own_.observe();
}

// In full chatter the phases that the tracker follows may be the chatter's, so that a whole number of its waves seems
// to fit between two teeth. The two series of lines tell spindle and chatter apart.
Hertz RecordingJudge::spindleOf(const Verdict& verdict) const {
  const detect::SeriesLook& look = chain_->conditioner().series().newest();
  return look.certain && look.teethHeard ? look.spindle : verdict.spindle;
}

// What one block shows makes the block invalid and stands in no channel's status.
void RecordingJudge::observeChannels(const StepOutput& output, Seconds took) {
  const SensorStatus& status = chain_->conditioner().sensors();
  const Verdict& inCharge = output.verdicts[static_cast<std::size_t>(output.inCharge)];
  const int named = inCharge.valid ? -1 : channelOf(inCharge.reason);
  for (std::size_t c = 0; c < faults_.size() && c < status.channel.size(); ++c) {
    const Reason& fault = status.channel[c].fault;
    if (fault.code != ReasonCode::None) {
      faults_[c].add(fault, took);
    } else if (named == static_cast<int>(c)) {
      faults_[c].add(inCharge.reason, took);
    }
  }
}

int RecordingJudge::fileChannel(int channel) const {
  const auto c = static_cast<std::size_t>(channel);
  return channel >= 0 && c < recording_.fileChannels.size() ? recording_.fileChannels[c] : channel;
}

Reason RecordingJudge::asInFile(Reason reason) const {
  if (const int channel = channelOf(reason); channel >= 0) reason.n[0] = fileChannel(channel);
  if (reason.code == ReasonCode::InputDoubled) reason.n[1] = fileChannel(static_cast<int>(reason.n[1]));
  return reason;
}

RecordingAnswer RecordingJudge::answer(std::size_t d) const {
  const Judged& judged = detectors_[d];
  const VerdictLog::Summary summary = judged.log.summary();
  const auto inFile = [this](std::vector<UnjudgedTime> times) {
    for (UnjudgedTime& t : times) t.reason = asInFile(t.reason);
    return times;
  };
  RecordingAnswer answer;
  answer.detector = summary.detector;
  answer.finding = judged.time.finding();
  answer.length = judged.time.length();
  answer.judged = judged.time.judged();
  answer.air = judged.time.air();
  answer.notJudged = inFile(judged.time.notJudged());
  answer.alarms = summary.alarms;
  answer.firstAlarm = Seconds(std::max(0.0, summary.firstAlarm_s));
  answer.chatter = Hertz(summary.frequency_Hz);
  answer.severity = summary.worstSeverity;
  const CutSetup& setup = recording_.setup;
  answer.hearsTo = hearingLimit(*chain_->parts().detectors[d], setup, Hertz(summary.spindle_Hz));
  for (std::size_t c = 0; c < setup.channels.size(); ++c) {
    answer.channels.push_back({fileChannel(static_cast<int>(c)), setup.channels[c].name, setup.channels[c].quantity,
                               inFile(faults_[c].longestFirst())});
  }
  answer.leftOut = recording_.leftOut;
  if (answer.finding != Finding::Chatter) return answer;
  const Rpm inSignal(judged.alarmTime > 0.0 ? 60.0 * judged.alarmTurns / judged.alarmTime : 60.0 * summary.spindle_Hz);
  const StableSpeeds* known = setup.stableSpeeds ? &*setup.stableSpeeds : nullptr;
  answer.advice = answerSpeed(
      {{answer.chatter, setup.teeth, inSignal.value > 0.0 ? inSignal : setup.nominalSpeed, recording_.reach, known},
       recording_.depthLimit});
  return answer;
}

}  // namespace stillcut::evaluate
