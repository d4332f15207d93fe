// What stillcut-reader answers to one question about a session file. Thread: the main one of that process; waits for
// the disk, and may die of the file.
#pragma once

#include <string>

#include "core/base/result.h"

namespace stillcut::record {

// CBOR, as answer_codec.h unpacks it. `what`: see isolated_questions.cpp, which asks. `arguments`: JSON. An error of
// the file is one line; a question that is not known is one as well.
Result<std::string> answerTo(const std::string& path, const std::string& what, const std::string& arguments);

}  // namespace stillcut::record
