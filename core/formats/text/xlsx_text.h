// A sheet of a spreadsheet (XLSX, ECMA-376) as the text of a table: cells parted by tabs, a line a row, numbers as they
// are kept, dates as "2026-11-25 08:59:59.000100".
// Thread: one; not real-time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/formats/text/text_bytes.h"

namespace stillcut::record {

bool isXlsx(const std::string& path);
// Names of its sheets of cells, in their order; never empty.
Result<std::vector<std::string>> sheetsOf(const std::string& path);
// The sheet of that name; an empty name: the first.
Result<std::unique_ptr<TextBytes>> openXlsxText(const std::string& path, const std::string& sheet = {});

}  // namespace stillcut::record
