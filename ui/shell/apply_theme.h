// Hands a theme to a window and to everything in it. GUI thread.
#pragma once

#include "ui/base/theme.h"

class QWidget;

namespace stillcut::ui {

// Palette, stylesheet (resources/style) and every Themed widget below `window`, itself included.
void applyTheme(QWidget& window, const Theme& theme);
// Light or dark, as the desktop is.
ThemeKind desktopTheme();

}  // namespace stillcut::ui
