// stillcut-cli analyze RECORDING ...: the detectors on recordings, side by side, and what to do about the chatter.
// Exit codes: 0 no chatter, 1 chatter (with --strict: or not judged), 2 a recording cannot be read.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/analyze/analysis_table.h"
#include "app/cli/analyze/analyze_options.h"
#include "app/cli/analyze/speed_doubt.h"
#include "app/cli/analyze/standard_input.h"
#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "core/evaluate/audacity_labels.h"
#include "core/evaluate/series_log.h"
#include "core/storage/atomic_file.h"

namespace stillcut::app {
namespace {

// One recording on its way through the detectors.
class Course {
 public:
  Course(const AnalyzeOptions& given, const RecordingRig& built, const std::string& recording)
      : given_(given), recording_(recording), judge_(built.rig->chain(), built.judged) {
    for (const auto& detector : built.rig->chain().parts().detectors) infos_.push_back(detector->describe());
  }

  void observe(const StepInput& in, const StepOutput& out) {
    judge_.observe(in, out);
    const Instant begin = *judge_.begin();
    if (!series_ && !given_.series.empty()) series_.emplace(infos_, begin);
    if (series_) series_->observe({out.verdicts.data(), judge_.detectors()});
    const Verdict& inCharge = out.verdicts.front();
    labels_.observe(secondsBetween(begin, inCharge.time), Seconds(in.block.frames / in.block.rate.value), inCharge);
    if (given_.lines) printChanges();
  }

  // All or none.
  Status writeFiles() const {
    nlohmann::json array = nlohmann::json::array();
    for (std::size_t d = 0; d < judge_.detectors(); ++d) judge_.log(d).appendEvents(array);
    const std::string events = given_.outPath(given_.events, recording_, ".events.json");
    const std::string labels = given_.outPath(given_.labels, recording_, ".labels.txt");
    const std::string series = given_.outPath(given_.series, recording_, ".series.csv");
    std::vector<std::string> written;
    const auto write = [&](const std::string& path, auto how) {
      if (path.empty()) return Status(Done{});
      Status s = how(path);
      if (s) written.push_back(path);
      if (!s) std::for_each(written.begin(), written.end(), [](const std::string& w) { std::remove(w.c_str()); });
      return s;
    };
    if (Status s = write(events, [&](const auto& p) { return writeFileAtomically(p, array.dump(1) + "\n"); }); !s)
      return s;
    if (Status s = write(labels, [&](const auto& p) { return writeFileAtomically(p, labels_.text()); }); !s) return s;
    return series_ ? write(series, [&](const auto& p) { return series_->write(p); }) : Status(Done{});
  }

  const evaluate::RecordingJudge& judge() const { return judge_; }

 private:
  void printChanges() {
    printed_.resize(judge_.detectors());
    for (std::size_t d = 0; d < judge_.detectors(); ++d) {
      nlohmann::json changes = nlohmann::json::array();
      judge_.log(d).appendEvents(changes, printed_[d]);
      printed_[d] = judge_.log(d).changes();
      for (nlohmann::json& change : changes) {
        change.update(jsonObject("analyze", "change"));
        change["recording"] = recording_;
        printJsonLine(change);
      }
    }
  }

