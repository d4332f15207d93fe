#include "app/io/keeper_messages.h"

#include <bit>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "core/formats/hdf5/isolated_messages.h"

namespace stillcut::app {
namespace {

using Json = nlohmann::json;

static_assert(std::is_trivially_copyable_v<OverrideCommand>);
static_assert(std::is_trivially_copyable_v<KeeperOrder> && std::is_trivially_copyable_v<KeeperReport>);

// Another build of either end has other messages.
constexpr std::size_t kBuild = sizeof(KeeperOrder) * 65536 + sizeof(KeeperReport);

Json json(const cnc::SentOverride& o) {
  return Json::array({o.base, o.sent});
}

// Nothing in place of what another program may have written there.
template <class Read>
auto parsed(const std::string& text, Read&& read) -> std::optional<decltype(read(Json()))> {
  try {
    const Json all = Json::parse(text);
    if (all.at("build") != kBuild) return std::nullopt;
    return read(all);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

void KeeperOrder::carry(const OverrideCommand& c) noexcept {
  kind = Kind::Set;
  command = std::bit_cast<decltype(command)>(c);
}

std::optional<OverrideCommand> KeeperOrder::carried() const noexcept {
  constexpr double kMost = 10.0;  // of a factor
  const auto c = std::bit_cast<OverrideCommand>(command);
  const auto sane = [](Ratio r) { return isFinite(r) && r.value >= 0.0 && r.value <= kMost; };
  if (c.kind() != CommandKind::Set || !sane(c.speed()) || !sane(c.feed())) return std::nullopt;
  return c;
}

void KeeperReport::take(const cnc::LinkInfo& info) noexcept {
  machineWatchdog = info.machineWatchdog;
  lowestSpeed = info.lowestSpeed;
  highestSpeed = info.highestSpeed;
  lowestFeed = info.lowestFeed;
  highestFeed = info.highestFeed;
  period = info.period;
}

void KeeperReport::giveTo(cnc::LinkInfo& info) const noexcept {
  info.machineWatchdog = machineWatchdog;
  info.lowestSpeed = lowestSpeed;
  info.highestSpeed = highestSpeed;
  info.lowestFeed = lowestFeed;
  info.highestFeed = highestFeed;
  info.period = period;
}

std::string toText(const KeeperBegin& begin) {
  Json all{{"build", kBuild},
           {"link", begin.link},
           {"settings", begin.settings},
           {"folder", begin.folder},
           {"speed", begin.programmedSpeed.value},
           {"feed", begin.programmedFeed.value},
           {"silent", begin.silentOutputs},
           {"locks", begin.locks},
           {"owner", begin.owner}};
  if (begin.left) all["left"] = Json::array({json(begin.left->speed), json(begin.left->feed)});
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<KeeperBegin> keeperBeginFrom(const std::string& text) {
  return parsed(text, [](const Json& all) {
    KeeperBegin begin;
    all.at("link").get_to(begin.link);
    all.at("settings").get_to(begin.settings);
    all.at("folder").get_to(begin.folder);
    all.at("speed").get_to(begin.programmedSpeed.value);
    all.at("feed").get_to(begin.programmedFeed.value);
    all.at("silent").get_to(begin.silentOutputs);
    all.at("locks").get_to(begin.locks);
    all.at("owner").get_to(begin.owner);
    if (all.contains("left")) {
      const auto part = [&](int which) {
        return cnc::SentOverride{all["left"][which].at(0), all["left"][which].at(1)};
      };
      begin.left = cnc::SentOverrides{part(0), part(1)};
    }
    return begin;
  });
}

std::string toText(const KeeperOpened& opened) {
  Json all{{"build", kBuild}, {"label", opened.label}};
  if (opened.refused) all["refused"] = record::apart::toJson(*opened.refused);
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<KeeperOpened> keeperOpenedFrom(const std::string& text) {
  return parsed(text, [](const Json& all) {
    KeeperOpened opened{all.at("label").get<std::string>(), {}};
    if (all.contains("refused")) opened.refused = record::apart::errorFrom(all.at("refused").get<std::string>());
    return opened;
  });
}

}  // namespace stillcut::app
