// Where the scenarios, profiles, machine maps and the manual are: beside the installed program, or in the source tree.
#pragma once

#include <filesystem>
#include <string>

namespace stillcut::app {

// PREFIX/share/stillcut of the running program where that is a folder, so that an installed copy may be moved; else the
// source tree this program was built from. Not real-time.
std::filesystem::path resourceFolder();

// A file as somebody names it: `path` from `folder` where that exists, else below resourceFolder() where that is a
// file, so that "scenarios/demo.toml" means the same in every folder and in every copy. Else as the first. Not
// real-time.
std::string foundFile(const std::string& path, const std::filesystem::path& folder = {});

// Where files of a kind go that the user does not name: "stillcut" below $VARIABLE, as the XDG base directories say, or
// below `usual` in the home folder. It may not exist yet.
std::filesystem::path userFolder(const char* variable, const char* usual);

}  // namespace stillcut::app
