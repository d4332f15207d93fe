// The cut of a tool whose modes are known, as a profile takes it: its file where that is a whole cut, else one that is
// written from the modes, the tool and its material. Thread: GUI; small files.
#pragma once

#include <QString>
#include <string>

#include "core/base/result.h"
#include "ui/facade/tool_entry.h"

namespace stillcut::app {

// What `modal` writes: [[mode]] and no [tool].
bool holdsModesAlone(const std::string& path);
// At the tool's full width, which no narrower cut has lower limits than. Error: no modes; no material, or none of that
// name; a pitch that does not close.
Status writeCut(const ui::ToolEntry& tool, const std::string& modesPath, const std::string& path);

// A file's name out of what people call a thing: "T12 D12/Z4" is "T12-D12-Z4.toml".
QString fileNameOf(const QString& name);

}  // namespace stillcut::app
