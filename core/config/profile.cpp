#include "core/config/profile.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>
#include <optional>

#include "core/config/nearest_word.h"
#include "core/config/quantity_toml.h"
#include "core/config/toml_edit.h"
#include "core/config/toml_reader.h"
#include "core/config/toml_writer.h"
#include "core/storage/atomic_file.h"

namespace stillcut::config {
namespace {

constexpr int kMostTeeth = 64;
constexpr double kLargestDiameterMm = 1000.0;
constexpr double kHighestSpeedRpm = 200000.0;
constexpr double kHighestFeedMmMin = 200000.0;
constexpr double kDeepestMm = 1000.0;
constexpr double kLongestStickOutMm = 2000.0;

std::string idFrom(const TomlTable& table, std::string_view key, std::string_view fallback,
                   const std::vector<std::string_view>& known) {
  std::string id = table.textOr(key, fallback);
  if (known.empty() || id.empty() || !table.has(key)) return id;
  for (std::string_view k : known) {
    if (k == id) return id;
  }
  Message why = didYouMean(id, known);
  if (why.empty()) {
    std::string choices;
    for (std::string_view k : known) choices += (choices.empty() ? "" : ", ") + std::string(k);
    why = message("choices: %1", choices);
  }
  table.refuse(key, message("is unknown: '%1'", id), why);
  return id;
}

ComponentChoice partFrom(const TomlTable& table, const std::vector<std::string_view>& known) {
  ComponentChoice part;
  part.id = idFrom(table, "id", "", known);
  const TomlTable settings = table.tableOr("settings");
  for (const std::string& key : settings.keys()) part.settings[key] = settings.scalarText(key);
  return part;
}

// Either the scale itself, or what the data sheets of sensor and input say.
void readScale(const TomlTable& table, ChannelInfo& channel) {
  if (!table.has("sensitivity_mv")) {
    channel.scale = table.numberOr("scale", 1.0);
    if (channel.scale == 0.0) table.refuse("scale", message("is zero"), message("SI units per device unit"));
    return;
  }
  channel.sensitivity = table.numberOr("sensitivity_mv", 1.0);
  channel.volts = table.numberOr("volts", 1.0);
  if (table.has("scale"))
    table.refuse("scale", message("is given beside sensitivity_mv"), message("one of them says it all"));
  if (channel.sensitivity == 0.0)
    table.refuse("sensitivity_mv", message("is zero"), message("mV per g, Pa, N ... of the data sheet"));
  if (channel.volts == 0.0)
    table.refuse("volts", message("is zero"), message("volts of one device unit, for example of full scale"));
  if (channel.sensitivity != 0.0) channel.scale = scaleOf(channel.quantity, channel.sensitivity, channel.volts);
}

ChannelInfo channelFrom(const TomlTable& table) {
  ChannelInfo channel;
  channel.name = table.text("name");
  channel.quantity = readQuantity(table);
  readScale(table, channel);
  channel.axis = table.textOr("axis", "");
  channel.coupling = table.textOr("coupling", "");
  const std::string& coupling = channel.coupling;
  if (!coupling.empty() && coupling != "iepe" && coupling != "ac" && coupling != "dc") {
    table.refuse("coupling", message("is unknown: '%1'", coupling), message("choices: iepe, ac, dc"));
  }
  channel.place = table.textOr("place", "");
  return channel;
}

CutSetup cutFrom(const TomlTable& root) {
  CutSetup cut;
  cut.machine = root.text("machine");
  const TomlTable tool = root.tableOr("tool");
  cut.tool = tool.textOr("label", "");
  cut.teeth = tool.integerOr("teeth", 0, 1, kMostTeeth);
  cut.toolDiameter = Metres(tool.numberOr("diameter_mm", 0.0, 0.01, kLargestDiameterMm) * 1e-3);
  const TomlTable programmed = root.tableOr("cut");
  cut.nominalSpeed = Rpm(programmed.numberOr("speed_rpm", 0.0, 1.0, kHighestSpeedRpm));
  cut.nominalFeed = fromMmPerMin(programmed.numberOr("feed_mm_min", 0.0, 0.001, kHighestFeedMmMin));
  for (const TomlTable& channel : root.tablesOr("channels")) cut.channels.push_back(channelFrom(channel));
  return cut;
}

void readModel(const TomlTable& cut, Profile& profile) {
  profile.model = cut.textOr("model", "");
  profile.material = cut.textOr("material", "");
  profile.depth = Metres(cut.numberOr("depth_mm", 0.0, 0.001, kDeepestMm) * 1e-3);
}

void readClamping(const TomlTable& tool, Profile& profile) {
  profile.holder = tool.textOr("holder", "");
  profile.stickOut = Metres(tool.numberOr("stick_out_mm", 0.0, 0.01, kLongestStickOutMm) * 1e-3);
}

void readPitch(const TomlTable& tool, Profile& profile) {
  constexpr double kClosed = 0.05;  // degrees; as a catalogue rounds them
  profile.pitch = tool.numbersOr("pitch_deg", {});
  if (profile.pitch.empty()) return;
  const auto [least, most] = std::minmax_element(profile.pitch.begin(), profile.pitch.end());
  const double sum = std::accumulate(profile.pitch.begin(), profile.pitch.end(), 0.0);
  if (static_cast<int>(profile.pitch.size()) != profile.cut.teeth) {
    tool.refuse("pitch_deg", message("needs one angle per tooth"));
  } else if (!(*least > 0.0) || !(std::abs(sum - 360.0) < kClosed)) {
    tool.refuse("pitch_deg", message("does not go once around"), message("angles above zero, 360 degrees together"));
  } else if (*most - *least < kClosed) {
    profile.pitch.clear();
  }
}

struct ParamReading {
  const ParamCatalog& catalog;
  std::span<const ParamRename> renames;
  int version;
  ParamSet params;
  std::optional<Error> error;

