#include "app/session/file/file_judgement.h"

#include <algorithm>
#include <utility>

#include "app/compose/recording_rig.h"
#include "app/session/file/indicator_curve.h"
#include "app/session/file/state_track.h"
#include "app/session/session_view.h"
#include "core/detect/registry.h"
#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"
#include "ui/models/live_numbers.h"

namespace stillcut::app {
namespace {

std::vector<std::string> idsOf(FileDetectors detectors) {
  if (detectors == FileDetectors::Default) return {std::string(detect::kDefaultDetector)};
  std::vector<std::string> ids;
  for (const auto& row : detect::detectorTable()) {
    if (row.id != detect::kDefaultDetector) ids.emplace_back(row.id);
  }
  return ids;
}

// A sentence of ours, with a capital.
QString sentenceOf(const Message& message) {
  QString text = ui::sayCore(message);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

Result<FileJudgement> judgeFile(const std::string& path, const FileAsked& asked, BackgroundTask::Progress& progress) {
  RecordingOptions options;
  options.read = asked.read;
  options.teeth = asked.question.teeth;
  options.speed = asked.question.speed;
  options.methods.detectors = idsOf(asked.detectors);
  auto built = buildRecordingRig(path, options);
  if (!built) return built.error();
  Rig& rig = *built->rig;
  const ui::SessionInfo info = sessionInfo(rig);
  evaluate::RecordingJudge judge(rig.chain(), built->judged);
  std::vector<StateTrack> tracks(judge.detectors());
  std::vector<IndicatorCurve> curves(judge.detectors());
  const double length = std::max(built->format.length().value, 1e-9);
  double end = 0.0;
  const auto observe = [&](const StepInput& in, const StepOutput& out) {
    judge.observe(in, out);
    const double begin = secondsBetween(*judge.begin(), in.block.firstSample).value;
    end = secondsBetween(*judge.begin(), in.block.end()).value;
    for (std::size_t d = 0; d < tracks.size(); ++d) {
      tracks[d].add(out.verdicts[d], Seconds(begin), Seconds(end));
      curves[d].add(out.verdicts[d], Seconds(begin), Seconds(end));
    }
  };
  while (rig.advance(observe)) {
    progress.part.store(end / length, std::memory_order_relaxed);
    if (progress.stopped()) return Error{path, message("stopped")};
  }
  if (const Message fault = rig.device().fault(); !fault.empty()) return Error{{}, fault};
  if (!judge.begin()) return Error{path, message("holds no samples")};
  FileJudgement made;
  made.teeth = rig.setup().teeth;
  for (std::size_t d = 0; d < tracks.size(); ++d) {
    made.answers.push_back(judge.answer(d));
    const QString indicator = info.detectors[d].indicators.value(0);
    made.tracks.push_back({ui::sayCore(info.detectors[d].label.toStdString()), tracks[d].states(),
                           curves[d].curve(indicator, ui::limitOfIndicator(indicator, info.limits))});
  }
  const Rpm heard(60.0 * judge.summary(0).spindle_Hz);
  made.speed = made.answers.front().advice.present.value > 0.0 ? made.answers.front().advice.present
               : heard.value > 0.0                             ? heard
                                                               : rig.setup().nominalSpeed;
  return made;
}

evaluate::AnswerWriting screenWriting() {
  evaluate::AnswerWriting writing;
  writing.number = [](double value, int decimals) { return ui::number(value, decimals).toStdString(); };
  writing.speed = [](Rpm speed) { return ui::number(speed.value).toStdString(); };
  writing.reason = [](const Reason& reason) { return ui::reasonWords(reason).toStdString(); };
  return writing;
}

SummaryAnswer sentencesOf(const FileJudgement& judgement) {
  const RecordingAnswer& answer = judgement.answers.front();
  const evaluate::AnswerWriting writing = screenWriting();
  SummaryAnswer words{answer.finding, {evaluate::findingSentence(answer, writing)}};
  if (answer.finding == Finding::Chatter) {
    if (Message advice = evaluate::adviceSentence(answer.advice, writing); !advice.empty())
      words.sentences.push_back(std::move(advice));
  }
  words.sentences.push_back(evaluate::judgedSentence(answer, writing));
  words.sentences.push_back(evaluate::hearingSentence(answer, writing));
  for (Message& line : evaluate::channelSentences(answer, writing)) words.sentences.push_back(std::move(line));
  return words;
}

ui::FileAnswer inWords(const ui::FileQuestion& question, const FileJudgement& judgement) {
  const RecordingAnswer& answer = judgement.answers.front();
  const evaluate::AnswerWriting writing = screenWriting();
  ui::FileAnswer words;
  words.question = question;
  words.finding = answer.finding;
  words.headline = sentenceOf(evaluate::findingSentence(answer, writing));
  if (answer.finding == Finding::Chatter) words.advice = sentenceOf(evaluate::adviceSentence(answer.advice, writing));
  words.details << sentenceOf(evaluate::judgedSentence(answer, writing))
                << sentenceOf(evaluate::hearingSentence(answer, writing));
  for (const Message& line : evaluate::channelSentences(answer, writing)) words.details << sentenceOf(line);
  words.teeth = judgement.teeth;
  words.chatter = answer.chatter;
  words.judgedTo = answer.hearsTo;
  words.spindle = Hertz(judgement.speed.value / 60.0);
  words.tracks = judgement.tracks;
  return words;
}

}  // namespace stillcut::app
