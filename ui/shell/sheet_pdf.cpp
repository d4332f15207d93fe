#include "ui/shell/sheet_pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QFont>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextDocument>

#include "ui/shell/manual_panel.h"

namespace stillcut::ui {
namespace {

constexpr int kDotsPerInch = 300;
constexpr double kMargin_mm = 15.0;
constexpr double kLargestType = 14.0;  // points
constexpr double kSmallestType = 8.0;
constexpr double kTypeStep = 0.5;

// Whether it came onto one page.
bool fit(QTextDocument& sheet, QPdfWriter& pdf) {
  sheet.documentLayout()->setPaintDevice(&pdf);
  sheet.setDocumentMargin(0);  // the page has its own
  for (double points = kLargestType; points >= kSmallestType; points -= kTypeStep) {
    QFont type = sheet.defaultFont();
    type.setPointSizeF(points);
    sheet.setDefaultFont(type);
    sheet.setPageSize(QSizeF(pdf.width(), pdf.height()));
    if (sheet.pageCount() == 1) return true;
  }
  return false;
}

}  // namespace

Status writeSheet(const QString& chapter, Language language, const QString& path) {
  const auto refuse = [&](const QString& why) {
    return Error{path.toStdString(), message("cannot be written"), foreign(why.toStdString())};
  };
  const QUrl url = chapterUrl(chapter, language);
  QFile text(u':' + url.path());
  if (url.isEmpty() || !text.open(QIODevice::ReadOnly))
    return refuse(QStringLiteral("the manual has no '%1'").arg(chapter));
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return refuse(file.errorString());
  {
    QPdfWriter pdf(&file);
    pdf.setResolution(kDotsPerInch);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(kMargin_mm, kMargin_mm, kMargin_mm, kMargin_mm), QPageLayout::Millimeter);
    pdf.setTitle(chapter);
    pdf.setCreator(QStringLiteral("Stillcut"));
    QTextDocument sheet;
    sheet.setMarkdown(QString::fromUtf8(text.readAll()));
    if (!fit(sheet, pdf)) return refuse(QStringLiteral("'%1' is longer than one page").arg(chapter));
    QPainter painter;
    if (!painter.begin(&pdf)) return refuse(file.errorString());
    sheet.drawContents(&painter);
  }
  if (!file.commit()) return refuse(file.errorString());
  return Done{};
}

}  // namespace stillcut::ui
