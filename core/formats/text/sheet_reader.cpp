#include "core/formats/text/sheet_reader.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/formats/text/text_reader.h"
#include "core/formats/text/xlsx_text.h"

namespace stillcut::record {
namespace {

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string all;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i) all += (i == 0 ? "'" : ", '") + names[i] + "'";
  return names.size() > kMost ? all + ", ..." : all;
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openSheet(const std::string& path, const std::string& place,
                                                   const ReadOptions& options) {
  const auto sheets = sheetsOf(path);
  if (!sheets) return sheets.error();
  if (!place.empty()) {
    const std::string name = place.substr(1);
    if (std::find(sheets->begin(), sheets->end(), name) == sheets->end())
      return Error{path, message("has no sheet '%1'", name), message("it has %1", listed(*sheets))};
    return TextReader::open(path + ":/" + name, options);
  }
  if (sheets->size() < 2) return TextReader::open(path, options);
  for (const std::string& name : *sheets) {
    const std::string sheet = path + ":/" + name;
    if (!TextReader::holdsTable(sheet)) continue;
    return TextReader::open(sheet, options,
                            {message("of its %1 sheets '%2' is read; FILE:/NAME reads another", sheets->size(), name)});
  }
  return Error{path, message("none of its sheets holds rows of numbers: %1", listed(*sheets)),
               message("is this a recording?")};
}

}  // namespace stillcut::record
