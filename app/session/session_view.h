// What the screens are told once of a rig. Thread: GUI.
#pragma once

#include <QString>
#include <string_view>

#include "app/compose/rig.h"
#include "ui/facade/session_info.h"

namespace stillcut::app {

QString viewText(std::string_view s);
// Everything but the source's label and the wall clock.
ui::SessionInfo sessionInfo(const Rig& rig);
// Where `decl` is one of the limits that are drawn.
void takeLimit(ui::LimitMarks& limits, const config::ParamDecl& decl, double value);
// What the detectors have made of their limits themselves, which is what decides: a channel that is loud in the calm
// cut is asked for more. As of now; what no detector has said stays.
void takeOwnLimits(ui::LimitMarks& limits, const Rig& rig);

}  // namespace stillcut::app
