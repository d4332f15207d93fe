// A moment as a person types it. Any thread.
#pragma once

#include <QString>
#include <optional>

#include "ui/facade/session_info.h"

namespace stillcut::ui {

// "14:03", "14:03:20", "14:03:20.5" (the clock on the wall, last before `newest`), "-12.5" (seconds before `newest`).
std::optional<Instant> momentFrom(const QString& text, const SessionInfo& info, Instant newest);

}  // namespace stillcut::ui
