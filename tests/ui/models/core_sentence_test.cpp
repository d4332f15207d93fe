// What core refuses and why, on a German and a Chinese screen: every sentence it can put together is found again and
// said in the reader's language, with its values; and real refusals of real files leave no English behind.
#include "ui/base/core_sentence.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <fstream>

#include "core/config/profile.h"
#include "core/milling/simulation/scenario.h"
#include "core/pipeline/catalog.h"
#include "core/session/open_recording.h"
#include "translations/core_sentences.h"
#include "ui/base/say.h"
#include "ui/shell/language.h"

namespace stillcut::ui {
namespace {

QString inLanguage(const char* english) {
  return QCoreApplication::translate("Core", english);
}

QString filled(QString form) {
  for (int place = 1; place < 10; ++place) form.replace(u'%' + QString::number(place), QString::number(7000 + place));
  return form;
}

class CoreSentences : public testing::TestWithParam<Language> {
 protected:
  Speaker speaker_{GetParam()};
};

// Continuations stand after something else; a sentence and one of more places that it fits too may share their words.
TEST_P(CoreSentences, AreFoundAgainTranslatedAndFilled) {
  for (const char* const english : kCoreSentences) {
    const QString form = QString::fromUtf8(english);
    const bool continues = QStringLiteral(",;:/ ").contains(form.front());
    const QString head = continues ? QStringLiteral("7000") : QString();
    const QString said = coreSentence((head + filled(form)).toStdString());
    EXPECT_EQ(said, head + filled(inLanguage(english))) << english;
  }
}

// A word of English that is no name, key or value.
bool english(const QString& text) {
  static const QRegularExpression kWords(QStringLiteral(
      "\\b(is|are|not|no|the|cannot|must|has|have|holds|allowed|choices|unknown|missing|with|and|of|did|you)\\b"));
  return kWords.match(text).hasMatch();
}

TEST_P(CoreSentences, OfRefusedFilesLeaveNoEnglishBehind) {
  const QTemporaryDir folder;
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  std::vector<Error> refused;
  const auto keep = [&](const auto& result) {
    ASSERT_FALSE(result.ok());
    refused.push_back(result.error());
  };
  for (const char* const profile :
       {"", "version = 99", "version = 1\nmashine = \"M\"", "version = 1\nmachine = 3",
        "version = 1\n[tool]\nteeth = 4.5", "version = 1\n[tool]\nteeth = \"four\"",
        "version = 1\n[tool]\nteeth = 4000",
        "version = 1\n[tool]\nteeth = 4\n[[channels]]\nname = \"x\"\nquantity = \"noise\"",
        "version = 1\n[tool]\nteeth = 4\n[[channels]]\nname = \"x\"\nquantity = \"sound\"\nsensitivity_mv = 0.0",
        "version = 1\n[parameters.gate]\nhold-time = -1.0", "version = 1\n[parameters.gate]\nhold-tine = 1.0"}) {
    keep(config::parseProfile(profile, "profile.toml", catalog));
  }
  keep(config::loadProfile(folder.filePath("profile.toml").toStdString(), catalog));
  keep(milling::loadScenario(folder.filePath("scenario.toml").toStdString()));
  const auto write = [&](const char* name, const char* content) {
    std::string path = folder.filePath(QString::fromUtf8(name)).toStdString();
    std::ofstream(path) << content;
    return path;
  };
  for (const std::string& path :
       {write("a.csv", ""), write("b.csv", "t,Fx\n0,1\n1,nan\n"), write("c.csv", "t,Fx\n0,1\n0,2\n"),
        write("d.wav", "no sound"), write("e.h5", "no HDF5"), folder.path().toStdString(),
        folder.filePath("none.csv").toStdString()}) {
    keep(record::openRecording(path));
  }
  for (const Error& error : refused) {
    const QString said = sayError(error);
    EXPECT_NE(said, QString::fromStdString(error.line()));
    EXPECT_FALSE(english(said)) << said.toStdString() << "\n  from: " << error.line();
  }
}

// What a parser says of a file is English; it comes after our own sentence, as a detail under the parser's name.
TEST_P(CoreSentences, WhatAParserSaysIsADetailBehindOurOwnSentence) {
  const QTemporaryDir folder;
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  std::vector<std::pair<Error, QString>> refused;
  for (const char* const broken : {"version = = 1", "[tool\nteeth = 4", "version = 1\nversion = 2"}) {
    const auto profile = config::parseProfile(broken, "profile.toml", catalog);
    ASSERT_FALSE(profile.ok()) << broken;
    refused.emplace_back(profile.error(), QStringLiteral("(toml++: "));
  }
  // Begins as HDF5 does and is nothing more.
  const std::string path = folder.filePath(QStringLiteral("cut.h5")).toStdString();
  std::ofstream(path, std::ios::binary) << "\x89HDF\r\n\x1a\n and no more of it";
  const auto recording = record::openRecording(path);
  ASSERT_FALSE(recording.ok());
  refused.emplace_back(recording.error(), QStringLiteral("HDF5: "));
  for (const auto& [error, parser] : refused) {
    const QString said = sayError(error);
    const qsizetype detail = said.indexOf(parser);
    ASSERT_GT(detail, 0) << said.toStdString();
    const QString ours = said.left(detail);
    EXPECT_NE(ours, QString::fromStdString(error.line()).left(detail)) << "said in the language of the screen";
    EXPECT_FALSE(english(ours)) << said.toStdString();
    EXPECT_GT(said.size(), detail + parser.size()) << "with what the parser found";
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, CoreSentences, testing::Values(Language::German, Language::Chinese),
                         [](const auto& language) { return languageCode(language.param).toStdString(); });

TEST(CoreSentence, KeepsTheNamesOfFilesAndThePlacesInThem) {
  const Speaker speaker(Language::German);
  const Error error{"/data/cut.csv:12", "column 'Fx' holds 'nan'", "a finite number was expected"};
  EXPECT_EQ(sayError(error).toStdString(),
            "/data/cut.csv:12: Spalte 'Fx' enthält 'nan' (eine endliche Zahl wurde erwartet)");
  EXPECT_EQ(coreSentence(error.line()), sayError(error)) << "also when it was put together before";
  EXPECT_EQ(coreSentence("x.toml: 'hold-tine' is not known (did you mean 'hold-time'?)").toStdString(),
            "x.toml: „hold-tine“ ist unbekannt (war „hold-time“ gemeint?)");
}

}  // namespace
}  // namespace stillcut::ui
