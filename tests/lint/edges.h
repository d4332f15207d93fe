// Reads includes and link lines of the tree and says where they leave the table of rooms.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/lint/room_table.h"

namespace stillcut::lint {

struct SourceFile {
  std::string path;  // from the top of the tree
  std::string text;
};

// Every .h, .cpp and CMakeLists.txt below core, ui and app.
std::vector<SourceFile> readTree(const std::filesystem::path& top);

// Each gives one line per offence, "file:line: what".
// Includes across rooms that the table does not allow, Qt in core, files outside any room.
std::vector<std::string> forbiddenIncludes(const std::vector<SourceFile>& files, const std::vector<Room>& table);
// Includes between folders inside a room that are to know nothing of each other (kSeparate), in every room named there.
std::vector<std::string> crossings(const std::vector<SourceFile>& files, const std::vector<Separate>& separate);
// Link lines (stillcut_room ... LINKS) that the table does not allow, and rooms that include what they do not link.
std::vector<std::string> wrongLinks(const std::vector<SourceFile>& files, const std::vector<Room>& table);
// Rooms of the table that include something not above them: without these there is no cycle.
std::vector<std::string> tableFaults(const std::vector<Room>& table);

}  // namespace stillcut::lint
