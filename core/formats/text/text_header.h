// Names and units of a table's columns, out of the lines just above its rows.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/formats/text/text_layout.h"

namespace stillcut::record {

// Fills names and units of layout.columns, whose `empty` is known. Error: the header names more columns than the rows
// have, or fewer, so that its names would stand over the wrong numbers.
Status readTextHeader(std::span<const std::string> lines, std::size_t firstData, TextLayout& layout,
                      const std::string& where);

}  // namespace stillcut::record
