// What is said of what was learned from judged cuts: on the Lobes page one line of the whole, one of a place, one of a
// cut; on Operate how much deeper the present cut could go.
// GUI thread; pure functions.
#pragma once

#include <QString>

#include "ui/base/units.h"
#include "ui/facade/learned_lobes.h"

namespace stillcut::ui {

// From how many cuts, the recommended cut at the risk, the next most useful cut and why. Where nothing was learned:
// why, and what to do.
QString learnedLine(const LearnedLobes& learned, UnitSystem units);

// "Learned from cuts: stable here with 85 %". Empty: outside what was looked at, or nothing was learned.
QString learnedAt(const LearnedLobes& learned, const SpeedDepth& at);

// "Depth could rise by about 0.4 mm (0.2 to 0.7)", or that it could not.
QString marginLine(const DepthMargin& margin, UnitSystem units);

// "Chatter at 912 Hz, 8 400 rpm, 1.50 mm, 27.11.26 14:03"
QString evidenceText(const LearnedCut& cut, UnitSystem units);

}  // namespace stillcut::ui
