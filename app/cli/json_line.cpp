#include "app/cli/json_line.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/base/json_schema.h"

namespace stillcut::app {
namespace {

void print(const nlohmann::json& object, int indent) {
  std::printf("%s\n", object.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  std::fflush(stdout);
}

}  // namespace

nlohmann::json jsonObject(std::string_view command, std::string_view type) {
  return {{"schema", kJsonSchema}, {"command", command}, {"type", type}};
}

void printJsonLine(const nlohmann::json& object) {
  print(object, -1);
}

void printJson(const nlohmann::json& object) {
  print(object, 2);
}

nlohmann::json orNull(double value, bool known) {
  return known && std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

}  // namespace stillcut::app
