#include "core/cnc/analog/analog_link.h"

#include <utility>

#include "core/cnc/move_order.h"

namespace stillcut::cnc {
namespace {

constexpr Seconds kPeriod{0.01};  // nothing comes back: a state is as old as the tick that made it

}  // namespace

AnalogLink::AnalogLink(AnalogMap map, std::unique_ptr<AnalogOutput> output, Rpm programmedSpeed,
                       MetresPerSecond programmedFeed)
    : map_(std::move(map)),
      output_(std::move(output)),
      programmedSpeed_(programmedSpeed),
      programmedFeed_(programmedFeed) {}

AnalogLink::~AnalogLink() {
  AnalogLink::release({});
}

LinkInfo AnalogLink::describe() const {
  LinkInfo info;
  info.id = "analog";
  info.label = map_.label;
  if (map_.speed) {
    const double unit = map_.speed->absolute ? programmedSpeed_.value : 100.0;
    info.lowestSpeed = Ratio(map_.speed->table.lowest() / unit);
    info.highestSpeed = Ratio(map_.speed->table.highest() / unit);
  }
  if (map_.feed) {
    info.lowestFeed = Ratio(map_.feed->table.lowest() * 0.01);
    info.highestFeed = Ratio(map_.feed->table.highest() * 0.01);
  }
  info.period = kPeriod;
  return info;
}

Status AnalogLink::open() {
  const std::string where = "link 'analog'";
  if (map_.speed && map_.speed->absolute) {
    const CalibrationTable& table = map_.speed->table;
    const bool inside = programmedSpeed_.value >= table.lowest() && programmedSpeed_.value <= table.highest();
    if (!inside) {
      return Error{where, message("the programmed speed is outside the speed table"),
                   message("the gear's table must hold [cut] speed_rpm, or there is nothing to go back to")};
    }
  }
  if (Status ready = output_->open(map_.device); !ready) return ready.error();
  opened_ = working_ = true;
  if (!writeBoth(1.0, 1.0))
    return Error{where, message("the output does not take the programmed values"), foreign(map_.device.file)};
  return Done{};
}

bool AnalogLink::writeOne(AnalogOutput& output, const std::optional<AnalogChannel>& to, double value) noexcept {
  return !to || output.write(to->channel, to->table.voltage(value));
}

bool AnalogLink::writeBoth(double speed, double feed) noexcept {
  const double speedUnit = map_.speed && map_.speed->absolute ? programmedSpeed_.value : 100.0;
  const auto writeSpeed = [&] { return writeOne(*output_, map_.speed, speed * speedUnit); };
  const auto writeFeed = [&] { return writeOne(*output_, map_.feed, feed * 100.0); };
  const bool feedGoesFirst = feedFirst(feed, feed_.value);
  const bool first = feedGoesFirst ? writeFeed() : writeSpeed();
  const bool second = feedGoesFirst ? writeSpeed() : writeFeed();
  working_ = first && second;
  if (working_) {
    speed_ = Ratio(map_.speed ? speed : 1.0);
    feed_ = Ratio(map_.feed ? feed : 1.0);
  }
  return working_;
}

MachineState AnalogLink::read(Instant now) noexcept {
  MachineState m;
  m.time = now;
  m.link.acknowledged = taken_;
  m.linkUp = m.valid = opened_ && working_;
  if (!m.valid) return m;
  m.programRunning = true;  // nobody tells; the cut gate knows from the samples
  m.atSpeed = true;
  m.programmedSpeed = programmedSpeed_;
  m.programmedFeed = programmedFeed_;
  m.speedOverride = speed_;
  m.feedOverride = feed_;
  return m;
}

void AnalogLink::apply(const OverrideCommand& command, Instant now) noexcept {
  if (command.kind() == CommandKind::Release) return release(now);
  if (opened_ && writeBoth(command.speed().value, command.feed().value)) taken_ = now;
}

void AnalogLink::release(Instant /*now*/) noexcept {
  if (opened_) writeBoth(1.0, 1.0);
}

}  // namespace stillcut::cnc
