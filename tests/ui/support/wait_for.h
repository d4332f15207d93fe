// Waits for what a desk works on beside the screen.
#pragma once

#include <gtest/gtest.h>

#include <QTest>
#include <functional>

namespace stillcut::test {

template <class Desk>
void waitFor(Desk& controller, const std::function<bool()>& done) {
  constexpr int kLongest_ms = 60'000;
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        controller.poll();
        return done();
      },
      kLongest_ms));
}

}  // namespace stillcut::test
