#include "core/formats/text/xlsx_text.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/formats/text/xml_scan.h"
#include "core/formats/zip_listing.h"

namespace stillcut::record {
namespace {

constexpr std::size_t kMostStrings = 2'000'000, kMostStringBytes = std::size_t{64} << 20U;
constexpr int kMostColumns = 1024;
constexpr std::size_t kMostSheets = 1000;
constexpr long kMostEmptyRows = 1000;  // one after the other; more of them part nothing

using Parts = std::map<std::string, FilePart>;

Error damaged(const std::string& path) {
  return Error{path, message("is a damaged spreadsheet"), message("save the sheet as CSV")};
}

Result<XmlScan> scanOf(const Parts& parts, const std::string& name, const std::string& path) {
  const auto part = parts.find(name);
  if (part == parts.end()) return damaged(path);
  auto stream = openPart(part->second);
  if (!stream) return stream.error();
  return XmlScan(std::move(stream).value(), part->second.size);
}

// "BC12": column 54; -1: none.
int columnOf(std::string_view reference) {
  int column = 0;
  for (const char c : reference) {
    if (c < 'A' || c > 'Z') break;
    column = 26 * column + (c - 'A' + 1);
    if (column > kMostColumns) return kMostColumns;
  }
  return column - 1;
}

int wholeOr(const std::string& text, int otherwise) {
  int value = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// What number formats show: numbers, dates, times of day or durations.
enum class Shown { Number, Date, Clock };

Shown shownBy(int format, const std::map<int, std::string>& own) {
  if ((format >= 14 && format <= 17) || format == 22) return Shown::Date;
  if ((format >= 18 && format <= 21) || (format >= 45 && format <= 47)) return Shown::Clock;
  const auto code = own.find(format);
  if (code == own.end()) return Shown::Number;
  bool quoted = false, bracket = false, date = false, clock = false;
  for (std::size_t i = 0; i < code->second.size(); ++i) {
    const char c = code->second[i];
    if (c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == '[') {
      // "[h]" counts hours; "[Red]" and "[$-409]" say how to show it.
      bracket = i + 1 < code->second.size() && std::strchr("hHmMsS", code->second[i + 1]) == nullptr;
    } else if (c == ']') {
      bracket = false;
    } else if (!quoted && !bracket) {
      date = date || std::strchr("yYdD", c) != nullptr;
      clock = clock || std::strchr("hHsS", c) != nullptr;
    }
  }
  return date ? Shown::Date : clock ? Shown::Clock : Shown::Number;
}

// A serial number of days; 60 is a day of 1900 that never was.
std::string dateText(double serial, bool from1904, Shown shown) {
  constexpr double kPerDay = 86400e6;  // [us]
  const double micro = std::round(serial * kPerDay);
  if (!(std::abs(micro) < 9e17)) return {};
  const auto all = static_cast<long long>(micro);
  const long long day = all / 86'400'000'000 - (all < 0 ? 1 : 0);
  const long long clock = all - day * 86'400'000'000;
  char text[64];
  const auto seconds = static_cast<int>(clock / 1'000'000), parts = static_cast<int>(clock % 1'000'000);
  if (shown == Shown::Clock && day == 0) {
    std::snprintf(text, sizeof text, "%02d:%02d:%02d.%06d", seconds / 3600, seconds / 60 % 60, seconds % 60, parts);
    return text;
  }
  constexpr long long k1900 = -25569, k1904 = -24107;  // [days] since 1970
  const long long since = day + (from1904 ? k1904 : k1900 + (day < 60 ? 1 : 0));
  const std::chrono::year_month_day d{std::chrono::sys_days{std::chrono::days{since}}};
  std::snprintf(text, sizeof text, "%04d-%02u-%02u %02d:%02d:%02d.%06d", static_cast<int>(d.year()),
                static_cast<unsigned>(d.month()), static_cast<unsigned>(d.day()), seconds / 3600, seconds / 60 % 60,
                seconds % 60, parts);
  return text;
}

// A cell's text on its line: what parts cells and lines becomes a blank.
std::string onOneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  return text;
}

struct Sheet {
  std::string name, part;
};

struct Workbook {
  std::vector<Sheet> sheets;
  bool from1904 = false;
  std::vector<std::string> strings;  // shared
  std::vector<Shown> styles;
};

class WorkbookReader {
 public:
  WorkbookReader(const Parts& parts, const std::string& path) : parts_(parts), path_(path) {}

  Result<std::vector<Sheet>> readSheets() {
    if (const Status s = sheets(); !s) return s.error();
    return std::move(book_.sheets);
  }

  Result<Workbook> read() {
    if (const Status s = sheets(); !s) return s.error();
    if (parts_.contains("xl/sharedStrings.xml")) {
      if (const Status s = strings(); !s) return s.error();
    }
    if (parts_.contains("xl/styles.xml")) {
      if (const Status s = styles(); !s) return s.error();
    }
    return std::move(book_);
  }

