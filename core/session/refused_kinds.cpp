#include "core/session/refused_kinds.h"

#include <array>
#include <utility>

#include "core/formats/zip_listing.h"

namespace stillcut::record {
namespace {

Message fromPython() {
  return message("write it as CSV in Python: %1", "pandas.read_parquet(FILE).to_csv('cut.csv')");
}
Message fromFeather() {
  return message("write it as CSV in Python: %1", "pandas.read_feather(FILE).to_csv('cut.csv')");
}
Message fromMdf() {
  return message("write it as CSV in Python: %1", "asammdf.MDF(FILE).export('csv')");
}
Message fromSheet() {
  return message("save the sheet as CSV");
}
Message unpack() {
  return message("unpack it, and open what is in it");
}
Message original() {
  return message("open the recording that it was made from");
}
Message besideIt() {
  return message("open the .tdms file beside it");
}

struct Kind {
  std::string_view magic;
  std::string_view format;
  Message (*wayOut)();
};

constexpr auto kKinds = std::to_array<Kind>({
    {"PAR1", "Parquet", fromPython},
    {"ARROW1", "Arrow", fromFeather},
    {"FEA1", "Feather", fromFeather},
    {"TDSh", "LabVIEW TDMS index", besideIt},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "Excel 97", fromSheet},
    {"MDF     ", "MDF", fromMdf},
    {"UnFinMF ", "MDF", fromMdf},
    {"SQLite format 3", "SQLite", fromSheet},
    {"\x1F\x8B", "gzip", unpack},
    {"7z\xBC\xAF\x27\x1C", "7-Zip", unpack},
    {"Rar!", "RAR", unpack},
    {"\x28\xB5\x2F\xFD", "Zstandard", unpack},
    {"%PDF", "PDF", original},
    {"\x89PNG", "PNG", original},
    {"\xFF\xD8\xFF", "JPEG", original},
});

Error refused(const std::string& path, std::string_view format, Message wayOut) {
  return Error{path, message("is a file of the format %1, which is not read", std::string(format)), std::move(wayOut)};
}

// What a ZIP archive is, by what is in it.
Error refusalOfZip(const std::string& path) {
  const Result<std::vector<ZipEntry>> entries = listZip(path);
  if (!entries) return entries.error();
  for (const ZipEntry& entry : *entries) {
    if (entry.name == "content.xml") return refused(path, "OpenDocument", fromSheet());
  }
  return refused(path, "ZIP", unpack());
}

}  // namespace

std::optional<Error> refusalOf(const std::string& path, std::string_view head) {
  if (head.starts_with("PK\x03\x04")) return refusalOfZip(path);
  for (const Kind& kind : kKinds) {
    if (head.starts_with(kind.magic)) return refused(path, kind.format, kind.wayOut());
  }
  return std::nullopt;
}

}  // namespace stillcut::record
