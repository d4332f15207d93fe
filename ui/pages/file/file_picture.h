// The picture of a recording, to be sent to somebody: the plots as they are on the screen, under the name of the file,
// the tool, the speed, the date and the answer. GUI thread.
#pragma once

#include <QImage>
#include <QString>

#include "ui/base/theme.h"
#include "ui/facade/file_controller.h"

namespace stillcut::ui {

struct FilePictureTexts {
  QString title, facts, answer, advice;
};
FilePictureTexts pictureTexts(const FileContents& file, const FileQuestion& asked, const FileAnswer* answer);
QImage filePicture(const FilePictureTexts& texts, const QImage& plots, const Theme& theme);
// The recording's name with this suffix, beside it, or in `elsewhere` where nothing may be written there; never a file
// that is there.
QString nameBeside(const QString& recording, const QString& suffix, const QString& elsewhere);

}  // namespace stillcut::ui
