// What the levels of a spectrogram mean: a colour scale, or a ramp where height tells the level, between two numbers,
// of which the second carries the unit and its reference. GUI thread.
#pragma once

#include <QPainter>
#include <QRect>
#include <QString>

#include "ui/base/theme.h"

namespace stillcut::ui {

enum class LevelKeyKind { Colors, Ramp };

// In the middle of `row`, ending at its right edge; returns where it begins.
int drawLevelKey(QPainter& p, const QRect& row, LevelKeyKind kind, const QString& low, const QString& high,
                 const Theme& theme);

}  // namespace stillcut::ui
