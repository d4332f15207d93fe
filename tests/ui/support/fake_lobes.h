// Lobes for the screens' tests: a question runs until the test lets it finish; the limit is a row of equal pockets.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "ui/facade/learned_lobes.h"

namespace stillcut::ui {

class FakeLobes final : public LobeService {
 public:
  FakeLobes() {
    frame_.name = QStringLiteral("model of the test");
    frame_.programmed = Rpm(8800);
    frame_.lowest = Rpm(4000);
    frame_.highest = Rpm(14000);
    frame_.reachLow = Rpm(4400);
    frame_.reachHigh = Rpm(10560);
    frame_.depth = Metres(1.5e-3);
    frame_.maxAxialDepth = Metres(4e-3);
    frame_.widthOfCut = Metres(8e-3);
    frame_.feedPerTooth = Metres(40e-6);
    frame_.teeth = 4;
  }
  const LobeFrame& frame() const override { return frame_; }
  Metres axialDepthAt(Instant) const override { return frame_.depth; }
  void ask(const LobeQuestion& question) override {
    asked_ = question;
    progress_ = {LobeProgress::State::Running, 0.3, {}};
  }
  void cancel() override { progress_.state = LobeProgress::State::Cancelled; }
  LobeProgress progress() const override { return progress_; }
  std::shared_ptr<const LobeDiagram> diagram() const override { return diagram_; }

  void learn() override { ++timesLearned_; }
  std::shared_ptr<const LearnedLobes> learned() const override { return learned_; }
  void setLearned(LearnedLobes learned) { learned_ = std::make_shared<const LearnedLobes>(std::move(learned)); }
  int timesLearned() const { return timesLearned_; }

  const std::optional<LobeQuestion>& asked() const { return asked_; }
  LobeFrame& mutableFrame() { return frame_; }
  // 1 mm between pockets 3 mm deep, 2500 rpm apart.
  void finish() {
    auto diagram = std::make_shared<LobeDiagram>();
    diagram->number = ++answers_;
    diagram->question = asked_.value();
    for (int k = 0; k <= 200; ++k) {
      const Rpm n = frame_.lowest + (frame_.highest - frame_.lowest) * (k / 200.0);
      const double wave = 0.5 + 0.5 * std::cos(kTwoPi * (n.value - 7000.0) / 2500.0);
      diagram->limits.push_back({n, Metres(1e-3 + 2e-3 * std::pow(wave, 4)), true, ChatterKind::Hopf, Hertz(940)});
    }
    diagram_ = std::move(diagram);
    progress_ = {LobeProgress::State::Done, 1.0, {}};
  }

 private:
  LobeFrame frame_;
  LobeProgress progress_;
  std::shared_ptr<const LobeDiagram> diagram_;
  std::optional<LobeQuestion> asked_;
  std::uint32_t answers_ = 0;
  std::shared_ptr<const LearnedLobes> learned_;
  int timesLearned_ = 0;
};

}  // namespace stillcut::ui
