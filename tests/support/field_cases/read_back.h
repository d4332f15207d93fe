// What was read from a written file against the signal in it.
// Thread: one.
#pragma once

#include <string>

#include "core/formats/recording_reader.h"
#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

// Reads to the end. Where the file was misread, in words; empty: the rate is right, as many channels as `signal` has
// follow it (offset and scale aside), and any other channel is constant.
std::string misreading(record::RecordingReader& reader, const Signal& signal);

}  // namespace stillcut::field
