#include "core/formats/universal/uff58.h"

#include "core/formats/universal/uff58_cursor.h"
#include "core/units/number_scan.h"

namespace stillcut::uff {

Result<std::vector<Uff58Dataset>> parseUff58(std::string_view bytes, const std::string& where) {
  Uff58Cursor cursor(ByteWindow(bytes), where);
  std::vector<Uff58Dataset> found;
  std::array<Uff58Point, 256> points;
  while (true) {
    const Result<bool> more = cursor.next();
    if (!more) return more.error();
    if (!*more) break;
    Uff58Dataset set;
    static_cast<Uff58Header&>(set) = cursor.header();
    // The cursor has checked that so many can be there.
    set.x.reserve(static_cast<std::size_t>(set.points));
    set.y.reserve(static_cast<std::size_t>(set.points));
    for (;;) {
      const Result<std::size_t> got = cursor.read(points);
      if (!got) return got.error();
      if (*got == 0) break;
      for (std::size_t i = 0; i < *got; ++i) {
        set.x.push_back(points[i].x);
        set.y.push_back(points[i].y);
      }
    }
    if (const Status ended = cursor.finish(); !ended) return ended.error();
    found.push_back(std::move(set));
  }
  if (found.empty())
    return Error{where, message("holds no dataset 58"), message("not a universal file of measured functions")};
  return found;
}

bool looksLikeUff(std::string_view bytes) {
  return trimmed(takeLine(bytes)) == "-1";
}

}  // namespace stillcut::uff
