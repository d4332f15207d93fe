// What the commands of `learn` share: which store, which tool in which machine, what is known of it before its first
// cut, and the work it is wanted for. Thread: one; set-up.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/learn/evidence_store.h"
#include "core/learn/lobe_posterior.h"
#include "core/learn/stability_map.h"

namespace stillcut::app {

struct StoreOptions {
  std::string store;  // empty: the user's own

  void add(CLI::App& command);
  // The user's own below ~/.local/share/stillcut is made with its folder; another is made in a folder that is there.
  Result<learn::EvidenceStore> open() const;
};

struct AssemblyOptions {
  std::string machine, tool, holder;
  double stickOutMm = 0.0;

  void add(CLI::App& command);
  learn::EvidenceFilter filter() const;
};

struct WorkOptions {
  int teeth = 0;            // 0: the newest cut's
  double diameterMm = 0.0;  // 0: the newest cut's
  double immersion = 0.0;   // 0: the newest cut's
  std::string side;         // "up", "down"; empty: the newest cut's
  std::string material;     // empty: the newest cut's
  std::string speeds;       // FROM:TO
  double maxDepthMm = 0.0;  // 0: the diameter
  double risk = 0.1;
  std::vector<std::string> modes;  // of a tap test
  std::string coefficients;
  bool coupled = false;  // `modes` were computed with `couple`

  void add(CLI::App& command);
};

// A posterior made of all cuts of an assembly, and the work that it is asked about.
struct Learned {
  std::vector<learn::CutEvidence> cuts;
  learn::LobePosterior posterior;
  learn::MapRequest work;
  std::string origin;  // of the prior
};
Result<Learned> learnFrom(const StoreOptions& store, const AssemblyOptions& assembly, const WorkOptions& work);

}  // namespace stillcut::app
