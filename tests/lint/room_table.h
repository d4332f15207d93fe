// The architecture as a table: which room may include which. A new edge is a new word here, seen in review.
#pragma once

#include <string_view>
#include <vector>

namespace stillcut::lint {

struct Room {
  std::string_view folder;
  std::vector<std::string_view> mayInclude;  // besides itself; "core/*" means every room of core
};

// Lowest first: a room includes only rooms above it in this list. A folder inside a room that is not listed by itself
// (core/detect/liao, core/formats/text) belongs to that room; those of kSeparate know nothing of each other.
inline const std::vector<Room>& roomTable() {
  static const std::vector<Room> kRooms{
      {"core/base", {}},
      {"core/rt", {"core/base"}},
      {"core/model", {"core/base"}},
      {"core/storage", {"core/base"}},
      {"core/units", {"core/base", "core/model"}},
      {"core/config", {"core/base", "core/model", "core/storage", "core/units"}},
      {"core/dsp", {"core/base", "core/model"}},
      {"core/formats", {"core/base", "core/model", "core/config", "core/storage", "core/units"}},
      {"core/milling", {"core/base", "core/model", "core/config"}},
      {"core/milling/stability", {"core/base", "core/model", "core/config", "core/storage", "core/milling"}},
      {"core/milling/identify",
       {"core/base", "core/model", "core/config", "core/storage", "core/units", "core/formats", "core/milling"}},
      {"core/milling/coupling", {"core/base", "core/model", "core/milling", "core/milling/identify"}},
      {"core/milling/simulation",
       {"core/base", "core/rt", "core/model", "core/config", "core/storage", "core/dsp", "core/milling"}},
      {"core/learn",
       {"core/base", "core/model", "core/config", "core/storage", "core/milling", "core/milling/stability"}},
      {"core/spindle", {"core/base", "core/model", "core/config", "core/dsp"}},
      {"core/sensing", {"core/base", "core/model", "core/config", "core/dsp", "core/spindle"}},
      {"core/detect", {"core/base", "core/model", "core/config", "core/dsp", "core/spindle", "core/sensing"}},
      {"core/control",
       {"core/base", "core/model", "core/config", "core/units", "core/milling", "core/milling/stability"}},
      {"core/safety", {"core/base", "core/rt", "core/model", "core/config"}},
      {"core/active",
       {"core/base", "core/rt", "core/model", "core/config", "core/dsp", "core/milling", "core/milling/simulation",
        "core/safety"}},
      {"core/session", {"core/base", "core/rt", "core/model", "core/config", "core/storage", "core/formats"}},
      {"core/daq",
       {"core/base", "core/rt", "core/model", "core/config", "core/dsp", "core/units", "core/formats", "core/session",
        "core/milling", "core/milling/simulation"}},
      {"core/cnc",
       {"core/base", "core/rt", "core/model", "core/config", "core/units", "core/milling", "core/milling/simulation"}},
      {"core/pipeline",
       {"core/base", "core/rt", "core/model", "core/config", "core/dsp", "core/sensing", "core/detect", "core/control",
        "core/active", "core/safety", "core/session", "core/daq", "core/cnc"}},
      {"core/evaluate", {"core/*"}},
      {"ui/base", {"core/base", "core/model", "core/config"}},
      {"ui/facade", {"core/base", "core/model", "core/config", "ui/base"}},
      {"ui/models", {"core/base", "core/model", "core/config", "ui/base", "ui/facade"}},
      {"ui/plots", {"core/base", "core/model", "core/config", "ui/base", "ui/facade", "ui/models"}},
      {"ui/widgets", {"core/base", "core/model", "core/config", "ui/base", "ui/facade", "ui/models"}},
      {"ui/pages",
       {"core/base", "core/model", "core/config", "ui/base", "ui/facade", "ui/models", "ui/plots", "ui/widgets"}},
      {"ui/report", {"core/base", "core/model", "core/config", "ui/base", "ui/facade", "ui/models", "ui/plots"}},
      {"ui/shell",
       {"core/base", "core/model", "core/config", "ui/base", "ui/facade", "ui/models", "ui/plots", "ui/widgets",
        "ui/pages", "ui/report"}},
      {"app/io", {"core/*"}},
      {"app/hal", {"core/base", "core/cnc"}},
      {"app/keeper", {"core/*", "app/io"}},
      {"app/reader", {"core/session"}},
      {"app/shop", {"core/base", "core/model", "core/storage", "core/session"}},
      {"app/embed", {"core/*"}},
      {"app/python", {"core/*", "app/embed"}},
      {"app/vamp", {"core/*", "app/embed"}},
      {"app/compose", {"core/*", "app/io"}},
      {"app/log", {"core/*", "app/compose"}},
      {"app/cli", {"core/*", "app/compose", "app/io", "app/log"}},
      {"app/session", {"core/*", "ui/base", "ui/facade", "ui/models", "ui/shell", "app/compose", "app/io", "app/log"}},
      {"app/desktop",
       {"core/*", "ui/base", "ui/facade", "ui/models", "ui/pages", "ui/report", "ui/shell", "app/compose", "app/io",
        "app/log", "app/session"}},
  };
  return kRooms;
}

// Rooms whose inner folders must not include each other: a method a folder, a format a folder, a machine a folder.
// growth is what the methods share.
struct Separate {
  std::string_view room;
  std::vector<std::string_view> shared;  // inner folders that all may include
};
inline const std::vector<Separate>& separateFolders() {
  static const std::vector<Separate> kSeparate{
      {"core/detect", {"core/detect/growth"}}, {"core/formats", {}}, {"core/cnc", {}}};
  return kSeparate;
}

}  // namespace stillcut::lint
