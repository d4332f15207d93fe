// The manual beside the page: F1 opens it at the part that tells of the page on screen, F1 closes it. It lies over the
// right of the page and leaves the command bar and every key of the window where they are, so that the cut can be
// stopped while somebody reads. The chapters (resources/manual) are inside the program. GUI thread.
#pragma once

#include <QUrl>
#include <QWidget>

#include "ui/base/themed.h"
#include "ui/shell/language.h"

class QTextBrowser;

namespace stillcut::ui {

class TouchButton;

// A chapter in this language where there is one, else in English; empty: there is no such chapter.
QUrl chapterUrl(const QString& name, Language language);

class ManualPanel : public QWidget, public Themed {
  Q_OBJECT
 public:
  ManualPanel(Language language, QWidget* parent);

  // The chapter on the screens, at the part of page `number` (page_table.h).
  void openAt(int number);
  // A chapter and a heading in it, as the chapters link to each other: "hardware.md#microphone".
  void openLink(const QString& link);
  QUrl chapter() const;
  // Heading that the text begins with as it is scrolled.
  QString headingOnTop() const;

  void applyTheme(const Theme& theme) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow(const QUrl& link);
  void dress();  // what Markdown leaves undressed: links and tables in the theme's colours

  Language language_;
  Theme theme_;
  QTextBrowser* text_;
  TouchButton *contents_, *back_, *close_;
};

}  // namespace stillcut::ui
