#include "core/config/component_settings.h"

#include <gtest/gtest.h>

namespace stillcut::config {
namespace {

using Map = std::map<std::string, std::string>;

TEST(ComponentSettings, GivesWhatIsThereAndTheFallbackElse) {
  const Map given{{"host", "mill3"}, {"port", "5007"}, {"inches", "true"}, {"parity", "even"}};
  ComponentSettings s(given, "link 'x'");
  EXPECT_EQ(s.text("host", "localhost"), "mill3");
  EXPECT_EQ(s.whole("port", 1, 1, 65535), 5007);
  EXPECT_TRUE(s.flag("inches", false));
  EXPECT_EQ(s.choice("parity", 0, {"none", "even", "odd"}), 1u);
  EXPECT_EQ(s.number("scale", 2.5, 0.0, 10.0), 2.5);
  EXPECT_TRUE(s.finish().ok());
}

TEST(ComponentSettings, EachFaultIsOneLineWithKeyAndRemedy) {
  struct Case {
    Map given;
    const char* line;
  };
  for (const Case& c : {Case{{{"port", "70000"}}, "link 'x': 'port' is '70000' (must be a number from 1 to 65535)"},
                        Case{{{"port", "12.5"}}, "link 'x': 'port' is '12.5' (must be a whole number)"},
                        Case{{{"port", "nan"}}, "link 'x': 'port' is 'nan' (must be a number from 1 to 65535)"},
                        Case{{{"inches", "yes"}}, "link 'x': 'inches' is 'yes' (must be true or false)"},
                        Case{{{"parity", "mark"}}, "link 'x': 'parity' is 'mark' (one of none, even)"},
                        Case{{{"hots", "a"}}, "link 'x': 'hots' is not known (did you mean 'host'?)"}}) {
    ComponentSettings s(c.given, "link 'x'");
    s.text("host", "");
    s.whole("port", 1, 1, 65535);
    s.flag("inches", false);
    s.choice("parity", 0, {"none", "even"});
    const Status done = s.finish();
    ASSERT_FALSE(done.ok()) << c.line;
    EXPECT_EQ(done.error().line(), c.line);
  }
}

}  // namespace
}  // namespace stillcut::config
