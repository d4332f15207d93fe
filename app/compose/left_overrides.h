// What a killed program has left in a machine, from the record on the disk to the words on the screen.
// Thread: set-up; leftSentence(): any.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/message.h"
#include "core/cnc/cnc_link.h"
#include "core/cnc/override_memory.h"
#include "core/config/profile.h"

namespace stillcut::app {

// Of this user: ~/.local/state/stillcut/overrides.
std::filesystem::path defaultLeftFolder();

// `link`, of a real machine, with its orders on record below `folder`, under the machine's name and address in
// `profile`; what an earlier program has left there goes to `offered`, when the machine was read. A simulated one stays
// as it is: it ends with this program.
std::unique_ptr<cnc::CncLink> remembered(std::unique_ptr<cnc::CncLink> link, const config::Profile& profile,
                                         const std::string& folder,
                                         const std::shared_ptr<cnc::SentOverridesCell>& offered);

// "a Stillcut that was killed left spindle 83 %, feed 83 %; ..."
Message leftSentence(const cnc::SentOverrides& left);

}  // namespace stillcut::app
