// What `analyze` prints: every detector's figures side by side, as a table or as JSON; against the truth where a
// recording comes with one (recorded_truth.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compose/own_value_log.h"
#include "app/compose/recorded_truth.h"
#include "app/compose/verdict_log.h"
#include "core/record/recording_reader.h"

namespace stillcut::app {

struct Analysis {
  std::string recording;
  record::RecordingFormat format;
  std::vector<std::string> remarks;  // what the answer rests on that nobody has told
  std::vector<VerdictLog::Summary> detectors;
  std::optional<RecordedTruth> truth;
  std::vector<AlarmScore> scores;         // of each detector, where there is a truth
  std::vector<OwnValueLog::Entry> own{};  // what is to be told of them
};

void printTable(const Analysis& analysis);
void printJson(const Analysis& analysis);

}  // namespace stillcut::app
