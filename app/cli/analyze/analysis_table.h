// What `analyze` prints: the answer, then every detector's figures side by side, as a table or as JSON; against the
// truth where a recording comes with one (recorded_truth.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/evaluate/auto_value_log.h"
#include "core/evaluate/recorded_truth.h"
#include "core/evaluate/verdict_log.h"
#include "core/formats/recording_reader.h"
#include "core/model/recording_answer.h"

namespace stillcut::app {

struct Analysis {
  std::string recording;
  record::RecordingFormat format;
  std::vector<std::string> remarks;  // what the answer assumes because it was not given
  std::vector<evaluate::VerdictLog::Summary> detectors;
  std::vector<RecordingAnswer> answers;  // of each detector; the first is in charge
  std::optional<evaluate::RecordedTruth> truth;
  std::vector<evaluate::AlarmScore> scores;          // of each detector, where there is a truth
  std::vector<evaluate::AutoValueLog::Entry> own{};  // what is to be printed of them
};

void printTable(const Analysis& analysis);
// One object in one line.
void printAnswerLine(const Analysis& analysis);

}  // namespace stillcut::app