 private:
  // Those that the workbook names, by the relations it names. A sheet that is a chart has no cells.
  Status sheets() {
    auto scan = scanOf(parts_, "xl/workbook.xml", path_);
    if (!scan) return scan.error();
    std::vector<std::pair<std::string, std::string>> named;  // name, relation
    while (true) {
      const XmlScan::Kind kind = scan->next();
      if (kind == XmlScan::Kind::Damaged) return damaged(path_);
      if (kind == XmlScan::Kind::End) break;
      if (kind != XmlScan::Kind::Open) continue;
      if (scan->name() == "workbookPr") {
        const std::string says = scan->attribute("date1904");
        book_.from1904 = says == "1" || says == "true";
      }
      if (scan->name() == "sheet" && named.size() < kMostSheets)
        named.emplace_back(scan->attribute("name"), scan->attribute("id"));
    }
    auto targets = relations();
    if (!targets) return targets.error();
    for (const auto& [name, relation] : named) {
      const auto target = targets->find(relation);
      if (target != targets->end() && target->second.find("worksheets/") != std::string::npos)
        book_.sheets.push_back({name, target->second});
    }
    if (book_.sheets.empty())
      book_.sheets.push_back({named.empty() ? std::string() : named.front().first, "xl/worksheets/sheet1.xml"});
    return Done{};
  }

  // Parts by the names of their relations.
  Result<std::map<std::string, std::string>> relations() {
    std::map<std::string, std::string> targets;
    if (!parts_.contains("xl/_rels/workbook.xml.rels")) return targets;
    auto relations = scanOf(parts_, "xl/_rels/workbook.xml.rels", path_);
    if (!relations) return relations.error();
    for (XmlScan::Kind kind = relations->next(); kind != XmlScan::Kind::End; kind = relations->next()) {
      if (kind == XmlScan::Kind::Damaged) return damaged(path_);
      if (kind != XmlScan::Kind::Open) continue;
      const std::string target = relations->attribute("Target");
      targets[relations->attribute("Id")] = target.starts_with('/') ? target.substr(1) : "xl/" + target;
    }
    return targets;
  }

  Status strings() {
    auto scan = scanOf(parts_, "xl/sharedStrings.xml", path_);
    if (!scan) return scan.error();
    std::size_t bytes = 0;
    bool inText = false;
    int spoken = 0;  // depth of rPh, which says how a text is spoken
    while (true) {
      const XmlScan::Kind kind = scan->next();
      if (kind == XmlScan::Kind::Damaged) return damaged(path_);
      if (kind == XmlScan::Kind::End) return Done{};
      if (kind == XmlScan::Kind::Text) {
        if (!inText || spoken > 0 || book_.strings.empty()) continue;
        book_.strings.back() += scan->text();
        bytes += scan->text().size();
        if (bytes > kMostStringBytes) return damaged(path_);
        continue;
      }
      const bool open = kind == XmlScan::Kind::Open;
      if (open && scan->name() == "si") book_.strings.emplace_back();
      if (scan->name() == "t") inText = open;
      if (scan->name() == "rPh") spoken += open ? 1 : -1;
      if (book_.strings.size() > kMostStrings) return damaged(path_);
    }
  }

  Status styles() {
    auto scan = scanOf(parts_, "xl/styles.xml", path_);
    if (!scan) return scan.error();
    std::map<int, std::string> own;
    std::vector<int> formats;
    bool ofCells = false;
    while (true) {
      const XmlScan::Kind kind = scan->next();
      if (kind == XmlScan::Kind::Damaged) return damaged(path_);
      if (kind == XmlScan::Kind::End) break;
      if (scan->name() == "cellXfs" && kind != XmlScan::Kind::Text) ofCells = kind == XmlScan::Kind::Open;
      if (kind != XmlScan::Kind::Open) continue;
      if (scan->name() == "numFmt") own[wholeOr(scan->attribute("numFmtId"), -1)] = scan->attribute("formatCode");
      if (scan->name() == "xf" && ofCells) formats.push_back(wholeOr(scan->attribute("numFmtId"), 0));
    }
    for (const int format : formats) book_.styles.push_back(shownBy(format, own));
    return Done{};
  }

  const Parts& parts_;
  std::string path_;
  Workbook book_;
};

class SheetText final : public TextBytes {
 public:
  SheetText(XmlScan scan, Workbook book, std::string path)
      : scan_(std::move(scan)), book_(std::move(book)), path_(std::move(path)) {}

  Result<std::size_t> read(char* into, std::size_t most) override {
    while (at_ == line_.size()) {
      const auto more = nextRow();
      if (!more) return more.error();
      if (!*more) return std::size_t{0};
      at_ = 0;
    }
    const std::size_t count = std::min(most, line_.size() - at_);
    std::memcpy(into, line_.data() + at_, count);
    at_ += count;
    return count;
  }