  const AnalyzeOptions& given_;
  std::string recording_;
  evaluate::RecordingJudge judge_;
  std::vector<detect::DetectorInfo> infos_;
  std::optional<evaluate::SeriesLog> series_;
  evaluate::AudacityLabels labels_;
  std::vector<std::size_t> printed_;  // changes of each detector
};

// What the answer assumes because it was not given.
std::vector<std::string> remarks(const CutSetup& setup, const record::RecordingFormat& format, bool measuredSpeed,
                                 double spindle_Hz) {
  std::vector<std::string> lines;
  for (const Message& note : format.notes) lines.push_back(text(note));
  if (setup.teeth <= 0) lines.emplace_back("teeth not given (--teeth): judged by spindle harmonics alone");
  if (setup.nominalSpeed.value > 0.0 || measuredSpeed) return lines;
  char text[96];
  std::snprintf(text, sizeof text, "taken from the signal, on average %.0f rpm", 60.0 * spindle_Hz);
  lines.push_back("speed not given (--speed, --speed-log): " +
                  std::string(spindle_Hz > 0.0 ? text : "none found in the signal, nothing can be judged against it"));
  return lines;
}

struct Answered {
  Analysis analysis;
  Finding finding = Finding::NotJudged;
};

// `path`: where the recording is read, `recording`: as it was named.
Result<Answered> analyzeOne(const AnalyzeOptions& given, const RecordingOptions& options, const std::string& path,
                            const std::string& recording) {
  auto built = buildRecordingRig(path, options);
  if (!built) return built.error();
  Rig& rig = *built->rig;
  auto truth = given.truth ? evaluate::truthOf(path) : evaluate::truthIn(path);
  if (!truth && given.truth) return truth.error();  // else nobody has asked for it
  Course course(given, *built, recording);
  rig.runToEnd([&](const StepInput& in, const StepOutput& out) { course.observe(in, out); });
  if (const Message fault = rig.device().fault(); !fault.empty()) return Error{{}, fault};
  const evaluate::RecordingJudge& judge = course.judge();
  if (!judge.begin()) return Error{recording, message("holds no samples")};
  if (const Status s = course.writeFiles(); !s) return s.error();

  Answered answered;
  Analysis& a = answered.analysis;
  a.recording = recording;
  a.format = built->format;
  a.remarks = remarks(rig.setup(), built->format, !options.log.empty(), judge.summary(0).spindle_Hz);
  if (truth) a.truth = std::move(truth).value();
  for (std::size_t d = 0; d < judge.detectors(); ++d) {
    a.detectors.push_back(judge.summary(d));
    a.answers.push_back(judge.answer(d));
    if (a.truth) a.scores.push_back(evaluate::scoreAlarms(a.truth->spans, judge.alarms(d).alarms()));
  }
  if (given.values || given.json) a.own = judge.ownValues();
  answered.finding = a.answers.front().finding;
  const std::string doubt = speedDoubt(path, options.read, a.answers.front().channels, options.speed);
  if (!doubt.empty()) a.remarks.push_back(doubt);
  return answered;
}

// A name that stands for itself in messages: what was read from the standard input has none of its own.
Error named(Error error, const std::string& path, const std::string& recording) {
  std::string& where = error.where.verbatim;
  if (recording != path && where.starts_with(path)) where = recording + where.substr(path.size());
  return error;
}

void printError(const std::string& recording, const Error& error) {
  nlohmann::json line = jsonObject("analyze", "error");
  line["recording"] = recording;
  line["error"] = error.line();
  printJsonLine(line);
}

int exitCodeOf(Finding finding, bool strict) {
  if (finding == Finding::Chatter) return kExitChatter;
  return strict && finding == Finding::NotJudged ? kExitChatter : kExitDone;
}

int analyze(const AnalyzeOptions& given) {
  const auto options = given.understand();
  if (!options) return fail(options.error());
  if (given.lines && !given.json) return fail({"--lines", message("needs --json")});
  const bool several = given.recordings.size() > 1;
  int code = kExitDone;
  for (const std::string& recording : given.recordings) {
    std::optional<StandardInput> kept;
    if (recording == "-") {
      auto input = StandardInput::keep();
      if (!input) return fail(input.error());
      kept.emplace(std::move(input).value());
    }
    const std::string path = kept ? kept->path() : recording;
    const auto answered = analyzeOne(given, *options, path, recording);
    if (!answered) {
      const Error error = named(answered.error(), path, recording);
      if (given.json && several) printError(recording, error);
      code = std::max(code, fail(error));
      continue;
    }
    given.json ? printAnswerLine(answered->analysis) : printTable(answered->analysis);
    if (several && !given.json) std::printf("\n");
    code = std::max(code, exitCodeOf(answered->finding, given.strict));
  }
  return code;
}

}  // namespace

void addAnalyze(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<AnalyzeOptions>();
  CLI::App* command = app.add_subcommand("analyze", "Tell whether recordings hold chatter, and which speed helps");
  command->footer("Exit codes: 0 no chatter, 1 chatter (with --strict also: not judged), 2 cannot be read");
  o->add(*command);
  command->callback([o, command, &exitCode] {
    o->teethGiven = command->count("--teeth") > 0;
    o->speedGiven = command->count("--speed") > 0;
    exitCode = analyze(*o);
  });
}

}  // namespace stillcut::app
