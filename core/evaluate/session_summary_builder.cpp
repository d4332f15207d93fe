#include "core/evaluate/session_summary_builder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/evaluate/scenario_reader.h"
#include "core/evaluate/sensor_tally.h"
#include "core/model/judged_cut.h"
#include "core/pipeline/catalog.h"
#include "core/pipeline/intervention_log.h"
#include "core/pipeline/spectrum_tap.h"
#include "core/sensing/feed_now.h"
#include "core/session/file/session_markers.h"
#include "core/session/session_glance.h"

namespace stillcut::evaluate {
namespace {

constexpr std::size_t kMostPoints = 4096;   // of the curves
constexpr std::size_t kMostColumns = 2048;  // of the spectrogram
constexpr std::size_t kMostEvents = 400;
constexpr std::size_t kMostSettings = 400;
constexpr int kBlockFrames = 1024;

CutState worse(CutState a, CutState b) {
  return std::max(a, b);
}

void merge(SummaryPoint& into, const SummaryPoint& other) {
  into.time = Seconds(0.5 * (into.time.value + other.time.value));
  into.vibration = std::max(into.vibration, other.vibration);
  if (other.severity > into.severity) into.frequency = other.frequency;
  into.severity = std::max(into.severity, other.severity);
  into.state = worse(into.state, other.state);
  into.valid = into.valid || other.valid;
  into.gap = into.gap || other.gap;
  into.speed = other.speed;
  into.feed_m_s = other.feed_m_s;
}

void merge(SpectrumColumn& into, const SpectrumColumn& other) {
  into.time = into.time + (other.time - into.time) / 2;
  into.afterGap = into.afterGap || other.afterGap;
  if (other.chatter.value > 0.0) into.chatter = other.chatter;
  into.spindle = other.spindle;
  for (std::size_t b = 0; b < into.level_dB.size(); ++b)
    into.level_dB[b] = std::max(into.level_dB[b], other.level_dB[b]);
}

// A list that never grows beyond `most`: when it is full, neighbours become one, and from then on so many as that make
// one new entry.
template <class Entry>
class Thinned {
 public:
  explicit Thinned(std::size_t most) : most_(most) {}
  void add(const Entry& entry) {
    if (pending_ == 0) {
      entries_.push_back(entry);
    } else {
      merge(entries_.back(), entry);
    }
    pending_ = (pending_ + 1) % per_;
    if (entries_.size() < most_ || pending_ != 0) return;
    for (std::size_t i = 0; i < entries_.size() / 2; ++i) {
      entries_[i] = std::move(entries_[2 * i]);
      merge(entries_[i], entries_[2 * i + 1]);
    }
    entries_.resize(entries_.size() / 2);
    per_ *= 2;
  }
  std::vector<Entry> take() { return std::move(entries_); }
  std::size_t per() const { return per_; }

 private:
  std::size_t most_;
  std::size_t per_ = 1;      // entries that make one
  std::size_t pending_ = 0;  // already in the last one
  std::vector<Entry> entries_;
};

void describeFormat(SessionSummary& summary, const std::string& path, const record::RecordingFormat& format) {
  summary.file = path;
  summary.kind = format.kind;
  summary.programVersion = format.programVersion;
  summary.configuration = format.configuration;
  summary.session = format.setup.has_value() && !isScenarioFile(path);
  summary.operatorName = format.operatorName;
  summary.job = format.job;
  summary.started_ns = format.started_ns;
  summary.simulated = format.simulated;
  summary.closedCleanly = format.closedCleanly;
  if (format.setup) summary.setup = *format.setup;
  summary.setup.rate = format.rate;
  summary.setup.blockFrames = format.blockFrames > 0 ? format.blockFrames : kBlockFrames;
  summary.setup.channels.clear();
  for (const record::RecordedChannel& c : format.channels) summary.setup.channels.push_back(c.info);
}

class Builder {
 public:
  Builder(const std::string& path, const record::RecordingFormat& format)
      : curve_(kMostPoints), columns_(kMostColumns), tally_(format.channels) {
    describeFormat(summary_, path, format);
    tap_.prepare(summary_.setup);
  }

