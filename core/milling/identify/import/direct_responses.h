// Which of several responses are wanted: those along an axis, direct ones before cross ones.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/axis.h"

namespace stillcut::identify {

struct OfferedResponse {
  std::string name;            // as the file calls it
  Axis along = Axis::Unknown;  // of the response
  Axis force = Axis::Unknown;  // of the force; Unknown: the file does not say
};

struct ChosenResponse {
  std::size_t offered = 0;  // index
  Axis axis = Axis::Unknown;
};

struct Choice {
  std::vector<ChosenResponse> responses;  // rising in axis, at least one
  std::vector<Message> remarks;           // what was left out
};

// Whether the force's direction, as the file has it, may be overruled by the wanted axis: in a hammer record it is that
// of a sensor which the person has turned; in a frequency response it is part of what was computed.
enum class ForceAxis { Fixed, Overruled };

// `wanted` empty: every axis there is, as long as it is certain which response belongs to it. A cross response is
// never taken for a direct one. The error names the responses and the option: `option` is what tells them apart in this
// kind of file ("--dataset", "--response").
Result<Choice> chooseResponses(const std::vector<OfferedResponse>& offered, const std::vector<Axis>& wanted,
                               const std::string& where, const std::string& option, ForceAxis force);

// The response along x or y to a force along the other: the two are equal (Maxwell), so that either will do. A response
// of which the file says nothing is taken at the caller's word.
Result<Choice> chooseCross(const std::vector<OfferedResponse>& offered, const std::string& where);

}  // namespace stillcut::identify