  std::string currentKey(std::string key) const {
    for (const ParamRename& r : renames) {
      if (version <= r.until && key == r.from) key = r.to;
    }
    return key;
  }
  void read(const TomlTable& table, const std::string& prefix) {
    for (const std::string& key : table.keys()) {
      if (table.isTable(key)) {
        read(table.table(key), prefix + key + ".");
        continue;
      }
      const Status set = params.set(catalog, currentKey(prefix + key), table.scalarText(key), table.place(key));
      if (!set && !error) error = set.error();
    }
  }
};

Result<Profile> profileFrom(const TomlReader& in, const ParamCatalog& catalog, const KnownIds& known,
                            std::span<const ParamRename> renames) {
  if (const auto unreadable = in.error()) return *unreadable;
  const TomlTable root = in.root();
  const int version = root.integer("version", 1);
  if (version > kProfileVersion) {
    return Error{root.place("version"),
                 message("profile version %1 is newer than this program", std::to_string(version)),
                 message("it reads up to version %1", std::to_string(kProfileVersion))};
  }
  Profile profile;
  profile.cut = cutFrom(root);
  profile.operatorName = root.textOr("operator", "");
  readClamping(root.tableOr("tool"), profile);
  readPitch(root.tableOr("tool"), profile);
  readModel(root.tableOr("cut"), profile);
  profile.source = partFrom(root.tableOr("source"), known.sources);
  profile.link = partFrom(root.tableOr("link"), known.links);
  profile.active = partFrom(root.tableOr("active"), known.actives);
  const TomlTable control = root.tableOr("control");
  profile.detector = idFrom(control, "detector", profile.detector, known.detectors);
  profile.fallback = idFrom(control, "fallback", "", known.detectors);
  profile.strategy = idFrom(control, "strategy", profile.strategy, known.strategies);
  profile.allowAuto = control.booleanOr("allow_auto", false);
  const TomlTable recording = root.tableOr("recording");
  profile.recording = {recording.textOr("folder", ""), recording.textOr("job", "")};
  ParamReading parameters{catalog, renames, version, {}, std::nullopt};
  parameters.read(root.tableOr("parameters"), "");
  if (const Status finished = in.finish(); !finished) return finished.error();
  if (parameters.error) return *parameters.error;
  profile.params = std::move(parameters.params);
  return profile;
}

void writePart(TomlWriter& out, std::string_view name, const ComponentChoice& part) {
  if (part.id.empty()) return;
  out.table(name);
  out.text("id", part.id);
  if (part.settings.empty()) return;
  out.table(std::string(name) + ".settings");
  for (const auto& [key, value] : part.settings) out.scalar(key, value);
}

void writeCut(TomlWriter& out, const Profile& profile) {
  const CutSetup& cut = profile.cut;
  out.table("tool");
  out.text("label", cut.tool);
  if (!profile.holder.empty()) out.text("holder", profile.holder);
  if (profile.stickOut.value > 0.0) out.number("stick_out_mm", profile.stickOut.value * 1e3);
  if (cut.teeth > 0) out.integer("teeth", cut.teeth);
  if (cut.toolDiameter.value > 0.0) out.number("diameter_mm", cut.toolDiameter.value * 1e3);
  if (!profile.pitch.empty()) out.numbers("pitch_deg", profile.pitch);
  out.table("cut");
  if (cut.nominalSpeed.value > 0.0) out.number("speed_rpm", cut.nominalSpeed.value);
  if (cut.nominalFeed.value > 0.0) out.number("feed_mm_min", toMmPerMin(cut.nominalFeed));
  if (!profile.model.empty()) out.text("model", profile.model);
  if (!profile.material.empty()) out.text("material", profile.material);
  if (profile.depth.value > 0.0) out.number("depth_mm", profile.depth.value * 1e3);
  for (const ChannelInfo& channel : cut.channels) {
    out.arrayElement("channels");
    out.text("name", channel.name);
    out.text("quantity", name(channel.quantity));
    if (channel.sensitivity != 0.0) {
      out.number("sensitivity_mv", channel.sensitivity);
      out.number("volts", channel.volts);
    } else {
      out.number("scale", channel.scale);
    }
    out.text("axis", channel.axis);
    if (!channel.coupling.empty()) out.text("coupling", channel.coupling);
    if (!channel.place.empty()) out.text("place", channel.place);
  }
}

void writeRecording(TomlWriter& out, const RecordingChoice& recording) {
  if (recording.folder.empty() && recording.job.empty()) return;
  out.table("recording");
  if (!recording.folder.empty()) out.text("folder", recording.folder);
  if (!recording.job.empty()) out.text("job", recording.job);
}

}  // namespace

void writeParameters(TomlWriter& out, const ParamSet& params, const ParamCatalog& catalog, std::string_view prefix) {
  // A table may be opened once only, so the parts are written one after the other.
  std::map<std::string, std::vector<const ParamDecl*>> parts;
  for (const ParamDecl* decl : catalog.all()) {
    if (params.isSet(*decl)) parts[std::string(decl->key.substr(0, decl->key.rfind('.')))].push_back(decl);
  }
  for (const auto& [part, decls] : parts) {
    out.table(std::string(prefix) + part);
    for (const ParamDecl* decl : decls) out.scalar(decl->key.substr(part.size() + 1), params.text(*decl));
  }
}

Result<ParamSet> readParameters(const TomlTable& parameters, const ParamCatalog& catalog) {
  ParamReading reading{catalog, {}, kProfileVersion, {}, std::nullopt};
  reading.read(parameters, "");
  if (reading.error) return *reading.error;
  return std::move(reading.params);
}

Result<ParamSet> loadParameters(const std::string& path, const ParamCatalog& catalog) {
  const TomlReader in = TomlReader::file(path);
  if (const auto unreadable = in.error()) return *unreadable;
  ParamReading parameters{catalog, {}, kProfileVersion, {}, std::nullopt};
  parameters.read(in.root(), "");
  if (const Status finished = in.finish(); !finished) return finished.error();
  if (parameters.error) return *parameters.error;
  return std::move(parameters.params);
}

Result<Profile> loadProfile(const std::string& path, const ParamCatalog& catalog, const KnownIds& known,
                            std::span<const ParamRename> renames) {
  return profileFrom(TomlReader::file(path), catalog, known, renames);
}

Result<Profile> parseProfile(std::string_view content, const std::string& name, const ParamCatalog& catalog,
                             const KnownIds& known, std::span<const ParamRename> renames) {
  return profileFrom(TomlReader::text(content, name), catalog, known, renames);
}

std::string profileText(const Profile& profile, const ParamCatalog& catalog) {
  TomlWriter out;
  out.integer("version", kProfileVersion);
  out.text("machine", profile.cut.machine);
  if (!profile.operatorName.empty()) out.text("operator", profile.operatorName);
  writeCut(out, profile);
  writePart(out, "source", profile.source);
  writePart(out, "link", profile.link);
  writePart(out, "active", profile.active);
  out.table("control");
  out.text("detector", profile.detector);
  if (!profile.fallback.empty()) out.text("fallback", profile.fallback);
  out.text("strategy", profile.strategy);
  out.boolean("allow_auto", profile.allowAuto);
  writeRecording(out, profile.recording);
  writeParameters(out, profile.params, catalog);
  return out.content();
}

namespace {

std::optional<std::string> contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::string content{std::istreambuf_iterator<char>(file), {}};
  return file.bad() ? std::nullopt : std::optional(std::move(content));
}

// What the file shall hold: what is written there with the new values put in, where it reads back as meant.
std::string savedText(const std::string& written, const std::string& after, const ParamCatalog& catalog,
                      const std::string& path) {
  const auto before = parseProfile(written, path, catalog);
  if (!before) return after;
  std::string edited = editedToml(written, profileText(*before, catalog), after);
  const auto again = parseProfile(edited, path, catalog);
  return again && profileText(*again, catalog) == after ? edited : after;
}

}  // namespace

Status saveProfile(const Profile& profile, const ParamCatalog& catalog, const std::string& path) {
  const std::string after = profileText(profile, catalog);
  const std::optional<std::string> written = contentOf(path);
  if (!written) return writeFileAtomically(path, after);
  const std::string saved = savedText(*written, after, catalog, path);
  if (saved == *written) return Done{};
  if (Status kept = writeFileAtomically(path + std::string(kProfileBefore), *written); !kept) return kept;
  return writeFileAtomically(path, saved);
}

Status applySetting(ParamSet& params, const ParamCatalog& catalog, std::string_view setting, std::string_view where) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    return Error{std::string(where), message("'%1' is not KEY=VALUE", setting),
                 message("for example energy-ratio.chatter=0.2")};
  }
  return params.set(catalog, setting.substr(0, equals), setting.substr(equals + 1), where);
}

}  // namespace stillcut::config
