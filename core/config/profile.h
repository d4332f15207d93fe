// Profile: what is saved for one machine: the tool, the channels, where samples come from and where commands go, which
// methods are in charge, and the parameters that differ from their defaults (the gate's limits are among them).
//
//   version = 1
//   machine = "Mill 3"
//   operator = "Ada"                                     signs the markers that are touched during the cut
//   [tool]       label, teeth, diameter_mm
//                holder, stick_out_mm                    as it is clamped: what is learned of one clamped otherwise is
//                                                        kept apart
//                pitch_deg                               [85, 95, ...] angle to the next tooth; left out: even
//   [cut]        speed_rpm, feed_mm_min                  as programmed; leave out what is not known
//                model, depth_mm                         file of the cut's modes and material, and its depth: where
//                                                        both are known strategies check their targets against the
//                                                        lobes
//                material                                a name of the table of materials, instead of the model's
//   [[channels]] name, quantity, scale, axis             scale: SI units per device unit; instead of it
//                sensitivity_mv, volts                   mV per g, Pa, N ... and V of one device unit
//                coupling, place                         iepe, ac, dc; where it is mounted
//   [source]     id        [source.settings]  keys of that device
//   [link]       id        [link.settings]    keys of that machine link
//   [active]     id        [active.settings]  keys of the active work-holder's device
//   [control]    detector, fallback, strategy, allow_auto
//   [recording]  folder, job                             every run is recorded below it; how: the parameters record.*
//   [parameters.energy-ratio]  chatter = 0.2             a declared key, its part as a table
//
// Thread: set-up.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/config/param_set.h"
#include "core/model/cut_setup.h"

namespace stillcut::config {

class TomlTable;
class TomlWriter;

inline constexpr int kProfileVersion = 1;

// A device or machine link by its id, with its own settings as text; the part itself checks them when it is made.
struct ComponentChoice {
  std::string id;  // empty: none
  std::map<std::string, std::string> settings;
};

// Whether a run of this machine is recorded, and under which name.
struct RecordingChoice {
  std::string folder;  // empty: it is not; relative: beside the profile
  std::string job;     // what is being made; empty: not given
};

struct Profile {
  CutSetup cut;               // rate and blockFrames are the source's affair and not part of a profile
  std::string holder;         // "HSK63 ER32"; empty: not given
  Metres stickOut{};          // from the holder's face to the tip; 0: not given
  std::vector<double> pitch;  // angle from each tooth to the next [deg], one a tooth, 360 together; empty: even
  std::string model;  // file with the modes, tool, material and engagement of the cut; empty: the modes are not known
  std::string material;      // by name (core/milling/material_table.h); empty: the model's own
  Metres depth{};            // of the cut; 0: unknown
  std::string operatorName;  // empty: not given
  RecordingChoice recording;
  ComponentChoice source;
  ComponentChoice link;
  ComponentChoice active;                 // device of the active work-holder
  std::string detector = "energy-ratio";  // in charge
  std::string fallback;                   // takes over when it fails; empty: none
  std::string strategy = "monitor";
  bool allowAuto = false;  // whether Auto may be chosen on this machine; authority still starts Off
  ParamSet params;
};

// The ids that exist, for "did you mean"; an empty list is not checked.
struct KnownIds {
  std::vector<std::string_view> sources, links, detectors, strategies, actives;
};

// A parameter that had another key in profiles up to and including version `until`.
struct ParamRename {
  int until = 0;
  std::string_view from, to;
};

// The file is named in every error. `renames` is what makes a profile of an older version readable.
Result<Profile> loadProfile(const std::string& path, const ParamCatalog& catalog, const KnownIds& known = {},
                            std::span<const ParamRename> renames = {});
// The same from text; `name` stands for the file.
Result<Profile> parseProfile(std::string_view content, const std::string& name, const ParamCatalog& catalog,
                             const KnownIds& known = {}, std::span<const ParamRename> renames = {});

// All of a profile as text, also stored in recordings. Parameters are in the order of the catalogue.
std::string profileText(const Profile& profile, const ParamCatalog& catalog);
// A file that is there keeps its comments and every line that still holds (toml_edit.h); as it was before, it stays
// beside it: "mill3.toml.bak". A file that already says all this is left alone.
inline constexpr std::string_view kProfileBefore = ".bak";
Status saveProfile(const Profile& profile, const ParamCatalog& catalog, const std::string& path);

// Parameters alone, a table a part: [energy-ratio] threshold = 0.2. The `--config` of the command line.
Result<ParamSet> loadParameters(const std::string& path, const ParamCatalog& catalog);

// Tables of a larger file: [parameters.energy-ratio] and so on, in the order of the catalogue, and back. Without a
// `prefix`: what loadParameters() reads.
void writeParameters(TomlWriter& out, const ParamSet& params, const ParamCatalog& catalog,
                     std::string_view prefix = "parameters.");
Result<ParamSet> readParameters(const TomlTable& parameters, const ParamCatalog& catalog);

// "KEY=VALUE" of the command line; `where` names the option for the error. Nothing changes on error.
Status applySetting(ParamSet& params, const ParamCatalog& catalog, std::string_view setting,
                    std::string_view where = "--set");

}  // namespace stillcut::config
