// SessionTuning: what the Tune page works on: the parameters of the cut, and those of a replay in its place; what was
// set reaches its run. Thread: GUI.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "app/compose/rig.h"
#include "app/session/sensitivity_runs.h"
#include "core/model/rule_tables.h"
#include "ui/models/tune/tuning.h"

namespace stillcut::app {

class SessionTuning final : public ui::Tuning {
 public:
  // What the pages show, as the session says it.
  std::function<std::uint32_t()> generation;
  std::function<const Rig&()> shownRig;
  std::function<bool()> replayShown;
  // Where changed values are kept: the profile of the run, empty: none; the folder for a file of parameters otherwise.
  std::function<std::string()> profile;
  std::function<QString()> folder;
  // The newest recordings, newest first.
  std::function<std::vector<std::string>()> recordings;

  // Another cut, or another recording; what was set for the one before is over. beginReplayAgain(): the same recording
  // from its beginning, with what was set.
  void openCut(const config::ParamSet& params);
  void openReplay(const config::ParamSet& params) { replay_.open(params); }
  void beginReplayAgain() { replay_.resend(); }
  // What was set since, as much as one block takes.
  void sendCut(const std::function<void(const OperatorInput&, const config::ParamDecl*)>& send) { take(cut_, send); }
  void sendReplay(const std::function<void(const OperatorInput&, const config::ParamDecl*)>& send) {
    take(replay_, send);
  }
  // KEY=VALUE of all that was set.
  QStringList settings() const;

  std::uint32_t tuningRun() const override { return generation(); }
  const std::vector<ui::TunableComponent>& tunableParts() const override;
  const RuleTables* rulesNow() override;
  std::vector<ui::AutoReading> ownNow(const ui::TunableComponent& part) override;
  ui::TuningController& controller() override { return replayShown() ? replay_ : cut_; }
  Result<QString> saveValues(const config::ParamSet& values) override;
  void tryOnRecordings(const QString& detector, const QStringList& settings) override {
    trials_.start(recordings ? recordings() : std::vector<std::string>(), detector.toStdString(), settings);
  }
  ui::SensitivityTrial trial() override { return trials_.collect(); }

 private:
  void take(ui::TuningController& from,
            const std::function<void(const OperatorInput&, const config::ParamDecl*)>& send);
  const config::ParamDecl* note(const OperatorInput& input);

  ui::TuningController cut_, replay_;
  std::map<std::string, std::string> set_;           // value by key
  mutable std::vector<ui::TunableComponent> parts_;  // of the generation partsOf_
  mutable std::optional<std::uint32_t> partsOf_;
  RuleTables rules_;  // as last read
  SensitivityRuns trials_;
};

}  // namespace stillcut::app
