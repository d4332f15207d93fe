#include "core/model/reason.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <string>

namespace stillcut {
namespace {

// How many codes the header declares; counted there, so that a code without its row cannot be forgotten here.
int declaredCodes() {
  std::ifstream header(STILLCUT_SOURCE_DIR "/core/model/reason.h");
  const std::regex enumerator(R"(^  [A-Z][A-Za-z0-9]*,.*)");
  int count = 0;
  bool inside = false;
  for (std::string line; std::getline(header, line);) {
    if (line.find("enum class ReasonCode") != std::string::npos) inside = true;
    if (line == "};") inside = false;
    if (inside && std::regex_match(line, enumerator)) ++count;
  }
  return count;
}

Reason reason(ReasonCode code, std::array<double, 4> n = {}) {
  return Reason{code, n};
}

TEST(Reason, EveryCodeHasItsOwnRow) {
  const int codes = declaredCodes();
  ASSERT_GT(codes, 40);
  std::set<std::string_view> seen;
  for (int i = 0; i < codes; ++i) {
    const auto code = static_cast<ReasonCode>(i);
    const std::string_view id = identifier(code);
    EXPECT_TRUE(seen.insert(id).second) << "code " << i << " has no row, or shares '" << id << "'";
    EXPECT_EQ(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos) << id;
    if (code == ReasonCode::None) continue;
    const std::string text = sentence(reason(code, {1.0, 2.0, 3.0, 4.0}));
    EXPECT_FALSE(text.empty()) << id;
    EXPECT_EQ(text.find_first_of("{}\n"), std::string::npos) << id << ": " << text;
    EXPECT_NE(text.back(), '.') << id;
  }
}

TEST(Reason, ACodeFromANewerVersionIsNoneAndNoCrash) {
  EXPECT_EQ(identifier(static_cast<ReasonCode>(60000)), identifier(ReasonCode::None));
  EXPECT_EQ(sentence(reason(static_cast<ReasonCode>(60000))), "");
}

TEST(Reason, NumbersStandWhereTheirSentencePutsThemWithTheirDigits) {
  EXPECT_EQ(sentence(reason(ReasonCode::EnergyRatioHigh, {0.6249, 0.2})), "energy ratio 0.62 is over 0.20");
  EXPECT_EQ(sentence(reason(ReasonCode::AuthorityChanged, {2.0, 1.0})), "authority changed from auto to advise");
  EXPECT_EQ(sentence(reason(ReasonCode::CentreOfNextPocket, {8565.4, 3.0, 1713.0, 8800.0})),
            "8565 rpm puts 3 chatter waves of 1713 Hz between two teeth, from 8800 rpm");
  EXPECT_EQ(sentence(reason(ReasonCode::Monitoring)), "monitoring only");
}

TEST(Reason, NonFiniteNumbersStillMakeASentence) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string text = sentence(reason(ReasonCode::GateStaleMachine, {nan, 0.0, 0.0, 0.0}));
  EXPECT_NE(text.find("nan"), std::string::npos);
  EXPECT_FALSE(sentence(reason(ReasonCode::GateStaleMachine, {1e300, 0.0, 0.0, 0.0})).empty());
}

}  // namespace
}  // namespace stillcut
