#include "ui/pages/file/file_picture.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QPainter>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

constexpr int kMargin = 20;  // before scaling

}  // namespace

FilePictureTexts pictureTexts(const FileContents& file, const FileQuestion& asked, const FileAnswer* answer) {
  FilePictureTexts texts;
  const QFileInfo info(file.path);
  texts.title = info.fileName();
  QStringList facts;
  if (!file.job.isEmpty()) facts << file.job;
  if (!file.tool.isEmpty()) facts << file.tool;
  const int teeth = answer != nullptr && answer->teeth > 0 ? answer->teeth : asked.teeth;
  if (teeth > 0) facts << say("%1 teeth").arg(teeth);
  const double speed = asked.speed.value > 0.0 ? asked.speed.value
                       : answer != nullptr     ? 60.0 * answer->spindle.value
                                               : 0.0;
  if (speed > 0.0) facts << join(number(speed), say("rpm"));
  const QDateTime when = file.wallMs > 0 ? QDateTime::fromMSecsSinceEpoch(file.wallMs) : info.lastModified();
  facts << when.toString(QStringLiteral("yyyy-MM-dd HH:mm"));
  texts.facts = facts.join(QStringLiteral(" \u00b7 "));
  if (answer != nullptr) {
    texts.answer = answer->headline;
    texts.advice = answer->advice;
  }
  return texts;
}

QImage filePicture(const FilePictureTexts& texts, const QImage& plots, const Theme& theme) {
  const double dpr = plots.devicePixelRatio();
  const int wide = static_cast<int>(plots.width() / dpr) + 2 * theme.px(kMargin);
  const int high = static_cast<int>(plots.height() / dpr);
  struct Line {
    QString text;
    double size;
    bool bold;
  };
  const Line lines[] = {{texts.title, type_size::kValue, true},
                        {texts.facts, type_size::kBody, false},
                        {texts.answer, type_size::kButton, true},
                        {texts.advice, type_size::kBody, false}};
  const QRect room(theme.px(kMargin), 0, wide - 2 * theme.px(kMargin), 1000);
  int top = theme.px(14);
  for (const Line& line : lines) {
    if (line.text.isEmpty()) continue;
    const QFontMetrics metrics(theme.font(line.size, line.bold));
    top += metrics.boundingRect(room, Qt::TextWordWrap, line.text).height() + theme.px(4);
  }
  QImage picture(QSize(wide, top + high + 2 * theme.px(kMargin)) * dpr, QImage::Format_RGB32);
  picture.setDevicePixelRatio(dpr);
  picture.fill(theme.colors.window);
  QPainter p(&picture);
  int y = theme.px(14);
  p.setPen(theme.colors.text);
  for (const Line& line : lines) {
    if (line.text.isEmpty()) continue;
    p.setFont(theme.font(line.size, line.bold));
    QRect used;
    p.drawText(room.translated(0, y), Qt::TextWordWrap, line.text, &used);
    y = used.bottom() + theme.px(4);
  }
  p.drawImage(QPoint(theme.px(kMargin), y + theme.px(8)), plots);
  p.setFont(theme.font(type_size::kLabel));
  p.setPen(theme.colors.secondary);
  p.drawText(QRectF(0, picture.height() / dpr - theme.px(kMargin), wide - theme.px(kMargin), theme.px(kMargin)),
             Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("Stillcut"));
  return picture;
}

QString nameBeside(const QString& recording, const QString& suffix, const QString& elsewhere) {
  const QFileInfo file(recording);
  const QDir dir(QFileInfo(file.path()).isWritable() ? file.path() : elsewhere);
  QString name = dir.filePath(file.completeBaseName() + suffix);
  for (int k = 2; QFileInfo::exists(name); ++k)
    name = dir.filePath(QStringLiteral("%1-%2%3").arg(file.completeBaseName()).arg(k).arg(suffix));
  return name;
}

}  // namespace stillcut::ui
