// A tap test that has been done along x: eight hits, two modes, lobes.
#pragma once

#include <cmath>

#include "ui/facade/tap_controller.h"

namespace stillcut::ui {

class FakeTapDesk final : public TapController {
 public:
  FakeTapDesk() {
    listening_.state = TapListening::State::Running;
    listening_.device = QStringLiteral("simulated-hammer");
    listening_.rate = Hertz(25600.0);
    listening_.channels = {{QStringLiteral("hammer"), QStringLiteral("N"), -1, true, false, 3.0, 412.0, false},
                           {QStringLiteral("tip x"), QStringLiteral("m/s2"), 0, false, true, 12.0, 3120.0, true}};
    listening_.force = 0;
    listening_.response = 1;
    for (const TapFault fault : {TapFault::None, TapFault::DoubleHit, TapFault::ForceOverload, TapFault::Weak,
                                 TapFault::Incoherent, TapFault::None, TapFault::Gap}) {
      hits_.push_back({218.4, Seconds(0.26e-3), fault, fault == TapFault::None, {}});
    }
    response_.state = TapResponse::State::Done;
    response_.version = 1;
    response_.from = 480.0;
    response_.to = 1980.0;
    response_.modes = {{Hertz(872.1), 0.4, 0.031, 0.0004, 2.41e7, 3e5, 1.0, 0.997, {}, true},
                       {Hertz(1654.0), 1.2, 0.024, 0.0007, 3.92e7, 9e5, 0.79, 0.982,
                        QStringLiteral("lies at the edge of the band"), true}};
    for (int k = 1; k <= 300; ++k) {
      const double f = 10.0 * k;
      std::complex<double> sum = 0.0;
      for (const TapMode& m : response_.modes) {
        const double u = f / m.frequency.value;
        sum += 1.0 / (m.stiffness * std::complex<double>(1.0 - u * u, 2.0 * m.damping * u));
      }
      response_.frequency.push_back(f);
      response_.fitted.push_back(sum);
      response_.measured.push_back(sum * (1.0 + 0.03 * std::sin(0.9 * k)));
      response_.coherence.push_back(f < 2400.0 ? 0.98 : 0.5);
    }
    lobes_.state = TapLobes::State::Done;
    lobes_.version = 2;
    for (int k = 0; k <= 100; ++k) {
      const Rpm speed(2000.0 + 160.0 * k);
      const double depth = 1e-3 * (1.2 + 0.9 * std::sin(0.2 * k));
      lobes_.limits.push_back({speed, Metres(depth), Metres(0.85 * depth), Metres(1.2 * depth)});
    }
    lobes_.speed = Rpm(13080.0);
    lobes_.depth = Metres(1.6e-3);
    lobes_.anySpeed = Metres(0.2e-3);
    lobes_.removal = 4.2e-7;
  }

  bool poll() override { return false; }
  std::vector<TapDevice> devices() const override { return offered; }
  std::vector<TapDevice> offered{{QStringLiteral("simulated-hammer"), QStringLiteral("Simulated hammer and tool")},
                                 {QStringLiteral("profile:mill3"), QStringLiteral("mill3")}};
  void listen(const QString& device) override { listening_.device = device; }
  void stopListening() override { listening_.state = TapListening::State::Off; }
  const TapListening& listening() const override { return listening_; }
  void chooseForce(int channel) override { listening_.force = channel; }
  void chooseResponse(int channel) override { listening_.response = channel; }
  void begin(int axis) override { run_.axis = axis; }
  void end() override { run_.phase = TapRun::Phase::Off; }
  TapRun run() const override { return run_; }
  const std::vector<TapHitRow>& hits(int) const override { return hits_; }
  void useHit(int, std::size_t hit, bool use) override { hits_[hit].used = use; }
  void openFiles(const QStringList& paths, int axis) override {
    files_ = paths;
    axisOfFiles = axis;
  }
  const TapFileReading& reading() const override { return fileReading; }
  void answer(const TapAnswers& answers) override { fileReading.answers = answers; }
  QString keptAlready(TapKept, const QString&) const override { return kept; }
  const QStringList& files() const override { return files_; }
  const TapResponse& response(int axis) const override { return axis == 0 ? response_ : none_; }
  void useMode(int, std::size_t mode, bool use) override { response_.modes[mode].used = use; }
  std::vector<TapMaterial> materials() const override {
    return {{QStringLiteral("4140"), QStringLiteral("Steel, alloyed, tempered")}};
  }
  void compute(const TapCut& cut) override { lobes_.cut = cut; }
  const TapLobes& lobes() const override { return lobes_; }
  QStringList tools() const override { return {QStringLiteral("T12 D12 Z4 R0.5")}; }
  TapCut withTool(TapCut cut, const QString&) const override {
    cut.teeth = 4;
    return cut;
  }
  Result<QString> saveCut(const QString&) override {
    return QStringLiteral("/home/mill/.local/share/stillcut/cuts/T12-D12-Z4-R0.5.toml");
  }
  Result<QString> saveModes(const QString& name) override {
    return QStringLiteral("/home/mill/.local/share/stillcut/modes/%1.toml").arg(name);
  }

  TapFileReading fileReading;
  QString kept;  // of any name
  int axisOfFiles = -1;

 private:
  TapListening listening_;
  TapRun run_{TapRun::Phase::HitNow, 0, 2, 5};
  std::vector<TapHitRow> hits_;
  QStringList files_;
  TapResponse response_, none_;
  TapLobes lobes_;
};

}  // namespace stillcut::ui
