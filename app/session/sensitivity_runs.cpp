#include "app/session/sensitivity_runs.h"

#include <utility>

#include "app/compose/recording_score.h"
#include "core/evaluate/recorded_truth.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

struct Count {
  int alarms = 0, markedFalse = 0;
};

Result<Count> countOf(const std::string& file, const std::string& detector, const std::vector<std::string>& settings,
                      BackgroundTask::Progress& progress) {
  const auto truth = evaluate::truthIn(file);
  const evaluate::RecordedTruth known = truth && truth.value() ? *truth.value() : evaluate::RecordedTruth{};
  ScoreRequest request;
  request.detectors = {detector};
  request.settings = settings;
  request.goOn = [&progress](double) { return !progress.stopped(); };
  const auto scored = scoreRecording(file, known, request);
  if (!scored) return scored.error();
  return Count{static_cast<int>(scored->alarms.at(detector).size()), scored->byDetector.at(detector).falseAlarms};
}

}  // namespace

void SensitivityRuns::start(std::vector<std::string> files, std::string detector, const QStringList& settings) {
  std::vector<std::string> wanted;
  for (const QString& setting : settings) wanted.push_back(setting.toStdString());
  // What the question before still writes goes to its own board.
  board_ = std::make_shared<Board>();
  board_->trial.recordings = static_cast<int>(files.size());
  board_->trial.running = !files.empty();
  if (files.empty()) return task_.leave();
  task_.start(ui::TaskState::What::Detectors, {},
              [board = board_, files = std::move(files), detector = std::move(detector),
               wanted](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                for (const std::string& file : files) {
                  const auto with = countOf(file, detector, wanted, progress);
                  const auto without = with ? countOf(file, detector, {}, progress) : with;
                  if (progress.stopped()) break;
                  const std::scoped_lock lock(board->mutex);
                  ui::SensitivityTrial& trial = board->trial;
                  if (!without) {
                    trial.problem = ui::sayError(without.error());
                    continue;
                  }
                  ++trial.looked;
                  trial.alarms += with->alarms;
                  trial.markedFalse += with->markedFalse;
                  trial.alarmsNow += without->alarms;
                  trial.falseNow += without->markedFalse;
                }
                const std::scoped_lock lock(board->mutex);
                board->trial.running = false;
                return BackgroundTask::Apply{};
              });
}

ui::SensitivityTrial SensitivityRuns::collect() {
  (void)task_.collect();
  const std::scoped_lock lock(board_->mutex);
  return board_->trial;
}

}  // namespace stillcut::app
