#include "core/learn/evidence_lines.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace stillcut::learn {
namespace {

using nlohmann::json;

constexpr std::string_view kSchema = "stillcut-evidence/1";

// Reads fields and remembers the first that is missing or of another kind.
class Fields {
 public:
  explicit Fields(const json& object) : object_(object) {}

  double number(const char* key, double missing) {
    const auto at = object_.find(key);
    if (at == object_.end() || at->is_null()) return missing;
    if (!at->is_number()) bad_ = key;
    return at->is_number() ? at->get<double>() : missing;
  }
  double needed(const char* key) {
    if (!object_.contains(key)) bad_ = key;
    return number(key, 0.0);
  }
  std::string text(const char* key) {
    const auto at = object_.find(key);
    if (at == object_.end() || at->is_null()) return {};
    if (!at->is_string()) bad_ = key;
    return at->is_string() ? at->get<std::string>() : std::string();
  }
  void refuse(const char* key) { bad_ = key; }
  const std::string& bad() const { return bad_; }

 private:
  const json& object_;
  std::string bad_;
};

// A number of the size of a count or a time; anything else is 0, which check() refuses where it matters.
std::int64_t whole(double value) {
  return std::abs(value) < 1e15 ? static_cast<std::int64_t>(std::llround(value)) : 0;
}

CutEvidence fromFields(Fields& f) {
  CutEvidence cut;
  cut.id = f.text("id");
  cut.assembly = {f.text("machine"), f.text("tool"), f.text("holder"), Metres(1e-3 * f.number("stick_out_mm", 0.0))};
  cut.material = f.text("material");
  const double teeth = f.needed("teeth");
  cut.teeth = teeth >= 1.0 && teeth <= milling::kMostTeeth ? static_cast<int>(teeth) : 0;
  cut.diameter = Metres(1e-3 * f.needed("diameter_mm"));
  cut.speed = Rpm(f.needed("speed_rpm"));
  cut.depth = Metres(1e-3 * f.needed("depth_mm"));
  cut.engagement.radialImmersion = f.needed("immersion");
  const std::string side = f.text("side");
  if (side != "up" && side != "down" && !side.empty()) f.refuse("side");
  cut.engagement.side = side == "up" ? milling::MillingDirection::Up : milling::MillingDirection::Down;
  const double offset = f.number("offset", std::nan(""));
  if (std::isfinite(offset)) cut.engagement.offset = offset;
  const std::string outcome = f.text("outcome");
  if (outcome != "stable" && outcome != "chatter") f.refuse("outcome");
  cut.outcome = outcome == "chatter" ? CutOutcome::Chatter : CutOutcome::Stable;
  cut.doubt = f.number("doubt", cut.doubt);
  cut.frequency = Hertz(f.number("frequency_hz", 0.0));
  cut.frequencySd = Hertz(f.number("frequency_sd_hz", 0.0));
  cut.time_s = whole(f.number("time_s", 0.0));
  cut.source = f.text("source");
  return cut;
}

Result<CutEvidence> readLine(std::string_view line, const std::string& where) {
  const json object = json::parse(line, nullptr, false);
  if (!object.is_object()) return Error{where, message("is no line of evidence"), message("one JSON object a line")};
  Fields fields(object);
  if (fields.text("schema") != kSchema) {
    return Error{where, message("is no line of evidence"), message("its schema is not %1", kSchema)};
  }
  const CutEvidence cut = fromFields(fields);
  if (!fields.bad().empty()) return Error{where, message("field '%1' is missing or of the wrong kind", fields.bad())};
  if (Status ok = check(cut, where); !ok) return ok.error();
  return cut;
}

}  // namespace

std::string evidenceLine(const CutEvidence& cut) {
  json object{{"schema", std::string(kSchema)},
              {"id", cut.id},
              {"machine", cut.assembly.machine},
              {"tool", cut.assembly.tool},
              {"holder", cut.assembly.holder},
              {"stick_out_mm", 1e3 * cut.assembly.stickOut.value},
              {"material", cut.material},
              {"teeth", cut.teeth},
              {"diameter_mm", 1e3 * cut.diameter.value},
              {"speed_rpm", cut.speed.value},
              {"depth_mm", std::round(1e12 * cut.depth.value) * 1e-9},
              {"immersion", cut.engagement.radialImmersion},
              {"side", cut.engagement.side == milling::MillingDirection::Up ? "up" : "down"},
              {"outcome", std::string(name(cut.outcome))},
              {"doubt", cut.doubt},
              {"frequency_hz", cut.frequency.value},
              {"frequency_sd_hz", cut.frequencySd.value},
              {"time_s", cut.time_s},
              {"source", cut.source}};
  if (cut.engagement.offset) object["offset"] = *cut.engagement.offset;
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<std::vector<CutEvidence>> readEvidenceLines(std::string_view text, const std::string& where) {
  std::vector<CutEvidence> cuts;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    auto cut = readLine(line, where + ":" + std::to_string(number));
    if (!cut) return cut.error();
    cuts.push_back(std::move(*cut));
  }
  return cuts;
}

}  // namespace stillcut::learn
