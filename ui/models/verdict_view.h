// The one verdict as a reader sees it: shape, word, colour, and the lines under it. GUI thread, pure functions.
#pragma once

#include <QString>

#include "ui/base/theme.h"
#include "ui/facade/session_info.h"
#include "ui/models/severity_trend.h"

namespace stillcut::ui {

enum class Shape { Ring, Circle, Triangle, Octagon };  // nothing to say, stable, onset, chatter

struct VerdictView {
  Shape shape = Shape::Ring;
  Tone tone = Tone::Faint;
  QString word;       // "CHATTER"
  QString caption;    // "REPLAY" above the word: it is not of the cut that runs; empty: it is
  QString frequency;  // "1 713 ±2 Hz", empty when there is none
  QString kind;       // of an alarm, in a machinist's words: "regenerative"; empty when it is not known
  QString detail;     // "growing", or the sentence why there is no verdict
  QString marked;     // time and length in chatter

  QString spoken() const;  // for screen readers
  bool operator==(const VerdictView&) const = default;
};

VerdictView makeVerdictView(const Picture& picture, Trend trend);

}  // namespace stillcut::ui
