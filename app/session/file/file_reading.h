// A recording read once from its first sample to its last: what the screen shows of it as a whole, and its samples, to
// be looked at from anywhere. Thread: any; the disk may be slow.
#pragma once

#include <memory>
#include <string>

#include "app/session/background_task.h"
#include "core/evaluate/picture/sample_store.h"
#include "core/formats/recording_reader.h"
#include "ui/facade/file_controller.h"

namespace stillcut::app {

struct FileReading {
  std::shared_ptr<const ui::FileContents> contents;
  std::shared_ptr<const evaluate::SampleStore> samples;  // SI units
};

record::ReadOptions readOptions(const ui::FileTiming& timing);
// Any recording, or a scenario. `progress` is told how far it is.
Result<FileReading> readFile(const std::string& path, const ui::FileTiming& timing, BackgroundTask::Progress& progress);
// What would have to be told of a recording that was refused, so that it can be read.
ui::FileLack lackOf(const std::string& path);

}  // namespace stillcut::app
