// What paints itself takes the theme from above; nobody looks one up. GUI thread.
#pragma once

#include "ui/models/theme.h"

namespace stillcut::ui {

class Themed {
 public:
  virtual ~Themed() = default;
  virtual void applyTheme(const Theme& theme) = 0;
};

}  // namespace stillcut::ui
