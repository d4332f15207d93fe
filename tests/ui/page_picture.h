// Pictures of a page in every look, for people to see; and what a machine can say of them: that buttons and labels are
// whole, and that targets are large enough for a glove.
#pragma once

#include <QAbstractButton>
#include <QDir>
#include <algorithm>
#include <array>
#include <ostream>
#include <string>

#include "tests/ui/ui_fixture.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"

namespace stillcut::ui {

struct PageLook {
  const char* name;
  ThemeKind theme;
  int width, height;
};

inline void PrintTo(const PageLook& look, std::ostream* out) {
  *out << look.name;
}

inline constexpr std::array<PageLook, 4> kPageLooks{{{"light-1280", ThemeKind::Light, 1280, 800},
                                                     {"dark-1280", ThemeKind::Dark, 1280, 800},
                                                     {"light-1920", ThemeKind::Light, 1920, 1080},
                                                     {"dark-1920", ThemeKind::Dark, 1920, 1080}}};

inline std::string lookName(const testing::TestParamInfo<PageLook>& look) {
  std::string name = look.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

inline void expectWholePage(const QWidget& window) {
  const int least = pixelsFor(kTouchMm, &window);
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
    if (!button->isVisible() || button->objectName().startsWith(QStringLiteral("qt_"))) continue;
    const std::string name = button->accessibleName().toStdString() + " / " + button->objectName().toStdString();
    EXPECT_FALSE(button->accessibleName().isEmpty()) << name;
    EXPECT_GE(button->width(), least) << name;
    EXPECT_GE(button->height(), least) << name;
    if (const auto* touch = qobject_cast<const TouchButton*>(button)) {
      EXPECT_FALSE(touch->clipped()) << name;
    }
  }
  for (const TextLabel* label : window.findChildren<TextLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
    EXPECT_GE(label->height() + 1, needed) << label->text().toStdString();
    const int wide = label->wordWrap() ? 0 : label->sizeHint().width();
    EXPECT_GE(label->width() + 1, wide) << label->text().toStdString();
  }
}

inline void savePage(MainWindow& window, const char* page, const PageLook& look, const char* state) {
  QCoreApplication::processEvents();
  const QDir folder(QStringLiteral(STILLCUT_SCREENSHOT_DIR));
  ASSERT_TRUE(folder.mkpath(QStringLiteral(".")));
  const QImage image = window.grab().toImage();
  EXPECT_EQ(image.size(), QSize(look.width, look.height)) << "the page forces the window to grow";
  EXPECT_TRUE(image.save(folder.filePath(
      QStringLiteral("%1-%2-%3.png").arg(QLatin1String(page), QLatin1String(look.name), QLatin1String(state)))));
  expectWholePage(window);
}

}  // namespace stillcut::ui