  void add(const SampleBlock& block, const StepRecord* step) {
    if (!started_) first_ = block.firstSample;
    if (kept_) endKept(block.firstSample);
    started_ = true;
    frames_ += static_cast<std::uint64_t>(block.frames);
    last_ = block.end();
    if (block.has(kBlockGap)) {
      ++summary_.gaps;
      summary_.lostFrames += block.lostFrames;
    }
    tally_.add(block);
    const double vibration = tally_.blockRms();
    const Verdict none;
    const Verdict& verdict =
        step != nullptr && step->output.verdictCount > 0 ? step->output.verdicts[inCharge(*step)] : none;
    tap_.feed(block, verdict);
    for (; seen_ < tap_.count(); ++seen_) columns_.add(tap_.column(seen_));
    addPoint(block, step, verdict, vibration);
    if (step == nullptr) return;
    tell(*step);
    // A step of a history of features, which has no samples, says how long it stands only when the next one comes.
    const Seconds own(summary_.setup.blockFrames / block.rate.value);
    followAlarms(*step, vibration, block.frames == 0 ? own : Seconds(block.frames / block.rate.value));
    if (block.frames == 0) kept_ = KeptStep{*step, block.firstSample + toDuration(own)};
  }

  // On the clock of the summary.
  std::vector<Marker> sinceFirst(std::vector<Marker> markers) const {
    for (Marker& marker : markers) {
      marker.begin = Instant(marker.begin - first_);
      marker.end = Instant(marker.end - first_);
    }
    return markers;
  }

  SessionSummary finish() {
    summary_.length = secondsBetween(first_, last_);
    summary_.curve = curve_.take();
    summary_.spectrogram = columns_.take();
    for (SpectrumColumn& column : summary_.spectrogram) column.time = Instant(column.time - first_);
    for (Event& event : summary_.events) event.time = Instant(event.time - first_);
    for (auto& [number, card] : cards_) {
      card.began = Instant(card.began - first_);
      card.commanded = Instant(card.commanded - first_);
      summary_.interventions.push_back(card);
    }
    if (summary_.spectrogram.size() > 1) {
      const Duration all = summary_.spectrogram.back().time - summary_.spectrogram.front().time;
      summary_.columnWidth = Seconds(toSeconds(all).value / static_cast<double>(summary_.spectrogram.size() - 1));
    }
    summary_.spectrumTop = tap_.top();
    summary_.chatterTime = log_.chatterTime();
    summary_.chatterLength = log_.chatterLength();
    summary_.alarms = log_.count();
    if (frames_ > 0) summary_.sensors = tally_.finish();  // without samples nothing can be said of them
    return std::move(summary_);
  }

 private:
  static std::size_t inCharge(const StepRecord& step) {
    return static_cast<std::size_t>(std::clamp(step.output.inCharge, 0, step.output.verdictCount - 1));
  }

  void addPoint(const SampleBlock& block, const StepRecord* step, const Verdict& verdict, double vibration) {
    SummaryPoint point;
    point.time = Seconds(secondsBetween(first_, block.firstSample).value + 0.5 * block.frames / block.rate.value);
    point.vibration = vibration;
    point.gap = block.has(kBlockGap);
    point.valid = hasState(verdict);
    point.state = point.valid ? verdict.state : CutState::AirCutting;
    point.severity = verdict.valid ? verdict.severity.value : 0.0;
    if (verdict.alarming()) point.frequency = verdict.frequency;
    if (step != nullptr && step->input.machine.valid) {
      const MachineState& machine = step->input.machine;
      point.speed = machine.actualSpeed.value > 0.0 ? machine.actualSpeed : machine.targetSpeed();
      point.feed_m_s = machine.programmedFeed.value * machine.feedOverride.value;
    }
    curve_.add(point);
  }

  // What is in the step of its own, once.
  void tell(const StepRecord& step) {
    summary_.highestAuthority = std::max(summary_.highestAuthority, step.output.authority);
    for (int e = 0; e < step.output.eventCount; ++e) {
      ++summary_.eventCount;
      if (summary_.events.size() < kMostEvents) {
        summary_.events.push_back(step.output.events[static_cast<std::size_t>(e)]);
      }
    }
    for (int i = 0; i < step.input.inputCount; ++i) noteSetting(step.input.inputs[static_cast<std::size_t>(i)]);
  }

  // The history kept no step between this one and the next because nothing changed: it was as now until then.
  void endKept(Instant next) {
    if (next > kept_->end) {
      for (Verdict& verdict : kept_->step.output.verdicts) verdict.time += next - kept_->end;
      kept_->step.output.hasCommand = false;
      followAlarms(kept_->step, 0.0, secondsBetween(kept_->end, next));
    }
    kept_.reset();
  }

