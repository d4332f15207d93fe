// Files a command is to write, looked at before the work begins: a run of minutes should not end in "no such folder".
#pragma once

#include <string>

#include "core/base/result.h"

namespace stillcut::app {

// Empty `path`: nothing is to be written. An error when the folder is missing, when `path` is a folder, a device or a
// pipe (whole files are renamed into place, which would replace it), or the same file as `input`.
Status checkOutPath(const std::string& path, const std::string& input = {});

}  // namespace stillcut::app
