#include "core/milling/stability/lobe_sweep.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>

#include "core/milling/stability/zeroth_order.h"

namespace stillcut::milling {

namespace {

constexpr std::size_t kChunk = 8;  // neighbouring speeds share a hint; the chunks, not the threads, fix the numbers
constexpr std::size_t kMostSpeeds = 1'000'000;

using SolveOne = std::function<Result<SpeedLimits>(Rpm, Metres hint)>;

class Sweeper {
 public:
  Sweeper(std::span<const Rpm> speeds, const SweepOptions& options, const SolveOne& solve, std::stop_token stop)
      : speeds_(speeds), options_(options), solve_(solve), stop_(std::move(stop)), results_(speeds.size()) {}

  Result<LobeSweep> run() {
    const std::size_t chunks = (speeds_.size() + kChunk - 1) / kChunk;
    const auto wanted = static_cast<std::size_t>(std::clamp(options_.threads, 1, 64));
    {
      std::vector<std::jthread> others;
      for (std::size_t i = 1; i < std::min(wanted, chunks); ++i) others.emplace_back([this] { work(); });
      work();
    }
    if (error_) return *error_;
    LobeSweep sweep;
    sweep.speeds = std::move(results_);
    sweep.maxAxialDepth = options_.limits.maxAxialDepth;
    sweep.finished = done_ == speeds_.size() && !stop_.stop_requested();
    return sweep;
  }

 private:
  void work() {
    for (;;) {
      const std::size_t first = kChunk * next_.fetch_add(1);
      if (first >= speeds_.size()) return;
      Metres hint{};
      for (std::size_t i = first; i < std::min(first + kChunk, speeds_.size()); ++i) {
        if (stop_.stop_requested() || failed_) return;
        Result<SpeedLimits> one = solve_(speeds_[i], hint);
        if (!one) {
          fail(one.error());
          return;
        }
        hint = one->hasLimit() ? one->crossings.front().depth : options_.limits.maxAxialDepth;
        results_[i] = std::move(one.value());
        report();
      }
    }
  }

  void fail(const Error& error) {
    const std::lock_guard lock(mutex_);
    failed_ = true;
    if (!error_) error_ = error;
  }

  void report() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (options_.progress) options_.progress(static_cast<double>(done_) / static_cast<double>(speeds_.size()));
  }

  std::span<const Rpm> speeds_;
  const SweepOptions& options_;
  const SolveOne& solve_;
  std::stop_token stop_;
  std::vector<SpeedLimits> results_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::size_t done_ = 0;        // guarded by mutex_
  std::optional<Error> error_;  // guarded by mutex_
};

Result<LobeSweep> sweepWith(const SolveOne& solve, std::span<const Rpm> speeds, const SweepOptions& options,
                            const std::stop_token& stop, std::vector<Message> warnings) {
  Result<LobeSweep> sweep = Sweeper(speeds, options, solve, stop).run();
  if (sweep) sweep.value().warnings = std::move(warnings);
  return sweep;
}

// A vibration needs several cells a wave, or the scheme sees another one.
Message coarseCells(const CutModel& model, std::span<const Rpm> speeds, const SdmOptions& sdm) {
  const Rpm slowest = *std::min_element(speeds.begin(), speeds.end());
  const int cells = sdm.cells > 0 ? sdm.cells : cellsFor(model, slowest);
  const double wanted = std::ceil(kLeastCellsPerWave * wavesBetweenTeeth(model, slowest));
  if (!(wanted > cells)) return {};
  const double from = slowest.value * wanted / cells;
  return message("semi-discretization with %1 cells is too coarse below %2 rpm: take %3 or more, or the exact method",
                 std::to_string(cells), std::to_string(std::lround(from)), std::to_string(std::lround(wanted)));
}

Message tooLow(const ExactLobes& lobes) {
  return message(
      "speeds below %1 rpm are unknown: for teeth that differ or have a shape the exact method does not reach lower",
      std::to_string(std::lround(lobes.lowestSpeed().value)));
}

}  // namespace

