// StepSink: where the recorder's thread puts its steps: one file, a file around every event, or a history of features.
// Thread: the writing one; not real-time.
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/session/file/session_writer.h"
#include "core/session/record_params.h"
#include "core/session/session_folder.h"

namespace stillcut::record {

class StepSink {
 public:
  virtual ~StepSink() = default;
  // An error ends the recording; what was flushed is closed.
  virtual Status add(const StepInput& input, const StepOutput& output) = 0;
  // As of SessionWriter, of the file that is open; nothing to do where none is.
  virtual Status flush() = 0;
  // Ends the recording; add() may not follow.
  virtual Status close() = 0;
  // From here on a flush also reaches the disk.
  virtual void setPowerSafe() = 0;
  // The file being written, or the folder the next one will be in.
  virtual std::string path() const = 0;
  // Null: no file is open.
  virtual SessionWriter* writer() = 0;
};

std::unique_ptr<StepSink> oneFile(std::unique_ptr<SessionWriter> writer);
// Keeps the last plan.before of steps in memory. An alarm of the detector in charge, an event of level warning or
// fault, or a touch of the operator opens a file, which ends plan.after after the last of them: of an alarm, after its
// end.
std::unique_ptr<StepSink> aroundEvents(const SessionHeader& header, const RecordPlan& plan, NextPath nextPath,
                                       const SessionWriterOptions& options);
// Steps without their samples: one in plan.interval, every one with an event, a command, an input, another state or
// another validity, and the last; a new file every hour.
std::unique_ptr<StepSink> features(const SessionHeader& header, const RecordPlan& plan, NextPath nextPath,
                                   const SessionWriterOptions& options);

}  // namespace stillcut::record
