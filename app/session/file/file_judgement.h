// What is said about a recording, by the very code that `stillcut-cli analyze` runs, and where each detector said it.
// Thread: any; as fast as the detectors are.
#pragma once

#include <string>
#include <vector>

#include "app/session/background_task.h"
#include "core/evaluate/answer_text.h"
#include "core/formats/recording_reader.h"
#include "core/model/recording_answer.h"
#include "core/model/session_summary.h"
#include "ui/facade/file_controller.h"

namespace stillcut::app {

struct FileJudgement {
  std::vector<RecordingAnswer> answers;  // of each detector that was asked
  std::vector<ui::FileTrack> tracks;
  int teeth = 0;  // that it was judged with
  Rpm speed{};    // in the signal, or as told; 0: unknown
};

// The detector that answers when nobody names one, or all the others.
enum class FileDetectors { Default, Others };
struct FileAsked {
  record::ReadOptions read;  // with which the recording is opened
  ui::FileQuestion question;
  FileDetectors detectors = FileDetectors::Default;
};
Result<FileJudgement> judgeFile(const std::string& path, const FileAsked& asked, BackgroundTask::Progress& progress);

// Numbers and reasons as the screens write them.
evaluate::AnswerWriting screenWriting();
// The finding first, then what to do, then what that rests on.
SummaryAnswer sentencesOf(const FileJudgement& judgement);
ui::FileAnswer inWords(const ui::FileQuestion& question, const FileJudgement& judgement);

}  // namespace stillcut::app
