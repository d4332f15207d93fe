// When the default detector alarms on a recording, by the chain of `stillcut-cli analyze`: its blocks, the conditioner,
// no machine, every parameter at its default.
// Thread: one; not the sample path.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/detect/detector.h"
#include "core/formats/recording_reader.h"
#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

struct Interval {
  double from = 0.0, to = 0.0;  // s from the first sample
};

struct AlarmCourse {
  std::vector<Interval> alarms;
  std::string fault;  // what ended the reading or the set-up; empty: nothing did
};

// observe: each verdict with the block that it is of.
using Observe = std::function<void(const Verdict&, const detect::ConditionedBlock&)>;
AlarmCourse alarmCourse(record::RecordingReader& reader, int teeth, double speed, const Observe& observe = {});

// Where it falls short of the truth, in words; empty: it is right. Right is: no alarm before the chatter begins, in
// alarm for nine tenths of the fully developed chatter, and in no more alarms than allowed.
std::string shortfall(const AlarmTruth& truth, const AlarmCourse& course);

}  // namespace stillcut::field
