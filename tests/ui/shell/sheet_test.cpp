// "One sheet, printable": whatever is added to the machinist's text, it stays one page of paper in every language.
#include "ui/shell/sheet_pdf.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace stillcut::ui {
namespace {

QByteArray pdfOf(const QString& chapter, Language language, const QString& path) {
  const Status made = writeSheet(chapter, language, path);
  EXPECT_TRUE(made) << made.error().line();
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST(Sheet, TheMachinistsComesOntoOnePageInEveryLanguage) {
  const QTemporaryDir folder;
  for (const Language language : kLanguages) {
    const QString code = languageCode(language);
    const QByteArray pdf = pdfOf(QStringLiteral("machinist"), language, folder.filePath(code + QStringLiteral(".pdf")));
    EXPECT_TRUE(pdf.startsWith("%PDF-")) << code.toStdString();
    EXPECT_TRUE(pdf.contains("/Count 1\n")) << code.toStdString();
  }
}

TEST(Sheet, AChapterLongerThanAPageAndOneThatIsNotThereAreRefusedAndLeaveNoFile) {
  const QTemporaryDir folder;
  const QString lost = folder.filePath(QStringLiteral("lost.pdf"));
  const Status tooLong = writeSheet(QStringLiteral("machines"), Language::English, lost);
  ASSERT_FALSE(tooLong);
  EXPECT_NE(tooLong.error().line().find("longer than one page"), std::string::npos);
  EXPECT_FALSE(QFile::exists(lost));
  EXPECT_FALSE(writeSheet(QStringLiteral("no-such-chapter"), Language::English, lost));
  EXPECT_FALSE(QFile::exists(lost));
  EXPECT_FALSE(
      writeSheet(QStringLiteral("machinist"), Language::English, folder.filePath(QStringLiteral("no/where.pdf"))));
}

}  // namespace
}  // namespace stillcut::ui
