// A touch button among others of a page: lower than the ones that command the machine. Thread: GUI.
#pragma once

#include <QAnyStringView>

#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

// `spoken`: what a screen reader says; `name`: what tests and style find it by. The layout it is put into owns it.
TouchButton* makeToolButton(const QString& caption, const QString& spoken, QAnyStringView name);

}  // namespace stillcut::ui
