// The one manner in which commands print JSON: an object that says schema and command, on a line of its own or spread
// over several. Fields: resources/manual/scripts.md.
// Thread: main.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace stillcut::app {

// What every object begins with.
nlohmann::json jsonObject(std::string_view command, std::string_view type);
// Whole and at once, so that whoever reads along has it. Bytes that are no UTF-8, as in a file's name, are replaced.
void printJsonLine(const nlohmann::json& object);
// Indented, for an object that is the only one.
void printJson(const nlohmann::json& object);
// Null where it is not known or not finite.
nlohmann::json orNull(double value, bool known = true);

}  // namespace stillcut::app
