#include "tests/support/known_cuts/known_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/milling/simulation/noise.h"
#include "core/milling/simulation/simulated_cut.h"
#include "tests/support/known_cuts/doubling.h"
#include "tests/support/known_cuts/spindle_turns.h"

namespace stillcut::bench {
namespace {

constexpr int kBlock = 64;

std::filesystem::path casePath(const std::string& name, const char* suffix) {
  return detect::testing::sharedDir() / "cases" / (name + suffix);
}

double number(const nlohmann::json& j, const char* key, double otherwise) {
  const auto it = j.find(key);
  return it != j.end() && it->is_number() ? it->get<double>() : otherwise;
}

double rms(const std::vector<float>& x, double rate, double from, double to) {
  const auto first = std::min(x.size(), static_cast<std::size_t>(from * rate));
  const auto last = std::min(x.size(), static_cast<std::size_t>(to * rate));
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i) sum += static_cast<double>(x[i]) * static_cast<double>(x[i]);
  return last > first ? std::sqrt(sum / static_cast<double>(last - first)) : 0.0;
}

void addNoise(KnownCut& cut, const SimulationOrder& order) {
  milling::NoiseSource noise(order.scenario.seed * 77 + 5);
  for (auto& channel : cut.recording.channels) {
    const double size = order.noise * rms(channel, cut.recording.rate, order.quietFrom, order.quietTo);
    for (float& x : channel) x += static_cast<float>(size * noise.normal());
  }
}

// So many frames earlier, by a sinc under a Hann window; whole frames exactly.
std::vector<double> delayed(const std::vector<float>& x, double frames) {
  constexpr int kReach = 16;
  const auto whole = static_cast<std::ptrdiff_t>(std::floor(frames));
  const double part = frames - std::floor(frames);
  std::array<double, 2 * kReach> taps{};
  for (int k = 0; k < 2 * kReach; ++k) {
    const double t = k - kReach + 1 - part;
    const double window = std::cos(0.25 * kTwoPi * t / (kReach + 1));
    const double sinc = std::abs(t) < 1e-9 ? 1.0 : std::sin(0.5 * kTwoPi * t) / (0.5 * kTwoPi * t);
    taps[static_cast<std::size_t>(k)] = sinc * window * window;
  }
  std::vector<double> out(x.size(), 0.0);
  const auto size = static_cast<std::ptrdiff_t>(x.size());
  for (std::ptrdiff_t i = whole + kReach; i < size; ++i) {
    double sum = 0.0;
    for (int k = 0; k < 2 * kReach; ++k) {
      const std::ptrdiff_t at = i - whole - (k - kReach + 1);
      if (at < size) sum += taps[static_cast<std::size_t>(k)] * static_cast<double>(x[static_cast<std::size_t>(at)]);
    }
    out[static_cast<std::size_t>(i)] = sum;
  }
  return out;
}

struct Line {
  double hz = 0.0;  // stands there
  int order = 0;    // ... or goes with the spindle, where above 0
};

// Power of one line over `turns` of the spindle from a time on, as a part of all power; both channels together. What it
// was as long after `before` is taken from it as a vector.
double linePart(const KnownCut& cut, const Line& of, double from, double turns, double before = kNever) {
  const auto span = static_cast<std::size_t>(turns * 60.0 / rpmAt(cut, from) * cut.recording.rate);
  std::vector<double> stood;
  if (of.order > 0) stood = turnsOf(cut, cut.recording.frames());
  const auto phase = [&](std::size_t i) {
    return of.order > 0 ? of.order * stood[i] : of.hz / cut.recording.rate * static_cast<double>(i);
  };
  double line = 0.0;
  double all = 0.0;
  for (const auto& x : cut.recording.channels) {
    const auto sum = [&](double begin, double& power) {
      const auto first = static_cast<std::size_t>(begin * cut.recording.rate);
      std::complex<double> total;
      for (std::size_t i = 0; i < span && first + i < x.size(); ++i) {
        const double u = std::sin(0.5 * kTwoPi * (static_cast<double>(i) + 0.5) / static_cast<double>(span));
        const double value = static_cast<double>(x[first + i]);
        total += u * u * value * std::polar(1.0, -kTwoPi * phase(first + i));
        power += value * value;
      }
      return total;
    };
    std::complex<double> vector = sum(from, all);
    double earlier = 0.0;
    if (std::isfinite(before)) vector -= sum(before, earlier);
    line += std::norm(vector) * 8.0 / static_cast<double>(span);
  }
  return all > 0.0 ? line / all : 0.0;
}

// With runout a cut beyond its limit may settle on a spindle harmonic without ever showing the line at which the
// linearised cut grows; then the harmonic that has grown most out of the stable cut is what there is.
void takeLockedLine(KnownCut& cut, const SimulationOrder& order) {
  constexpr double kTurns = 16.0;
  constexpr double kThere = 1e-3;  // of the power: a twentieth of what the line has at an amplitude of 20 %
  constexpr double kOnOrder = 0.01;
  if (!(cut.chatterHz > 0.0)) return;
  // What lies nearer to an order of period doubling than so many turns resolve, and is weaker than what twice as many
  // turns show that order to have gained since the onset began, is that order's skirt. Runout alone gains nothing.
  const double rpm = rpmAt(cut, cut.at20);
  const double orders = cut.chatterHz * 60.0 / rpm;
  const int nearest = static_cast<int>(std::lround(orders));
  const double away = std::abs(orders - nearest);
  const double line = linePart(cut, {cut.chatterHz}, cut.at20, kTurns);
  const bool doubles = 2 * (nearest % cut.teeth) == cut.teeth && away > kOnOrder && away < 2.0 / kTurns;
  const double before = std::max(0.0, cut.at1 - 2.0 * kTurns * 60.0 / rpm);
  const bool skirt = doubles && linePart(cut, {cut.chatterHz}, cut.at20, 2.0 * kTurns) <
                                    linePart(cut, {.order = nearest}, cut.at20, 2.0 * kTurns, before);
  if (line > kThere && !skirt) return;
  double most = 0.0;
  for (int n = 1; n < 8 * cut.teeth; ++n) {
    if (n % cut.teeth == 0) continue;
    const Line on{.order = n};
    const double grown = linePart(cut, on, cut.at20, kTurns) - linePart(cut, on, order.quietFrom, kTurns);
    if (grown <= most) continue;
    most = grown;
    cut.chatterHz = n * rpm / 60.0;
    cut.kind = 2 * (n % cut.teeth) == cut.teeth ? ChatterKind::Flip : ChatterKind::Hopf;
  }
}

double meanSquare(const KnownCut& cut, double from, double seconds) {
  double sum = 0.0;
  for (const auto& x : cut.recording.channels) {
    const double r = rms(x, cut.recording.rate, from, from + seconds);
    sum += r * r;
  }
  return sum;
}

// A mode on a spindle order makes runout most of the vibration, chatter or not; it grows with the depth long before the
// limit and stays as it is beyond, or becomes less where the speed takes the order off the mode. Where nothing in the
// vibration becomes more at the onset there was none to be seen, and no truth to hold anybody to.
void dropUnseenOnset(KnownCut& cut) {
  constexpr double kTurns = 8.0;
  constexpr double kSame = 0.05;  // in power: a ratio of 20 % adds 4 %, and is not the end of it
  constexpr double kSoon = 0.1;   // s
  const double rpm = rpmAt(cut, cut.at20);
  const double orders = cut.chatterHz * 60.0 / rpm;
  if (!(cut.at20 > 0.0) || std::abs(orders - std::round(orders)) > 1e-3) return;
  const double seconds = kTurns * 60.0 / rpm;
  const double before = meanSquare(cut, std::min(cut.at1, cut.at20) - kSoon - seconds, seconds);
  const double after = meanSquare(cut, cut.at20 + kSoon, seconds);
  if (before > 0.0 && after / before - 1.0 < kSame) cut.at1 = cut.at20 = kNever;
}

void takeEarlierInstability(KnownCut& cut, const milling::ChatterTruth& truth) {
  constexpr double kFlicker = 0.05;  // s: shorter ones, and shorter gaps, are none
  auto& found = cut.unstableBefore;
  for (const auto& entry : truth.log()) {
    const auto time = static_cast<double>(entry.time);
    if (!entry.unstable || time > cut.at1) continue;
    if (found.empty() || time > found.back().second + kFlicker) found.emplace_back(time, time);
    found.back().second = time;
  }
  std::erase_if(found, [&](const auto& stretch) {
    return stretch.second - stretch.first < kFlicker || stretch.second > cut.at1 - kFlicker;
  });
}

// Period doubling with even teeth and runout. The difference over whole turns, which the truth goes by, sees it once it
// has locked, both its times in one; and the companion that says since when a small disturbance grows begins that from
// a thousandth of another motion that dies. Nor does it know the runout, and takes all that alternates for chatter as
// soon as the cut without it would double. Chatter begins where it is seen by itself (doubling.h), and is there when
// both say so; where that never sees it there is none. Where it ends, the truth's companion loses sight of it as soon
// as the linearised cut is not sure to double: it lasts as long as it changes its sign.
void refineDoubling(KnownCut& cut, const SimulationOrder& order) {
  if (!order.scenario.programme.speedOverTime.segments.empty()) return;
  const auto doubling = doublingOf(cut, order);
  if (!doubling) return;
  const bool seen = doubling->at20 > 0.0;
  cut.at1 = seen ? std::min(cut.at1, doubling->at1) : kNever;
  cut.at20 = seen ? std::max(cut.at20, doubling->at20) : kNever;
  if (order.recovers) cut.lastAbove = doubling->lastAbove;
}

// Hopf chatter near a spindle order. The truth takes it for one that repeats as the forced vibration does, and goes by
// the departure from what the cut would do if vibration left no marks; but regeneration changes the forced vibration as
// well, and more of it as the load rises. As long as the line is so far from the order that the difference from turn to
// turn holds more of it than of all that is random, and what it holds hardly depends on where the line is exactly, that
// says itself when the chatter has 20 % of the forced vibration's amplitude.
void refineNearOrder(KnownCut& cut, const SimulationOrder& order, const milling::ChatterTruth& truth) {
  constexpr double kLeast = 0.2, kFull = 0.5;  // amplitude, as the truth's
  constexpr double kStable = 0.2;              // s, at least, in which what is random is heard
  constexpr double kMoves = 2e-3;              // of its frequency, as it grows
  const double orders = cut.chatterHz * 60.0 / rpmAt(cut, cut.at20);
  if (std::abs(orders - std::round(orders)) < 3.0 * kMoves * orders) return;
  const auto ratio = [&](const milling::ChatterTruth::LogEntry& entry) {
    const double sine = std::sin(0.5 * kTwoPi * cut.chatterHz / static_cast<double>(entry.spindleHz));
    const double total = static_cast<double>(entry.forcedAndChatterRms);
    const double part = static_cast<double>(entry.chatterRms) / (4.0 * sine * sine);
    return part < total ? part / std::sqrt(total * total - part * part) : 1.0;
  };
  double from = kNever;
  double full = kNever;
  double random = 0.0;
  bool repeats = false;
  for (const auto& entry : truth.log()) {
    const auto time = static_cast<double>(entry.time);
    if (time > order.quietTo - kStable && time < cut.at1) random = std::max(random, ratio(entry));
    if (time < cut.at20 || full > 0.0) continue;
    if (std::isnan(from)) repeats = entry.repeats;
    if (ratio(entry) < kLeast || std::isnan(from)) from = time;
    if (ratio(entry) >= kFull) full = time;
  }
  if (repeats && full > 0.0 && random < 0.5 * kLeast) cut.at20 = from;
}

void takeTruth(KnownCut& cut, const SimulationOrder& order, const milling::ChatterTruth& truth) {
  const milling::ChatterOnset onset = truth.onset();
  cut.at1 = onset.at1;
  cut.at20 = onset.at20;
  cut.chatterHz = truth.chatterFrequency().value;
  cut.kind = truth.kind();
  takeLockedLine(cut, order);
  dropUnseenOnset(cut);
  takeEarlierInstability(cut, truth);
  if (cut.kind == ChatterKind::Hopf && cut.at20 > 0.0) refineNearOrder(cut, order, truth);
  if (cut.kind == ChatterKind::Flip && cut.teeth % 2 == 0 && cut.at20 > 0.0) refineDoubling(cut, order);
  if (!order.recovers) return;
  const Hertz chatter = truth.chatterFrequency();
  for (const auto& entry : truth.log()) {
    const auto time = static_cast<double>(entry.time);
    const bool above = time > cut.at20 && truth.ratioAt(entry, chatter) > 0.2;
    if (above && !(cut.lastAbove >= time)) cut.lastAbove = time;
  }
}

// The limits are of vibration so small that every tooth stays in the material. Where runout on a mode takes some out of
// it before their time a cut may chatter below them: then what it does in the end differs from turn to turn by more
// than what shakes a stable one (0.2 to 3 % of its amplitude), and it is not one to be silent on.
bool repeatsInTheEnd(const KnownCut& cut) {
  constexpr double kMost = 0.2;  // amplitude, as the truth calls chatter
  constexpr double kSeconds = 0.25, kTurns = 6.0;
  const double turn = 60.0 * cut.recording.rate / cut.rpm;
  const auto last = static_cast<std::size_t>(std::max(kSeconds * cut.recording.rate, kTurns * turn));
  double changed = 0.0;
  double all = 0.0;
  for (const auto& x : cut.clean) {
    const std::vector<double> before = delayed(x, turn);
    for (std::size_t i = x.size() - std::min(last, x.size()); i < x.size(); ++i) {
      const double now = static_cast<double>(x[i]);
      changed += 0.5 * (now - before[i]) * (now - before[i]);
      all += now * now;
    }
  }
  return changed < kMost * kMost * all;
}

}  // namespace

