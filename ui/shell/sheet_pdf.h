// A chapter of the manual on paper: the machinist's sheet, to hang beside the machine.
// Thread: GUI. Not real-time.
#pragma once

#include <QString>

#include "core/base/result.h"
#include "ui/shell/language.h"

namespace stillcut::ui {

// Writes the chapter (as chapterUrl names it) on A4, in the largest type from 14 to 8 points that puts it on one page.
// Fails, and leaves no file, where the path cannot be written, there is no such chapter, or it is longer than one page.
Status writeSheet(const QString& chapter, Language language, const QString& path);

}  // namespace stillcut::ui
