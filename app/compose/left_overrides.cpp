#include "app/compose/left_overrides.h"

#include <utility>

#include "app/compose/resource_folder.h"
#include "app/io/override_file.h"
#include "core/cnc/registry.h"
#include "core/cnc/remembering_link.h"

namespace stillcut::app {
namespace {

// All that says which machine it is; what was measured of it changes.
std::string machineName(const config::Profile& profile) {
  std::string name = profile.link.id;
  for (const auto& [key, value] : profile.link.settings) {
    if (key != cnc::kSavedDelay && key != cnc::kSavedEffect) name.append(" ").append(key).append("=").append(value);
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
