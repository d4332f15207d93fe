// Evidence as text, one JSON object a line: what stores export, import and merge, and what people may write by hand.
// Fields: resources/manual/learning.md. Thread: any.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/learn/cut_evidence.h"

namespace stillcut::learn {

// One line without its end.
std::string evidenceLine(const CutEvidence& cut);

// Every line that is not empty. The first bad one ends it, named by its number; fields that are not known are passed
// over, as a newer version may have written them.
Result<std::vector<CutEvidence>> readEvidenceLines(std::string_view text, const std::string& where);

}  // namespace stillcut::learn
