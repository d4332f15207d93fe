// Work beside the screen: nobody waits for what is left, and what is stopped leaves nothing behind.
#include "app/session/background_task.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <fstream>
#include <semaphore>
#include <vector>

#include "app/session/replay/stoppable_reader.h"

namespace stillcut::app {
namespace {

// Whoever asks for something else goes on at once; the work that is left ends by itself, and only then the next begins.
TEST(BackgroundTask, NobodyWaitsForWorkThatIsLeft) {
  std::binary_semaphore slowDisk{0}, begun{0};
  std::vector<int> order;
  std::atomic<bool> told{false};
  int applied = 0;
  BackgroundTask task;
  const auto work = [&](int number) {
    return [&, number](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
      if (number == 1) {
        begun.release();
        slowDisk.acquire();
      }
      told = told || progress.stopped();
      order.push_back(number);
      return BackgroundTask::Apply([&applied, number] { applied = number; });
    };
  };
  task.start(ui::TaskState::What::Reading, QStringLiteral("slow"), work(1));
  begun.acquire();
  task.start(ui::TaskState::What::Reading, QStringLiteral("never"), work(2));
  task.start(ui::TaskState::What::Reading, QStringLiteral("next"), work(3));
  EXPECT_TRUE(task.state().running);
  EXPECT_EQ(task.state().file, QStringLiteral("next"));
  EXPECT_FALSE(task.collect());
  slowDisk.release();
  EXPECT_TRUE(QTest::qWaitFor([&] { return task.collect(); }, 60000));
  EXPECT_EQ(applied, 3);
  EXPECT_EQ(order, (std::vector<int>{1, 3})) << "one after the other; what was left before it began never does";
  EXPECT_TRUE(told);
  task.start(ui::TaskState::What::Reading, QStringLiteral("slow"), work(1));
  task.leave();
  EXPECT_FALSE(task.state().running);
  slowDisk.release();
  task.cancel();
  EXPECT_EQ(applied, 3) << "its result is thrown away";
}

TEST(StoppableReader, AnExportThatIsStoppedLeavesNoFile) {
  const QTemporaryDir folder;
  const std::string cut = folder.filePath(QStringLiteral("cut.csv")).toStdString();
  {
    std::ofstream text(cut);
    text << "t,x (g)\n";
    for (int i = 0; i < 1000; ++i) text << i << "e-3," << (i % 2) << '\n';
  }
  BackgroundTask::Progress progress;
  progress.stop = true;
  const std::string file = folder.filePath(QStringLiteral("stopped.wav")).toStdString();
  const Status done = record::convertRecording(cut, file, {}, {}, openStoppable(progress));
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().line().find("stopped"), std::string::npos) << done.error().line();
  EXPECT_EQ(QDir(folder.path()).entryList({QStringLiteral("stopped*")}, QDir::Files).size(), 0);
  progress.stop = false;
  EXPECT_TRUE(record::convertRecording(cut, file, {}, {}, openStoppable(progress)).ok());
  EXPECT_EQ(progress.part.load(), 1.0);
}

}  // namespace
}  // namespace stillcut::app
