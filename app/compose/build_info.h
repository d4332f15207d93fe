// What this build is: version, commit, and the libraries it runs on. For `--version`, bug reports and session files.
#pragma once

#include <string>
#include <string_view>

namespace stillcut::app {

// Several lines: "PROGRAM VERSION (commit C)", then one line for each library: the version loaded, where the library
// can tell, else the one compiled against; last the compiler. `more` is a library that this program alone has.
std::string versionText(std::string_view program, std::string_view more = {});

}  // namespace stillcut::app
