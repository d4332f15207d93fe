// What to do, in one sentence with its reason and its cost. GUI thread, pure functions.
#pragma once

#include <QString>

#include "ui/models/session_info.h"
#include "ui/models/theme.h"

namespace stillcut::ui {

struct AdviceView {
  enum class Mode { Nothing, Open, InForce };
  Mode mode = Mode::Nothing;
  QString title;   // "ADVICE", "IN FORCE", "WHAT TO DO"
  QString target;  // "8 565 rpm", or the sentence that there is nothing to do
  QString delta;   // "−235 rpm, 97 %"
  QString reason;  // why this value
  QString feed;    // "Feed follows: 1 370 mm/min"
  QString cost;    // "Costs 2.7 % time, cutting speed 323 m/min"

  bool canAnswer() const { return mode == Mode::Open; }
  QString spoken() const;
  bool operator==(const AdviceView&) const = default;
};

AdviceView makeAdviceView(const Picture& picture);

}  // namespace stillcut::ui
