#include "ui/models/tune/tuning_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/say.h"
#include "ui/models/tune/param_scale.h"

namespace stillcut::ui {
namespace {

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

class SetValues final : public QUndoCommand {
 public:
  SetValues(TuningController& controller, TuningController::Side side, int gesture,
            std::vector<TuningController::Change> changes, const QString& text)
      : QUndoCommand(text), controller_(controller), side_(side), gesture_(gesture), changes_(std::move(changes)) {}
  int id() const override { return 1; }
  void undo() override {
    for (const auto& change : changes_) controller_.apply(side_, *change.decl, change.before);
    emit controller_.changed();
  }
  void redo() override {
    for (const auto& change : changes_) controller_.apply(side_, *change.decl, change.after);
    emit controller_.changed();
  }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const SetValues*>(other);
    const bool oneSlider = changes_.size() == 1 && next->changes_.size() == 1 && side_ == next->side_ &&
                           gesture_ == next->gesture_ && changes_[0].decl == next->changes_[0].decl;
    if (!oneSlider) return false;
    changes_[0].after = next->changes_[0].after;
    setText(next->text());
    return true;
  }

 private:
  TuningController& controller_;
  TuningController::Side side_;
  int gesture_;
  std::vector<TuningController::Change> changes_;
};

void TuningController::open(const config::ParamSet& started) {
  undo_.clear();
  queue_.clear();
  seen_.clear();
  tally_.reset();
  started_ = started;
  sides_ = {started, started};
  side_ = A;
  emit changed();
}

void TuningController::resend() {
  queue_.clear();
  for (const auto& [key, decl] : seen_) {
    if (!same(value(*decl), started_.real(*decl))) enqueue(*decl, value(*decl));
  }
}

void TuningController::set(const config::ParamDecl& decl, double value) {
  if (!config::isLegal(decl, value) || same(value, this->value(decl))) return;
  push({{&decl, this->value(decl), value}},
       QStringLiteral("%1: %2").arg(sayCore(std::string(decl.label)), valueText(decl, value)));
}

void TuningController::setTogether(const std::vector<std::pair<const config::ParamDecl*, double>>& values,
                                   const QString& text) {
  std::vector<Change> changes;
  for (const auto& [decl, wanted] : values) {
    if (config::isLegal(*decl, wanted) && !same(wanted, value(*decl))) changes.push_back({decl, value(*decl), wanted});
  }
  if (!changes.empty()) push(std::move(changes), text);
}

void TuningController::resetToDefaults(const std::vector<const config::ParamDecl*>& decls) {
  std::vector<Change> changes;
  for (const config::ParamDecl* decl : decls) {
    if (!same(value(*decl), decl->fallback)) changes.push_back({decl, value(*decl), decl->fallback});
  }
  if (!changes.empty()) push(std::move(changes), tr("to the defaults"));
}

void TuningController::resetToStart(const std::vector<const config::ParamDecl*>& decls) {
  std::vector<Change> changes;
  for (const config::ParamDecl* decl : decls) {
    if (!same(value(*decl), started_.real(*decl))) changes.push_back({decl, value(*decl), started_.real(*decl)});
  }
  if (!changes.empty()) push(std::move(changes), tr("as the run began"));
}

void TuningController::push(std::vector<Change> changes, const QString& text) {
  undo_.push(new SetValues(*this, side_, gesture_, std::move(changes), text));
}

void TuningController::apply(Side side, const config::ParamDecl& decl, double value) {
  seen_[std::string(decl.key)] = &decl;
  if (!sides_[side].set(decl, value, "tune")) return;
  if (side == side_) enqueue(decl, value);
}

void TuningController::enqueue(const config::ParamDecl& decl, double value) {
  const std::uint32_t id = config::parameterId(decl.key);
  const auto waits = [id](const OperatorInput& input) { return input.parameter == id; };
  queue_.erase(std::remove_if(queue_.begin(), queue_.end(), waits), queue_.end());
  queue_.push_back({OperatorAction::SetParameter, Authority::Off, 0, id, value});
}

void TuningController::use(Side side) {
  if (side == side_) return;
  side_ = side;
  settle();
  for (const auto& [key, decl] : seen_) {
    if (!same(value(*decl, A), value(*decl, B))) enqueue(*decl, value(*decl));
  }
  emit changed();
}

void TuningController::copyToOther() {
  const Side other = side_ == A ? B : A;
  std::vector<Change> changes;
  for (const auto& [key, decl] : seen_) {
    if (!same(value(*decl, other), value(*decl))) changes.push_back({decl, value(*decl, other), value(*decl)});
  }
  if (changes.empty()) return;
  settle();
  undo_.push(new SetValues(*this, other, gesture_, std::move(changes), tr("both sides alike")));
  settle();
}

std::vector<std::string> TuningController::differences() const {
  std::vector<std::string> keys;
  for (const auto& [key, decl] : seen_) {
    if (!same(value(*decl, A), value(*decl, B))) keys.push_back(key);
  }
  return keys;
}

std::vector<OperatorInput> TuningController::take(int most) {
  std::vector<OperatorInput> inputs;
  while (!queue_.empty() && static_cast<int>(inputs.size()) < most) {
    inputs.push_back(queue_.front());
    queue_.pop_front();
  }
  return inputs;
}

}  // namespace stillcut::ui
