// What core refuses and why, on a German and a Chinese screen: forms in the reader's language, what is echoed as it is;
// and real refusals of real files leave no English behind.
#include "ui/base/say.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QTemporaryDir>
#include <fstream>
#include <sstream>

#include "core/config/profile.h"
#include "core/milling/simulation/scenario.h"
#include "core/pipeline/catalog.h"
#include "core/session/open_recording.h"
#include "ui/shell/language.h"

namespace stillcut::ui {
namespace {

class CoreSentences : public testing::TestWithParam<Language> {
 protected:
  Speaker speaker_{GetParam()};
};

// Forms are translated, and so are arguments that are messages; what is echoed stays as it is.
TEST_P(CoreSentences, TranslateFormsAndNeverWhatIsEchoed) {
  const Message nested = message("did you mean '%1'?", "source");
  const QString said = sayCore(nested);
  EXPECT_TRUE(said.contains(QStringLiteral("source"))) << said.toStdString();
  EXPECT_NE(said, QString::fromStdString(text(nested)));
  EXPECT_EQ(sayError({"stop.toml:3", nested, nested}), QStringLiteral("stop.toml:3: %1 (%1)").arg(said));
  EXPECT_EQ(sayCore(message("%1 (%2)", "source", foreign("source"))),
            QStringLiteral("source (%1)").arg(sayCore(std::string("source"))));
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
        write("d.wav", "no sound"), write("e.h5", "0x2A HDF5"), folder.path().toStdString(),
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
  const Error error{"/data/cut.csv:12", message("column %1 holds %2", "'Fx'", "'nan'"),
                    message("a finite number was expected")};
  EXPECT_EQ(sayError(error).toStdString(),
            "/data/cut.csv:12: Spalte 'Fx' enthält 'nan' (eine endliche Zahl wurde erwartet)");
}

// A key that the format knows by its English name alone is not asked for in German.
TEST(CoreSentence, AsksForAKeyAsTheFormatSpellsIt) {
  const Speaker speaker(Language::German);
  std::stringstream shipped;
  shipped << std::ifstream(STILLCUT_SOURCE_DIR "/resources/profiles/simulated.toml").rdbuf();
  const std::string slip = shipped.str() + "\n[sourse]\nid = \"simulated\"\n";
  const auto profile = config::parseProfile(slip, "profile.toml", pipeline::fullCatalog());
  ASSERT_FALSE(profile.ok());
  const std::string said = sayError(profile.error()).toStdString();
  EXPECT_THAT(said, testing::HasSubstr("sourse"));
  EXPECT_THAT(said, testing::HasSubstr("source"));
  EXPECT_THAT(said, testing::Not(testing::HasSubstr("Quelle")));
}

}  // namespace
}  // namespace stillcut::ui
