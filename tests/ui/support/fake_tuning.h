// Parts with the program's own declarations, without a run behind them.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "core/control/fuzzy_params.h"
#include "core/control/registry.h"
#include "core/detect/caliskan/energy_ratio.h"
#include "core/detect/xu/coherence.h"
#include "core/safety/gate_limits.h"
#include "ui/models/tune/tuning.h"

namespace stillcut::ui {

class FakeTuning final : public Tuning {
 public:
  explicit FakeTuning(std::string_view inCharge = "stable-pocket") {
    add("energy-ratio", "Energy ratio", TunableComponent::Role::Detector, detect::energyRatioParams());
    TunableComponent& detector = parts_.back();
    detector.source = QStringLiteral("Caliskan, Kilic, Altintas 2018");
    detector.running = detector.inCharge = true;
    detector.detector = 0;
    detector.indicators = {QStringLiteral("er"),    QStringLiteral("frequency_hz"), QStringLiteral("changed"),
                           QStringLiteral("floor"), QStringLiteral("evidence"),     QStringLiteral("purity")};
    detector.chosen[detect::kErHarmonics.key] = 48.0;
    add("coherence", "Coherence", TunableComponent::Role::Detector, detect::coherenceParams());
    for (const auto& entry : control::strategyTable()) {
      if (entry.params.empty()) continue;
      const auto info = entry.make()->describe();
      add(info.id, info.label, TunableComponent::Role::Strategy, entry.params);
      parts_.back().running = parts_.back().inCharge = info.id == inCharge;
      if (info.id.starts_with("fuzzy")) giveRules(parts_.back());
    }
    add("gate", "Limits of the machine", TunableComponent::Role::Gate, safety::gateParams());
    parts_.back().running = true;
    static constexpr config::ParamDecl kTaps = config::integerParam("active.taps", "Taps", 35, 1, 512, "Of the filter");
    static constexpr const config::ParamDecl* kActive[] = {&kTaps};
    add("active", "Active work-holder", TunableComponent::Role::Active, kActive);
  }
  std::uint32_t tuningRun() const override { return run_; }
  const std::vector<TunableComponent>& tunableParts() const override { return parts_; }
  TuningController& controller() override { return *controller_; }
  // Another run in the place of this one, with its own values.
  void openOther() {
    ++run_;
    controller_->open({});
  }
  // Another one beside it is shown.
  void show(std::unique_ptr<TuningController>& other) {
    ++run_;
    std::swap(controller_, other);
  }
  Result<QString> saveValues(const config::ParamSet& values) override {
    if (refuse) return Error{message("mill3.toml"), message("cannot be written"), message("the disk is full")};
    saved = values;
    return QStringLiteral("/home/mill/profiles/mill3.toml");
  }

  const RuleTables* rulesNow() override { return rules ? &*rules : nullptr; }
  std::vector<AutoReading> ownNow(const TunableComponent& part) override {
    return part.inCharge && part.role == TunableComponent::Role::Detector ? own : std::vector<AutoReading>();
  }

  std::vector<AutoReading> own;

  std::optional<RuleTables> rules;
  bool refuse = false;
  std::optional<config::ParamSet> saved;

 private:
  // As app/session does.
  static void giveRules(TunableComponent& part) {
    const config::ParamTable cells = control::fuzzyRuleParams(), centres = control::fuzzyCentreParams();
    const auto first = std::find(part.params.begin(), part.params.end(), cells.front());
    part.params.erase(first, first + static_cast<std::ptrdiff_t>(cells.size()));
    part.speedRules.assign(cells.begin(), cells.begin() + 81);
    part.feedRules.assign(cells.begin() + 81, cells.end());
    part.setCentres.assign(centres.begin(), centres.end());
  }
  void add(std::string_view id, std::string_view label, TunableComponent::Role role, config::ParamTable params) {
    TunableComponent part;
    part.id = QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
    part.label = QString::fromUtf8(label.data(), static_cast<qsizetype>(label.size()));
    part.role = role;
    part.params.assign(params.begin(), params.end());
    parts_.push_back(std::move(part));
  }

  std::vector<TunableComponent> parts_;
  std::unique_ptr<TuningController> controller_ = std::make_unique<TuningController>();
  std::uint32_t run_ = 0;
};

}  // namespace stillcut::ui
