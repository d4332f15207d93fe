#include "core/base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace stillcut {
namespace {

TEST(Error, IsOneLineAndLeavesOutWhatIsUnknown) {
  EXPECT_EQ((Error{message("cut.csv:12"), message("column 'Fx' holds 'nan'"), message("a sensor was off")}).line(),
            "cut.csv:12: column 'Fx' holds 'nan' (a sensor was off)");
  EXPECT_EQ((Error{message("cut.csv"), message("is empty")}).line(), "cut.csv: is empty");
  EXPECT_EQ((Error{{}, message("no device")}).line(), "no device");
}

TEST(Result, HoldsAValueOrAnError) {
  const Result<int> good(4);
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(*good, 4);
  const Result<int> bad(Error{message("x"), message("y")});
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().line(), "x: y");
}

TEST(Result, MovesOutWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> made(std::make_unique<int>(7));
  ASSERT_TRUE(made.ok());
  const std::unique_ptr<int> taken = std::move(made).value();
  EXPECT_EQ(*taken, 7);
}

TEST(Result, AStatusIsDoneOrAnError) {
  EXPECT_TRUE(Status(Done{}).ok());
  EXPECT_FALSE(Status(Error{message("a"), message("b"), message("c")}).ok());
}

}  // namespace
}  // namespace stillcut
