// The architecture as a table: which room may include which. A new edge is a new word here, seen in review.
#pragma once

#include <string_view>
#include <vector>

namespace stillcut::lint {

struct Room {
  std::string_view folder;
  std::vector<std::string_view> mayInclude;  // besides itself; "core/*" means every room of core
};

// Lowest first: a room includes only rooms above it in this list.
inline const std::vector<Room>& roomTable() {
  static const std::vector<Room> kRooms{
      {"core/base", {}},
      {"core/rt", {"core/base"}},
      {"core/model", {"core/base"}},
      {"core/config", {"core/base", "core/model"}},
      {"core/dsp", {"core/base", "core/model"}},
      {"core/record/uff", {"core/base"}},
      {"core/milling", {"core/base", "core/rt", "core/model", "core/config"}},
      {"core/milling/stability", {"core/base", "core/model", "core/config", "core/milling"}},
      {"core/milling/identify",
       {"core/base", "core/model", "core/config", "core/dsp", "core/record/uff", "core/milling"}},
      {"core/detect", {"core/base", "core/model", "core/config", "core/dsp"}},
      {"core/control", {"core/base", "core/model", "core/config", "core/milling", "core/milling/stability"}},
      {"core/safety", {"core/base", "core/rt", "core/model", "core/config"}},
      {"core/active", {"core/base", "core/rt", "core/model", "core/config", "core/dsp", "core/milling", "core/safety"}},
      {"core/record", {"core/base", "core/rt", "core/model", "core/config", "core/record/uff"}},
      {"core/daq", {"core/base", "core/rt", "core/model", "core/config", "core/dsp", "core/milling", "core/record"}},
      {"core/cnc", {"core/base", "core/rt", "core/model", "core/config", "core/milling"}},
      {"core/pipeline",
       {"core/base", "core/rt", "core/model", "core/config", "core/dsp", "core/detect", "core/control", "core/active",
        "core/safety", "core/record", "core/daq", "core/cnc"}},
      {"ui/models", {"core/base", "core/model", "core/config"}},
      {"ui/plots", {"core/base", "core/model", "core/config", "ui/models"}},
      {"ui/widgets", {"core/base", "core/model", "core/config", "ui/models"}},
      {"ui/pages", {"core/base", "core/model", "core/config", "ui/models", "ui/plots", "ui/widgets"}},
      {"ui/report", {"core/base", "core/model", "core/config", "ui/models", "ui/plots"}},
      {"ui/shell",
       {"core/base", "core/model", "core/config", "ui/models", "ui/plots", "ui/widgets", "ui/pages", "ui/report"}},
      {"app/io", {"core/*"}},
      {"app/hal", {"core/base", "core/cnc"}},
      {"app/reader", {"core/record"}},
      {"app/compose", {"core/*", "app/io"}},
      {"app/cli", {"core/*", "app/compose", "app/io"}},
      {"app/session", {"core/*", "ui/models", "ui/shell", "app/compose", "app/io"}},
      {"app/desktop",
       {"core/*", "ui/models", "ui/pages", "ui/report", "ui/shell", "app/compose", "app/io", "app/session"}},
  };
  return kRooms;
}

}  // namespace stillcut::lint