  // The log finds the alarms again from what was decided; its own events are already in the file.
  void followAlarms(const StepRecord& step, double vibration, Seconds took) {
    output_ = step.output;
    output_.eventCount = 0;
    const MetresPerSecond feed = detect::feedNow(step.input.machine, summary_.setup.nominalFeed);
    log_.follow(step.input, output_, {vibration, feed}, took);
    const std::uint64_t oldest = log_.count() > kInterventionsShown ? log_.count() - kInterventionsShown : 0;
    constexpr std::size_t kMostCards = 200;
    for (std::uint64_t n = oldest; n < log_.count() && n < kMostCards; ++n) cards_[n] = log_.card(n);
  }

  // The parameters' names are those of this program; what it no longer knows is shown as a change all the same.
  void noteSetting(const OperatorInput& input) {
    if (input.action != OperatorAction::SetParameter) return;
    ++summary_.settingChangeCount;
    if (summary_.settingChanges.size() >= kMostSettings) return;
    SettingChange change;
    change.time = secondsBetween(first_, last_);
    const config::ParamDecl* decl = declOf(input.parameter);
    config::ParamSet value;
    if (decl != nullptr && value.set(*decl, input.value, "recorded")) {
      change.key = decl->key;
      change.value = value.text(*decl);
    }
    summary_.settingChanges.push_back(std::move(change));
  }
  const config::ParamDecl* declOf(std::uint32_t parameter) const {
    const auto& all = catalog_.all();
    const auto found = std::find_if(all.begin(), all.end(), [parameter](const config::ParamDecl* decl) {
      return config::parameterId(decl->key) == parameter;
    });
    return found == all.end() ? nullptr : *found;
  }

  struct KeptStep {
    StepRecord step;
    Instant end;  // of its own block
  };

  SessionSummary summary_;
  const config::ParamCatalog catalog_ = pipeline::fullCatalog();
  Thinned<SummaryPoint> curve_;
  Thinned<SpectrumColumn> columns_;
  SensorTally tally_;
  pipeline::SpectrumTap tap_;
  pipeline::InterventionLog log_;
  std::map<std::uint64_t, Intervention> cards_;
  StepOutput output_;
  std::uint64_t seen_ = 0;
  bool started_ = false;
  std::uint64_t frames_ = 0;
  std::optional<KeptStep> kept_;
  Instant first_{};
  Instant last_{};
};

}  // namespace

Result<SessionSummary> glimpseOf(const std::string& path) {
  SessionSummary summary;
  {
    const auto reader = openCut(path);
    if (!reader) return reader.error();
    describeFormat(summary, path, (*reader)->format());
    summary.length = (*reader)->format().length();
  }
  if (!summary.session) return summary;
  constexpr int kColumns = 2048;
  const auto sketch = record::sketchSession(path, kColumns);
  if (!sketch) return sketch.error();
  if (sketch->columns.size() != kColumns) {  // a history of features
    if (const auto glance = record::glanceAtSession(path)) summary.length = glance->length;
    return summary;
  }
  summary.length = secondsBetween(sketch->begin, sketch->end);
  for (int k = 0; k < kColumns; ++k) {
    const record::MinMax& column = sketch->columns[static_cast<std::size_t>(k)];
    SummaryPoint point;
    point.time = summary.length * ((k + 0.5) / kColumns);
    point.gap = std::isnan(column.min);
    point.vibration = point.gap ? 0.0 : 0.5 * (static_cast<double>(column.max) - column.min);
    summary.curve.push_back(point);
  }
  return summary;
}

Result<SessionSummary> summarizeRecording(const std::string& path, const record::ReadOptions& options,
                                          const record::TimeSpan& span, const std::function<bool(double)>& goOn) {
  auto reader = openCut(path, options);
  if (!reader) return reader.error();
  if (!span.whole()) {
    reader = record::openSpan(std::move(*reader), span, path);
    if (!reader) return reader.error();
  }
  const record::RecordingFormat& format = (*reader)->format();
  Builder builder(path, format);
  SampleBlock block;
  const int frames = format.blockFrames > 0 ? format.blockFrames : kBlockFrames;
  block.allocate(static_cast<int>(format.channels.size()), frames);
  const double allFrames = std::max(static_cast<double>(format.frames), 1.0);
  double framesRead = 0.0;
  std::uint64_t blocks = 0;
  for (;; ++blocks) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) return more.error();
    if (!*more) break;
    builder.add(block, (*reader)->recordedStep());
    framesRead += block.frames;
    if (goOn && !goOn(framesRead / allFrames)) return Error{path, message("stopped")};
  }
  if (blocks == 0) return Error{path, message("holds no samples")};
  SessionSummary summary = builder.finish();
  if (summary.session) {
    auto markers = record::readMarkers(path);
    if (!markers) return markers.error();
    summary.markers = builder.sinceFirst(std::move(markers).value());
  }
  return summary;
}

}  // namespace stillcut::evaluate
