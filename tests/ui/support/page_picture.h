// Pictures of a page in every look, for people to see; and what a machine can say of them: that buttons and labels are
// whole, and that targets are large enough for a glove.
#pragma once

#include <QAbstractButton>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QListView>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>
#include <array>
#include <ostream>
#include <string>

#include "tests/ui/support/ui_fixture.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/wrapped_list.h"

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

inline constexpr int kDensePixels = 52;  // of 12 mm at 110 dpi

inline void expectWholeRows(const QWidget& window) {
  for (const QListView* list : window.findChildren<QListView*>()) {
    if (!list->isVisible() || !list->wordWrap() || list->model() == nullptr) continue;
    for (int row = 0; row < list->model()->rowCount(); ++row) {
      const QModelIndex index = list->model()->index(row, 0);
      EXPECT_GE(list->visualRect(index).height(), wrappedHeight(*list, row)) << index.data().toString().toStdString();
    }
  }
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
  const auto typed = [](const QWidget* w) { return w->inherits("QLineEdit") || w->inherits("QComboBox"); };
  for (const QWidget* edit : window.findChildren<QWidget*>()) {
    const bool alone =
        typed(edit) && !typed(edit->parentWidget()) && !edit->parentWidget()->inherits("QAbstractSpinBox");
    if (!alone || !edit->isVisible()) continue;
    EXPECT_GE(edit->height(), least) << edit->accessibleName().toStdString();
  }
  for (const QListView* list : window.findChildren<QListView*>()) {
    if (!list->isVisible() || list->model() == nullptr || list->model()->rowCount() == 0) continue;
    EXPECT_GE(list->sizeHintForRow(0), least) << list->accessibleName().toStdString();
  }
  expectWholeRows(window);
  for (const TextLabel* label : window.findChildren<TextLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
    EXPECT_GE(label->height() + 1, needed) << label->text().toStdString();
    const int wide = label->wordWrap() ? 0 : label->sizeHint().width();
    EXPECT_GE(label->width() + 1, wide) << label->text().toStdString();
  }
}

// A text that its widget is too small for is drawn cut off, or tells it; both count.
inline void expectNothingCut(const QWidget& window, const QString& page, QSize size) {
  const std::string where = page.toStdString();
  EXPECT_LE(window.minimumSizeHint().width(), size.width()) << where;
  EXPECT_LE(window.minimumSizeHint().height(), size.height()) << where;
  for (const QScrollArea* area : window.findChildren<QScrollArea*>(QStringLiteral("scroll"))) {
    EXPECT_FALSE(area->horizontalScrollBar()->isVisible()) << where << " is too wide";
    // Buttons of 12 mm on a screen of high density make some pages higher than it is.
    const bool dense = pixelsFor(kTouchMm, &window) > kDensePixels;
    const bool mayScroll = dense && area->widget()->objectName() != QStringLiteral("operate");
    EXPECT_FALSE(area->verticalScrollBar()->isVisible() && !mayScroll) << where << " is too high";
  }
  for (const char* const name : {"off", "advise", "auto", "hold", "back"}) {
    const auto* button = window.findChild<TouchButton*>(QLatin1String(name));
    const QRect place(button->mapTo(&window, QPoint()), button->size());
    EXPECT_TRUE(window.rect().contains(place)) << where << ": " << name << " is off the screen";
  }
  expectWholeRows(window);
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    if (const auto* button = qobject_cast<const TouchButton*>(widget)) {
      EXPECT_FALSE(button->clipped()) << where << ": button " << button->text().toStdString();
    } else if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      const QSize needed = label->wordWrap() ? QSize(0, label->heightForWidth(label->width())) : label->sizeHint();
      EXPECT_GE(label->width() + 1, needed.width()) << where << ": " << label->text().toStdString();
      EXPECT_GE(label->height() + 1, needed.height()) << where << ": " << label->text().toStdString();
    } else if (const auto* painted = dynamic_cast<const Themed*>(widget)) {
      EXPECT_FALSE(painted->clipped()) << where << ": " << widget->metaObject()->className();
    }
  }
}

// Everything that takes the focus has a name for screen readers.
inline void expectNames(const QWidget& window, const QString& page) {
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    const bool reached = widget->isVisible() && (widget->focusPolicy() & Qt::TabFocus) != 0;
    const QWidget* named = widget->focusProxy() ? widget->focusProxy() : widget;
    if (!reached || qobject_cast<const QHeaderView*>(widget) || widget->objectName().startsWith("qt_")) continue;
    EXPECT_FALSE(named->accessibleName().isEmpty() && widget->parentWidget()->accessibleName().isEmpty())
        << page.toStdString() << ": " << widget->metaObject()->className() << ' ' << widget->objectName().toStdString();
  }
}

inline void savePage(MainWindow& window, const char* page, const PageLook& look, const char* state) {
  QCoreApplication::processEvents();
  const QDir folder(QStringLiteral(STILLCUT_SCREENSHOT_DIR));
  ASSERT_TRUE(folder.mkpath(QStringLiteral(".")));
  const QImage image = window.grab().toImage();
  EXPECT_EQ(image.size(), QSize(look.width, look.height)) << "the window grows";
  for (const QScrollArea* area : window.findChildren<QScrollArea*>(QStringLiteral("scroll"))) {
    EXPECT_FALSE(area->verticalScrollBar()->isVisible() || area->horizontalScrollBar()->isVisible())
        << page << ": is larger than its window";
  }
  EXPECT_TRUE(image.save(folder.filePath(
      QStringLiteral("%1-%2-%3.png").arg(QLatin1String(page), QLatin1String(look.name), QLatin1String(state)))));
  expectWholePage(window);
}

}  // namespace stillcut::ui
