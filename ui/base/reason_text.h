// A reason as a sentence in the reader's language, with numbers as the screens write them. GUI thread.
#pragma once

#include <QString>

#include "core/model/reason.h"

namespace stillcut::ui {

// Begins with a capital, no full stop; empty for ReasonCode::None. Translated by the English pattern, context "Reason".
QString reasonText(const Reason& reason);
// The same as a part of another sentence: it begins as its language has it.
QString reasonWords(const Reason& reason);

// An alarm that has not become chatter, by the state it has: ReasonCode::ChatterBegan, and where it has not.
QString onsetText(const Reason& reason);

}  // namespace stillcut::ui
