// A history of the features of a session, as the recorder would have kept it during the cut.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/session/open_recording.h"
#include "core/session/step_sink.h"

namespace stillcut::test {

inline void keepFeatures(const std::string& whole, const std::string& path, Seconds interval) {
  const auto reader = record::openRecording(whole);
  ASSERT_TRUE(reader.ok());
  const record::RecordingFormat& format = (*reader)->format();
  record::RecordPlan plan;
  plan.interval = interval;
  record::SessionHeader header;
  header.setup = *format.setup;
  header.configuration = format.configuration;
  const auto sink = record::features(header, plan, [&]() -> Result<std::string> { return path; }, {});
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), format.blockFrames);
  while (*(*reader)->read(block)) {
    const StepRecord* step = (*reader)->recordedStep();
    ASSERT_TRUE(sink->add(step->input, step->output).ok());
  }
  ASSERT_TRUE(sink->close().ok());
}

}  // namespace stillcut::test
