#include "app/cli/reading_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/config/nearest_word.h"

namespace stillcut::app {
namespace {

constexpr double kHighestRate = 1e7;  // [Hz]

constexpr auto kQuantities =
    std::to_array<std::string_view>({"acceleration", "velocity", "displacement", "sound", "force", "current", "speed"});

Result<SensorQuantity> quantityFrom(const std::string& text) {
  if (const auto quantity = sensorQuantityFromName(text)) return *quantity;
  const Message near = config::didYouMean(text, kQuantities);
  std::string all;
  for (const std::string_view q : kQuantities) all += (all.empty() ? "" : ", ") + std::string(q);
  return Error{"--quantity", message("'%1' is unknown", text), near.empty() ? message("choices: %1", all) : near};
}

}  // namespace

void addTimeUnit(CLI::App& command, std::string& unit) {
  command.add_option("--time-unit", unit, "Unit of times that a file has as numbers: s, ms, us, ns")
      ->check(CLI::IsMember({"s", "ms", "us", "ns"}));
}

std::optional<double> secondsOfTimeUnit(const std::string& unit) {
  for (const auto& [name, seconds] : {std::pair{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}) {
    if (unit == name) return seconds;
  }
  return std::nullopt;
}

void ReadingOptions::add(CLI::App& command) {
  command.add_option("--quantity", quantity_, "acceleration, velocity, displacement, sound, force, current or speed");
  command.add_option("--channel", channels_, "Channels, counted from 0: N[,N]")->delimiter(',');
  rateGiven_ = command.add_option("--rate", rate_, "Sampling rate of a text file without times [Hz]");
  addTimeUnit(command, timeUnit_);
  scaleGiven_ = command.add_option("--scale", scale_, "SI units per full scale or per unit of the file");
}

Result<record::ReadOptions> ReadingOptions::understand() const {
  record::ReadOptions options;
  if (rateGiven_->count() > 0) {
    if (!(rate_ > 0.0 && rate_ <= kHighestRate)) {
      return Error{"--rate", message("the rate must be above zero and at most 1e7 Hz")};
    }
    options.rate = Hertz(rate_);
  }
  options.secondsPerTime = secondsOfTimeUnit(timeUnit_);
  if (scaleGiven_->count() > 0) {
    if (!std::isfinite(scale_) || scale_ == 0.0) {
      return Error{"--scale", message("the scale must be a number other than zero")};
    }
    options.scale = scale_;
  }
  if (!quantity_.empty()) {
    const auto quantity = quantityFrom(quantity_);
    if (!quantity) return quantity.error();
    options.quantity = *quantity;
  }
  for (auto c = channels_.begin(); c != channels_.end(); ++c) {
    if (std::find(channels_.begin(), c, *c) != c) {
      return Error{"--channel", message("channel %1 is named twice", std::to_string(*c))};
    }
  }
  options.channels = channels_;
  return options;
}

}  // namespace stillcut::app