bool haveSharedCut(const std::string& name) {
  return std::filesystem::exists(casePath(name, ".json"));
}

KnownCut sharedCut(const std::string& name, AlarmRule rule) {
  std::ifstream in(casePath(name, ".json"));
  const nlohmann::json j = nlohmann::json::parse(in);
  KnownCut cut;
  cut.family = "shared";
  cut.name = name;
  cut.rule = rule;
  cut.recording = detect::testing::readWav(casePath(name, "_acc.wav"));
  cut.teeth = j.at("teeth").get<int>();
  cut.rpm = j.at("spindle_rpm").get<double>();
  cut.at1 = number(j, "onset_1pct_s", kNever);
  cut.at20 = number(j, "onset_20pct_s", kNever);
  cut.chatterHz = number(j, "chatter_hz_at_onset", number(j, "chatter_hz", 0.0));
  if (cut.chatterHz > 0.0) cut.kind = ChatterKind::Hopf;
  const double out = number(j, "exit_end_s", kNever);
  cut.silentFrom = out + 0.1;
  return cut;
}

KnownCut simulate(const SimulationOrder& order) {
  milling::SimulatedCut plant(order.scenario);
  KnownCut cut;
  cut.family = order.family;
  cut.name = order.name;
  cut.rule = order.rule;
  cut.quantity = order.scenario.sensors.front().quantity;
  cut.teeth = order.scenario.model.tool.teeth;
  cut.rpm = order.scenario.programme.speed.value;
  cut.recording.rate = order.scenario.rate.value;
  cut.recording.channels.assign(order.scenario.sensors.size(), {});
  cut.machineStep = kBlock / cut.recording.rate;
  if (order.block > 0.0) cut.blockFrames = std::max(1, static_cast<int>(order.block * cut.recording.rate));
  const bool moves = !order.scenario.programme.speedOverTime.segments.empty();
  SampleBlock block;
  block.allocate(static_cast<int>(order.scenario.sensors.size()), kBlock);
  while (plant.fill(block)) {
    for (int c = 0; c < block.channels; ++c) {
      const auto samples = std::as_const(block).channel(c);
      auto& channel = cut.recording.channels[static_cast<std::size_t>(c)];
      channel.insert(channel.end(), samples.begin(), samples.end());
    }
    if (order.machineTells) cut.machine.push_back(plant.machineState());
    if (moves) cut.spindleRpm.push_back(plant.machineState().actualSpeed.value);
  }
  std::vector<std::vector<float>> heard;
  if (order.heard > 0) {
    const auto first = cut.recording.channels.begin();
    const auto last = first + order.heard;
    heard.assign(std::make_move_iterator(first), std::make_move_iterator(last));
    cut.recording.channels.erase(first, last);
  }
  if (order.scenario.programme.exit) cut.silentFrom = order.scenario.programme.exit->at + 0.1;
  if (order.doubling) {
    if (const auto doubling = doublingOf(cut, order); doubling && doubling->at20 > 0.0) {
      cut.at1 = doubling->at1;
      cut.at20 = doubling->at20;
      cut.chatterHz = doubling->hertz;
      cut.kind = ChatterKind::Flip;
    }
  } else {
    takeTruth(cut, order, plant.truth());
  }
  cut.clean = cut.recording.channels;
  if (order.repeats) cut.stable = repeatsInTheEnd(cut);
  if (order.heard > 0) cut.recording.channels = std::move(heard);
  addNoise(cut, order);
  return cut;
}

}  // namespace stillcut::bench
