// What paints itself takes the theme from above; nobody looks one up. GUI thread.
#pragma once

#include "ui/base/theme.h"

namespace stillcut::ui {

class Themed {
 public:
  virtual ~Themed() = default;
  virtual void applyTheme(const Theme& theme) = 0;
  // Whether the last painting had to cut text off.
  virtual bool clipped() const { return false; }
};

}  // namespace stillcut::ui
