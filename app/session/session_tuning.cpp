#include "app/session/session_tuning.h"

#include "app/session/run_tuning.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {

void SessionTuning::openCut(const config::ParamSet& params) {
  set_.clear();
  cut_.open(params);
}

void SessionTuning::take(ui::TuningController& from,
                         const std::function<void(const OperatorInput&, const config::ParamDecl*)>& send) {
  constexpr int kInputsPerTick = 4;  // as many as one block takes
  for (const OperatorInput& input : from.take(kInputsPerTick)) send(input, note(input));
}

const config::ParamDecl* SessionTuning::note(const OperatorInput& input) {
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  for (const config::ParamDecl* decl : catalog.all()) {
    if (config::parameterId(decl->key) != input.parameter) continue;
    config::ParamSet value;
    if (value.set(*decl, input.value, "tune")) set_[std::string(decl->key)] = value.text(*decl);
    return decl;
  }
  return nullptr;
}

QStringList SessionTuning::settings() const {
  QStringList settings;
  for (const auto& [key, value] : set_) {
    settings.push_back(QStringLiteral("%1=%2").arg(QString::fromStdString(key), QString::fromStdString(value)));
  }
  return settings;
}

const std::vector<ui::TunableComponent>& SessionTuning::tunableParts() const {
  if (partsOf_ != generation()) {
    parts_ = app::tunableParts(shownRig());
    partsOf_ = generation();
  }
  return parts_;
}

const RuleTables* SessionTuning::rulesNow() {
  return shownRig().chain().parts().strategy->readRules(rules_) ? &rules_ : nullptr;
}

std::vector<ui::AutoReading> SessionTuning::ownNow(const ui::TunableComponent& part) {
  return ownReadings(shownRig(), part);
}

Result<QString> SessionTuning::saveValues(const config::ParamSet& values) {
  return keepValues({values, shownRig().params()}, profile(), folder());
}

}  // namespace stillcut::app