 private:
  struct Cell {
    std::string type, text;
    int column = 0, style = -1;
  };

  Result<bool> nextRow() {
    line_.clear();
    cells_.clear();
    Cell cell;
    bool inValue = false;
    while (true) {
      const XmlScan::Kind kind = scan_.next();
      if (kind == XmlScan::Kind::Damaged) return damaged(path_);
      if (kind == XmlScan::Kind::End) return false;
      const std::string_view name = scan_.name();
      if (kind == XmlScan::Kind::Text) {
        if (inValue) cell.text += scan_.text();
      } else if (kind == XmlScan::Kind::Open) {
        if (name == "row") beginRow();
        if (name == "c") cell = begun();
        if (name == "v" || name == "t") inValue = true;
      } else if (name == "v" || name == "t") {
        inValue = false;
      } else if (name == "c") {
        put(cell);
      } else if (name == "row") {
        writeRow();
        return true;
      }
    }
  }
  // Rows that are left out are empty.
  void beginRow() {
    const long number = wholeOr(scan_.attribute("r"), static_cast<int>(row_ + 1));
    line_.append(static_cast<std::size_t>(std::clamp(number - row_ - 1, 0L, kMostEmptyRows)), '\n');
    row_ = number;
    column_ = -1;
  }
  Cell begun() {
    Cell cell;
    cell.type = scan_.attribute("t");
    cell.style = wholeOr(scan_.attribute("s"), -1);
    const int named = columnOf(scan_.attribute("r"));
    cell.column = named >= 0 ? named : column_ + 1;
    column_ = cell.column;
    return cell;
  }
  void put(const Cell& cell) {
    if (cell.column >= kMostColumns) return;
    const auto column = static_cast<std::size_t>(cell.column);
    if (cells_.size() <= column) cells_.resize(column + 1);
    cells_[column] = onOneLine(shown(cell));
  }
  std::string shown(const Cell& cell) const {
    if (cell.type == "s") {
      const int number = wholeOr(cell.text, -1);
      const bool there = number >= 0 && static_cast<std::size_t>(number) < book_.strings.size();
      return there ? book_.strings[static_cast<std::size_t>(number)] : std::string();
    }
    if (!cell.type.empty() && cell.type != "n") return cell.text;
    const bool styled = cell.style >= 0 && static_cast<std::size_t>(cell.style) < book_.styles.size();
    const Shown how = styled ? book_.styles[static_cast<std::size_t>(cell.style)] : Shown::Number;
    double serial = 0.0;
    const auto [end, problem] = std::from_chars(cell.text.data(), cell.text.data() + cell.text.size(), serial);
    if (how == Shown::Number || problem != std::errc{}) return cell.text;
    const std::string date = dateText(serial, book_.from1904, how);
    return date.empty() ? cell.text : date;
  }
  void writeRow() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (i > 0) line_ += '\t';
      line_ += cells_[i];
    }
    line_ += '\n';
  }

  XmlScan scan_;
  Workbook book_;
  std::string path_;
  std::vector<std::string> cells_;
  std::string line_;
  std::size_t at_ = 0;
  long row_ = 0;
  int column_ = -1;
};

Result<Parts> partsOf(const std::string& path) {
  const auto entries = listZip(path);
  if (!entries) return entries.error();
  Parts parts;
  for (const ZipEntry& entry : *entries) parts[entry.name] = entry.part;
  return parts;
}

}  // namespace

bool isXlsx(const std::string& path) {
  const auto entries = listZip(path);
  return entries && std::any_of(entries->begin(), entries->end(),
                                [](const ZipEntry& entry) { return entry.name == "xl/workbook.xml"; });
}

Result<std::vector<std::string>> sheetsOf(const std::string& path) {
  const auto parts = partsOf(path);
  if (!parts) return parts.error();
  const auto sheets = WorkbookReader(*parts, path).readSheets();
  if (!sheets) return sheets.error();
  std::vector<std::string> names;
  for (const Sheet& sheet : *sheets) names.push_back(sheet.name);
  return names;
}

Result<std::unique_ptr<TextBytes>> openXlsxText(const std::string& path, const std::string& sheet) {
  const auto parts = partsOf(path);
  if (!parts) return parts.error();
  auto book = WorkbookReader(*parts, path).read();
  if (!book) return book.error();
  const auto named = std::find_if(book->sheets.begin(), book->sheets.end(),
                                  [&sheet](const Sheet& s) { return sheet.empty() || s.name == sheet; });
  if (named == book->sheets.end()) return Error{path, message("has no sheet '%1'", sheet)};
  auto scan = scanOf(*parts, named->part, path);
  if (!scan) return scan.error();
  return std::unique_ptr<TextBytes>(new SheetText(std::move(scan).value(), std::move(book).value(), path));
}

}  // namespace stillcut::record