Result<LobeSweep> sweepLobes(const CutModel& model, std::span<const Rpm> speeds, const SweepOptions& options,
                             const std::string& where, const std::stop_token& stop) {
  if (speeds.empty()) return Error{where, message("no spindle speed is given")};
  if (Status ok = ExactLobes::checkDepth(options.limits.maxAxialDepth); !ok) return ok.error();
  std::vector<Message> warnings;
  switch (options.method) {
    case LobeMethod::Exact: {
      const Result<ExactLobes> lobes = ExactLobes::make(model, where);
      if (!lobes) return lobes.error();
      const auto unknown = [&](Rpm speed) { return lobes->checkSpeed(speed) && !lobes->possible(speed); };
      if (std::any_of(speeds.begin(), speeds.end(), unknown)) warnings.push_back(tooLow(*lobes));
      const SolveOne solve = [&](Rpm speed, Metres hint) -> Result<SpeedLimits> {
        if (unknown(speed)) return SpeedLimits{speed, {}, {}, false};
        LimitOptions one = options.limits;
        one.hint = hint;
        return lobes->limits(speed, one, stop);
      };
      return sweepWith(solve, speeds, options, stop, std::move(warnings));
    }
    case LobeMethod::SemiDiscretization: {
      const Result<SemiDiscretization> sdm = SemiDiscretization::make(model, options.sdm, where);
      if (!sdm) return sdm.error();
      if (Message coarse = coarseCells(model, speeds, options.sdm); !coarse.empty()) warnings.push_back(coarse);
      const SolveOne solve = [&](Rpm speed, Metres) -> Result<SpeedLimits> {
        if (changesWithSpeed(model)) {
          const auto here = SemiDiscretization::make(modelAt(model, speed), options.sdm, where);
          return here ? here->limit(speed, options.limits.maxAxialDepth, 80, stop) : here.error();
        }
        return sdm->limit(speed, options.limits.maxAxialDepth, 80, stop);
      };
      return sweepWith(solve, speeds, options, stop, std::move(warnings));
    }
    case LobeMethod::ZerothOrder:
      break;
  }
  const Result<ZerothOrder> zoa =
      options.measured ? ZerothOrder::make(model, *options.measured, where) : ZerothOrder::make(model, where);
  if (!zoa) return zoa.error();
  if (!zoa->warning().empty()) warnings.push_back(zoa->warning());
  if (model.material.processDamping != 0.0) {
    warnings.push_back(message("the zeroth order leaves out process damping: its limits at low speed are too low"));
  }
  const SolveOne solve = [&](Rpm speed, Metres) -> Result<SpeedLimits> {
    if (changesWithSpeed(model) && !options.measured) {
      const auto here = ZerothOrder::make(modelAt(model, speed), where);
      return here ? here->limit(speed, options.limits.maxAxialDepth, stop) : here.error();
    }
    return zoa->limit(speed, options.limits.maxAxialDepth, stop);
  };
  return sweepWith(solve, speeds, options, stop, std::move(warnings));
}

Result<std::vector<Rpm>> speedSteps(Rpm from, Rpm to, Rpm step, const std::string& where) {
  const bool sensible = isFinite(from) && isFinite(to) && isFinite(step) && from.value > 0.0 && to >= from;
  if (!sensible) return Error{where, message("speeds must be FROM:TO:STEP with 0 < FROM <= TO")};
  if (!(step.value > 0.0)) return Error{where, message("the step between speeds must be above zero")};
  const double steps = std::floor((to - from) / step + 1e-6);
  if (steps >= static_cast<double>(kMostSpeeds))
    return Error{where, message("more than a million speeds"), message("take a larger step")};
  std::vector<Rpm> speeds;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i) {
    speeds.push_back(from + static_cast<double>(i) * step);
  }
  if (std::abs((speeds.back() - to).value) < 1e-6 * step.value) speeds.back() = to;
  return speeds;
}

}  // namespace stillcut::milling
