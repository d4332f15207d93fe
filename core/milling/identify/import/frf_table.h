// Frequency responses in a table of numbers, whatever its columns: real and imaginary part, whole complex numbers, or
// magnitude and phase; one response or several; units from the columns, from the header or from the options.
// Pure: any thread; set-up, not real-time. Errors: one line that names the option to give.
#pragma once

#include <string>
#include <vector>

#include "core/milling/identify/import/import_options.h"
#include "core/milling/identify/import/number_table.h"
#include "core/milling/identify/import/unit_label.h"

namespace stillcut::identify {

struct ImportedFrfs {
  std::vector<Frf> frfs;  // rising in axis, at least one
  std::vector<Message> remarks;
};

Result<ImportedFrfs> frfsFromTable(const NumberTable& table, const std::string& where, const ImportOptions& options);

// Whether the table holds frequency responses rather than samples over time: by its columns and its header, and where
// both are silent by the step of the first column (below 5 ms it is time: no frequency response is that fine).
bool looksLikeFrfs(const NumberTable& table);

// Factor and quantity of values labelled `label`, after the options; known is false where nobody says.
struct SettledUnit {
  ResponseUnit unit;
  bool known = false;
  bool inverse = false;   // the values are force over response
  bool decibels = false;  // 20 log10 of the values in `unit`
};
Result<SettledUnit> settleUnit(const std::string& label, const std::string& where, const ImportOptions& options);

}  // namespace stillcut::identify
