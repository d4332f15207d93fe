// A button among the tools of the pages on sessions: a word to touch, a sentence to hear, the name that tests and
// styles know it by. GUI thread; the layout it is put into owns it.
#pragma once

#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

inline TouchButton* toolButton(const QString& caption, const QString& spoken, const char* name) {
  auto* button = new TouchButton(caption);
  button->setObjectName(QLatin1String(name));
  button->setAccessibleName(spoken);
  button->setBaseHeight(48);
  return button;
}

}  // namespace stillcut::ui
