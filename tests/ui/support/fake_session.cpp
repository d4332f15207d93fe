#include "tests/ui/support/fake_session.h"

#include <algorithm>
#include <cmath>

namespace stillcut::ui {
namespace {

constexpr double kStep = 0.04;
constexpr double kProgrammed = 8800.0, kTarget = 8565.0, kFeed = 1408.0;
constexpr double kChatter = 1713.0;
constexpr double kCutDeepens = 4.5;

}  // namespace

FakeSession::FakeSession() {
  info_.setup.machine = "Mill 3";
  info_.setup.tool = "T12 D12 Z4 HSK63 stick-out 48";
  info_.setup.teeth = 4;
  info_.setup.toolDiameter = Metres(0.012);
  info_.setup.rate = Hertz(25600);
  info_.setup.channels = {{"x", SensorQuantity::Acceleration, 1.0, "x"}, {"y", SensorQuantity::Acceleration, 1.0, "y"}};
  info_.linkLabel = "LinuxCNC";
  info_.simulatedMachine = true;
  info_.machineWatchdog = true;
  info_.feedPerTooth = Metres(40e-6);
  info_.detectors = {{"energy-ratio", "Energy ratio", {"er"}}, {"coherence", "Coherence", {"gamma_max"}}};
  info_.limits = {0.3, 0.6, 10.0};
  info_.wallMsAtStreamZero = 1'780'000'000'000;
  recorder_ = {RecorderView::State::Recording, Seconds(760), {}};

  snapshot_.running = true;
  snapshot_.simulated = true;
  snapshot_.autoAllowed = true;
  snapshot_.detectorCount = 2;
  snapshot_.spectrumTop = Hertz(12800);
  snapshot_.health.blockLength = Seconds(0.01);
  snapshot_.interventionCount = 1;
  Intervention& earlier = snapshot_.interventions[0];
  earlier.began = instantFromNs(-34'000'000'000);
  earlier.finished = earlier.quiet = true;
  earlier.timeToStable = Seconds(0.084);
  earlier.frequency = Hertz(1698);
  earlier.speedBefore = Rpm(9000);
  earlier.speedAfter = Rpm(kProgrammed);
  earlier.feedBefore = fromMmPerMin(1440);
  earlier.feedAfter = fromMmPerMin(kFeed);
  earlier.cycleTime = Ratio(1.214);
  earlier.severityBefore = Ratio(0.71);
  earlier.severityAfter = Ratio(0.02);
  earlier.vibrationBefore = 11.4;
  earlier.vibrationAfter = 2.2;
  earlier.marked = Metres(0.0021);
}

const Snapshot* FakeSession::pull() {
  if (tuning_ != nullptr && started_) {
    for (const OperatorInput& input : tuning_->controller().take(4)) send(input, generation_);
  }
  return replay_ ? &*replay_ : live();
}

void FakeSession::send(const OperatorInput& input, std::uint32_t seen) {
  sent_.push_back(input);
  seen_.push_back(seen);
  Snapshot& s = snapshot_;
  switch (input.action) {
    case OperatorAction::SetAuthority:
      s.authority = input.authority;
      s.authoritySince = s.time;
      break;
    case OperatorAction::GrantBySimulation:
      s.authority = Authority::Auto;
      s.authoritySince = s.time;
      break;
    case OperatorAction::Accept:
      moved_ = s.adviceOpen || moved_;
      break;
    case OperatorAction::BackToProgrammed:
      moved_ = false;
      s.authority = Authority::Off;
      s.authoritySince = s.time;
      break;
    case OperatorAction::Hold:
    case OperatorAction::EndHold:
      s.operatorHold = input.action == OperatorAction::Hold;
      break;
    case OperatorAction::Refuse:
      s.adviceOpen = false;
      break;
    case OperatorAction::TrueAlarm:
    case OperatorAction::FalseAlarm:
    case OperatorAction::ReportChatter:
    case OperatorAction::SetParameter:
    case OperatorAction::UndoMark:
      break;
  }
}

void FakeSession::advance(Seconds total) {
  for (long k = std::lround(total.value / kStep); k > 0; --k) step();
}

void FakeSession::step() {
  Snapshot& s = snapshot_;
  started_ = true;
  s.time += toDuration(Seconds(kStep));
  ++s.number;
  s.health.blocks += 4;
  s.health.blockAge = Seconds(0.0038 + 1e-4 * static_cast<double>(s.number % 3));
  recorder_.length += Seconds(kStep);
  stepChatter();
  fillVerdict();
  fillAdvice();
  fillMachine();
  if (lost_.value > 0.0) {
    lost_ -= Seconds(kStep);
    return;
  }
  makeColumn();
  makeSignal();
}

// The teeth at a quarter of chatter's full size, in m/s2, on x; half of it on y.
void FakeSession::makeSignal() {
  SampleBlock block;
  const double rate = info_.setup.rate.value;
  block.allocate(2, static_cast<int>(std::lround(rate * kStep)));
  block.frames = block.capacityFrames;
  block.rate = info_.setup.rate;
  block.firstSample = snapshot_.time - toDuration(Seconds(kStep));
  const double t0 = sinceEpoch(block.firstSample).value;
  for (int i = 0; i < block.frames; ++i) {
    const double t = t0 + i / rate;
    const double value =
        5.0 * std::sin(kTwoPi * speed_ / 15.0 * t) + 20.0 * amplitude_ * std::sin(kTwoPi * kChatter * t);
    block.channel(0)[static_cast<std::size_t>(i)] = static_cast<float>(value);
    block.channel(1)[static_cast<std::size_t>(i)] = static_cast<float>(0.5 * value);
  }
  signal_.push_back(std::move(block));
}

void FakeSession::readSignal(const std::function<void(const SampleBlock&)>& sink) {
  for (const SampleBlock& block : signal_) sink(block);
  signal_.clear();
}

void FakeSession::stepChatter() {
  const double t = sinceEpoch(snapshot_.time).value;
  const bool unstable = t > kCutDeepens && !moved_;
  amplitude_ = std::clamp(amplitude_ * std::exp((unstable ? 6.0 : -7.0) * kStep), 1e-3, 1.0);
  const double target = moved_ ? kTarget : kProgrammed;
  speed_ += (target - speed_) * 0.4;
  snapshot_.vibrationRms = 2.1 + 14.0 * amplitude_;
}

void FakeSession::fillVerdict() {
  Snapshot& s = snapshot_;
  const double t = sinceEpoch(s.time).value;
  const double power = amplitude_ * amplitude_;
  Verdict v;
  v.time = s.time;
  v.phase = CutPhase::Steady;
  v.valid = t > 0.5;
  v.reason = v.valid ? Reason{} : Reason{ReasonCode::Learning, {0.5 - t}};
  v.severity = Ratio(0.06 + 0.9 * power / (power + 0.12));
  v.state = v.severity.value > 0.3 ? CutState::Chatter : v.severity.value > 0.1 ? CutState::Onset : CutState::Stable;
  v.spindle = Hertz(speed_ / 60.0);
  v.indicators[0] = v.severity.value;
  if (v.alarming()) {
    if (!alarmed_) onset_ = t;
    alarmed_ = true;
    peak_ = std::max(peak_, s.vibrationRms);
    v.kind = ChatterKind::Hopf;
    v.frequency = Hertz(kChatter);
    v.frequencySd = Hertz(1.6);
    v.sinceOnset = Seconds(t - onset_ + 0.01);
    v.feedSinceOnset = fromMmPerMin(kFeed).value * v.sinceOnset.value > 0
                           ? Metres(fromMmPerMin(kFeed).value * v.sinceOnset.value)
                           : Metres();
    s.chatterTime += Seconds(kStep);
    s.chatterLength += Metres(fromMmPerMin(kFeed).value * kStep);
  } else if (alarmed_) {
    finishIntervention();
  }
  s.verdicts[0] = v;
  s.verdicts[1] = v;
  s.verdicts[1].indicators[0] = 0.18 + 0.75 * amplitude_;
}

void FakeSession::finishIntervention() {
  Snapshot& s = snapshot_;
  alarmed_ = false;
  Intervention i;
  i.number = s.interventionCount;
  i.began = instantFromNs(static_cast<std::int64_t>(onset_ * 1e9));
  i.finished = i.quiet = true;
  i.timeToStable = Seconds(sinceEpoch(s.time).value - onset_);
  i.frequency = Hertz(kChatter);
  i.speedBefore = Rpm(kProgrammed);
  i.speedAfter = Rpm(kTarget);
  i.feedBefore = fromMmPerMin(kFeed);
  i.feedAfter = fromMmPerMin(kFeed * kTarget / kProgrammed);
  i.severityBefore = Ratio(0.62);
  i.severityAfter = Ratio(0.01);
  i.vibrationBefore = peak_;
  i.vibrationAfter = s.vibrationRms;
  i.marked = Metres(fromMmPerMin(kFeed).value * i.timeToStable.value);
  s.interventions[i.number % kInterventionsShown] = i;
  ++s.interventionCount;
  peak_ = 0.0;
}

void FakeSession::fillAdvice() {
  Snapshot& s = snapshot_;
  const bool chatter = s.verdicts[0].valid && s.verdicts[0].state == CutState::Chatter;
  if (chatter && s.authority == Authority::Auto && sinceEpoch(s.time).value > onset_ + 0.3) moved_ = true;
  s.request = OverrideRequest{};
  s.request.time = s.time;
  s.request.reason = {chatter ? ReasonCode::AuthorityOff : ReasonCode::NothingToDo, {}};
  s.adviceOpen = chatter && !moved_ && s.authority == Authority::Advise;
  if (chatter && s.authority != Authority::Off) {
    s.request.kind = RequestKind::Set;
    s.request.claimsSpeed = s.request.claimsFeed = true;
    s.request.speed = Rpm(kTarget);
    s.request.feed = fromMmPerMin(kFeed * kTarget / kProgrammed);
    s.request.reason = {ReasonCode::CentreOfNextPocket, {kTarget, 3, kChatter, kProgrammed}};
  }
  if (chatter) {
    s.advice = {SpeedAdvice::Kind::Speed,
                Rpm(kTarget),
                fromMmPerMin(kFeed * kTarget / kProgrammed),
                Rpm(kProgrammed),
                fromMmPerMin(kFeed),
                Hertz(kChatter),
                {},
                {ReasonCode::CentreOfNextPocket, {kTarget, 3, kChatter, kProgrammed}}};
  } else {
    s.advice = {};
  }
  s.commanding = moved_;
  s.command.kind = moved_ ? CommandKind::Set : CommandKind::Release;
  s.command.speed = s.command.feed = Ratio(moved_ ? kTarget / kProgrammed : 1.0);
  s.command.reason = moved_ ? Reason{ReasonCode::CentreOfNextPocket, {kTarget, 3, kChatter, kProgrammed}} : Reason{};
}

void FakeSession::fillMachine() {
  MachineState& m = snapshot_.machine;
  m.valid = m.linkUp = m.programRunning = m.atSpeed = true;
  m.time = snapshot_.time - std::chrono::microseconds(1200);
  m.programmedSpeed = Rpm(kProgrammed);
  m.programmedFeed = fromMmPerMin(kFeed);
  m.speedOverride = m.feedOverride = snapshot_.command.speed;
  m.actualSpeed = Rpm(speed_ - 1.0);
  m.actualFeed = fromMmPerMin(kFeed * speed_ / kProgrammed);
}

void FakeSession::makeColumn() {
  Snapshot& s = snapshot_;
  SpectrumColumn& c = s.columns[s.columnCount % kSpectrumColumns];
  c.number = s.columnCount++;
  c.time = s.time;
  c.afterGap = s.columnCount > 1 &&
               secondsBetween(s.columns[(c.number - 1) % kSpectrumColumns].time, s.time).value > 1.5 * kStep;
  c.channel = channel_;
  c.spindle = s.verdicts[0].spindle;
  c.chatter = s.verdicts[0].alarming() ? s.verdicts[0].frequency : Hertz();
  std::normal_distribution<double> noise(0.0, 2.2);
  const double binWidth = s.spectrumTop.value / kSpectrumBins, passing = speed_ / 60.0 * 4;
  const auto line = [&](double f, double at, double level) {
    const double d = (f - at) / (1.2 * binWidth);
    return level - 12.0 * d * d;
  };
  for (int b = 0; b < kSpectrumBins; ++b) {
    const double f = (b + 0.5) * binWidth;
    double level = -52.0 - f / 600.0 + noise(random_);
    for (int k = 1; k * passing < 9000; ++k)
      level = std::max(level, line(f, k * passing, -8.0 - 4.0 * k + 0.5 * noise(random_)));
    const double chatterLevel = 20.0 * std::log10(amplitude_) + 6.0;
    level = std::max(level, line(f, kChatter, chatterLevel));
    level = std::max(level, line(f, kChatter - passing, chatterLevel - 14));
    level = std::max(level, line(f, kChatter + passing, chatterLevel - 16));
    c.level_dB[static_cast<std::size_t>(b)] = static_cast<float>(level);
  }
}

}  // namespace stillcut::ui
