// What a part of the detection has set itself, and why: for whoever reads it while the cut runs. A part declares the
// values once, each with the reasons it can have, and sets them as it goes.
// Thread: set() on the worker, real-time; read() on any, a value and its reason are each true by themselves.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

#include "core/config/param.h"

namespace stillcut::detect {

struct AutoValueDecl {
  std::string_view key;  // of the automatic parameter it stands for, or its own: "energy-ratio.floor"
  std::string_view label;
  std::string_view unit;
  std::span<const std::string_view> whys;  // the first: nothing is known yet, or somebody has set it
};

struct AutoValue {
  double value = std::numeric_limits<double>::quiet_NaN();  // not a number: not known yet
  std::size_t why = 0;                                      // index into AutoValueDecl::whys
};

using AutoValueTable = std::span<const AutoValueDecl>;

class AutoValues {
 public:
  static constexpr std::size_t kMost = 8;

  void set(std::size_t index, double value, std::size_t why) noexcept {
    values_[index].store(value, std::memory_order_relaxed);
    whys_[index].store(why, std::memory_order_relaxed);
  }
  AutoValue read(std::size_t index) const noexcept {
    return {values_[index].load(std::memory_order_relaxed), whys_[index].load(std::memory_order_relaxed)};
  }
  void forget() noexcept {
    for (std::size_t i = 0; i < kMost; ++i) set(i, config::kAutomatic, 0);
  }
  AutoValues() noexcept { forget(); }

 private:
  std::array<std::atomic<double>, kMost> values_{};
  std::array<std::atomic<std::size_t>, kMost> whys_{};
};

inline constexpr std::string_view kSetByHand = "as set";
inline constexpr std::string_view kNotLearned = "not yet: it is learned in the steady cut";
inline constexpr std::string_view kMeanOfStable = "mean of the stable cut so far";
inline constexpr std::string_view kHeldInAlarm = "held while an alarm lasts";

}  // namespace stillcut::detect
