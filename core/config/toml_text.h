// Where the keys, values and tables of a TOML text stand, byte by byte, so that it can be changed without losing what
// else is written in it. For texts that TomlReader has read without an error; anything else gives some answer.
// Thread: set-up and the settings pages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stillcut::config {

// Keys from the root on; an element of an array of tables is the array's key and its number ("channels", "0").
using TomlPath = std::vector<std::string>;

struct TomlSpot {
  enum class What { Header, Entry } what = What::Entry;
  TomlPath path;
  bool element = false;                          // Header: [[path]]
  std::size_t lineBegin = 0;                     // of the line it begins in
  std::size_t keyEnd = 0;                        // Entry: where the last key of its dotted name begins
  std::size_t valueBegin = 0;                    // Entry; a Header has begin and end of its brackets here
  std::size_t valueEnd = 0;                      // behind its last byte
  std::size_t comment = std::string_view::npos;  // behind it on the same line
  std::size_t lineEnd = 0;                       // behind the line's end
};

// In the order of the text. What an inline table or an array holds is part of its entry's value.
std::vector<TomlSpot> tomlSpots(std::string_view text);

}  // namespace stillcut::config
