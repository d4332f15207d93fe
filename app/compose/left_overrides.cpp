#include "app/compose/left_overrides.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/compose/resource_folder.h"
#include "app/io/override_file.h"
#include "core/cnc/remembering_link.h"

namespace stillcut::app {
namespace {

// Where it is reached, and nothing else: limits and what was measured change, and passwords belong in no file name.
constexpr std::array<std::string_view, 5> kAddress{"host", "port", "device", "map", "sender_port"};

std::string machineName(const config::Profile& profile) {
  std::string name = profile.link.id;
  for (const auto& [key, value] : profile.link.settings) {
    if (std::find(kAddress.begin(), kAddress.end(), key) != kAddress.end())
      name.append(" ").append(key).append("=").append(value);
  }
  return name;
}

}  // namespace

std::filesystem::path defaultLeftFolder() {
  return userFolder("XDG_STATE_HOME", ".local/state") / "overrides";
}

std::unique_ptr<cnc::CncLink> remembered(std::unique_ptr<cnc::CncLink> link, const config::Profile& profile,
                                         const std::string& folder,
                                         const std::shared_ptr<cnc::SentOverridesCell>& offered) {
  if (!link || link->describe().simulated) return link;
  auto memory = std::make_unique<OverrideFile>(folder, machineName(profile));
  return std::make_unique<cnc::RememberingLink>(std::move(link), std::move(memory), offered);
}

Message leftSentence(const cnc::SentOverrides& left) {
  return message(
      "a Stillcut that was killed left spindle %1 %, feed %2 %; the operator had %3 %, %4 %: BACK TO 100 % brings that "
      "back",
      left.speed.sent, left.feed.sent, left.speed.base, left.feed.base);
}

}  // namespace stillcut::app
