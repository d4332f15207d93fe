// A TOML text that somebody has written, changed where its content changes and nowhere else: comments, blank lines,
// order, spelling of numbers and everything that is not asked for stay as they are.
// Thread: set-up and the settings pages.
#pragma once

#include <string>
#include <string_view>

namespace stillcut::config {

// `written`: what stands in the file. `before` and `after`: all of its content as TomlWriter writes it, as it is and as
// it shall be. A value that is gone takes its line with it, but not the comment behind it; what is new comes behind its
// neighbours. The elements of an array of tables are known again by their `name`.
// Whoever saves the answer reads it first: an unusual spelling (one table in several manners) may not take the change.
std::string editedToml(std::string_view written, std::string_view before, std::string_view after);

}  // namespace stillcut::config
