// Parts with the program's own declarations, without a run behind them.
#pragma once

#include "core/control/registry.h"
#include "core/detect/coherence.h"
#include "core/detect/energy_ratio.h"
#include "core/safety/gate_limits.h"
#include "ui/models/tuning.h"

namespace stillcut::ui {

class FakeTuning final : public Tuning {
 public:
  FakeTuning() {
    add("energy-ratio", "Energy ratio", TunablePart::Role::Detector, detect::energyRatioParams());
    TunablePart& inCharge = parts_.back();
    inCharge.source = QStringLiteral("Caliskan, Kilic, Altintas 2018");
    inCharge.running = inCharge.inCharge = true;
    inCharge.detector = 0;
    inCharge.indicators = {QStringLiteral("er"),    QStringLiteral("frequency_hz"), QStringLiteral("changed"),
                           QStringLiteral("floor"), QStringLiteral("evidence"),     QStringLiteral("purity")};
    inCharge.chosen[detect::kErHarmonics.key] = 48.0;
    add("coherence", "Coherence", TunablePart::Role::Detector, detect::coherenceParams());
    for (const auto& entry : control::strategyTable()) {
      if (entry.params.empty()) continue;
      const auto info = entry.make()->describe();
      add(info.id, info.label, TunablePart::Role::Strategy, entry.params);
      parts_.back().running = parts_.back().inCharge = info.id == "stable-pocket";
    }
    add("gate", "Limits of the machine", TunablePart::Role::Gate, safety::gateParams());
    parts_.back().running = true;
  }
  std::uint32_t tuningRun() const override { return run; }
  const std::vector<TunablePart>& tunableParts() const override { return parts_; }
  const config::ParamSet& startValues() const override { return started_; }
  Result<QString> saveValues(const config::ParamSet& values) override {
    if (refuse) return Error{"mill3.toml", "cannot be written", "the disk is full"};
    saved = values;
    return QStringLiteral("/home/mill/profiles/mill3.toml");
  }

  std::uint32_t run = 0;
  bool refuse = false;
  std::optional<config::ParamSet> saved;

 private:
  void add(std::string_view id, std::string_view label, TunablePart::Role role, config::ParamTable params) {
    TunablePart part;
    part.id = QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
    part.label = QString::fromUtf8(label.data(), static_cast<qsizetype>(label.size()));
    part.role = role;
    part.params.assign(params.begin(), params.end());
    parts_.push_back(std::move(part));
  }

  std::vector<TunablePart> parts_;
  config::ParamSet started_;
};

}  // namespace stillcut::ui
