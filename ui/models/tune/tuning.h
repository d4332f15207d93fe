// What the Tune page needs of a session beyond the picture: which parts have parameters, the values that are in force,
// and where to keep others. app/session implements it. GUI thread; every function returns at once.
#pragma once

#include <QString>
#include <QStringList>
#include <map>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/config/param_set.h"
#include "core/model/rule_tables.h"
#include "ui/models/tune/tuning_controller.h"

namespace stillcut::ui {

struct TunableComponent {
  enum class Role { Conditioner, Detector, Strategy, Gate, Recording, Active };
  QString id;      // "energy-ratio"
  QString label;   // "Energy ratio", in English; shown by sayCore()
  QString source;  // "Caliskan, Kilic, Altintas 2018"
  Role role = Role::Detector;
  bool running = false;    // among the methods of this run
  bool inCharge = false;   // its verdict, or its wish, counts
  int detector = -1;       // index into Snapshot::verdicts; -1: none
  QStringList indicators;  // names of Verdict::indicators
  std::vector<const config::ParamDecl*> params;
  // Of a fuzzy strategy, else empty: its rules row by row (RuleTables), and the peaks of small, medium and big. The
  // rules are not among `params`.
  std::vector<const config::ParamDecl*> speedRules, feedRules, setCentres;
  std::map<std::string_view, double> chosen;  // by key: what the part chose for an automatic parameter when it was made
};

// What a part has set itself, now: of an automatic parameter, or of a key of its own ("energy-ratio.floor").
struct AutoReading {
  std::string_view key;
  QString label, unit, why;  // in English; shown by sayCore()
  double value = 0.0;        // not a number: not known yet
};

// What other limits of a detector would have done to the newest recordings.
struct SensitivityTrial {
  bool running = false;
  int looked = 0, recordings = 0;   // so far, of how many
  int alarms = 0, markedFalse = 0;  // with these limits
  int alarmsNow = 0, falseNow = 0;  // with those that the recordings were made with
  QString problem;                  // of the last one that could not be looked at, in the language of the screen
};

class Tuning {
 public:
  virtual ~Tuning() = default;

  // Another number: another run, with other parts and values.
  virtual std::uint32_t tuningRun() const = 0;
  virtual const std::vector<TunableComponent>& tunableParts() const = 0;
  // The rules of the fuzzy strategy that runs, as they are at this moment, what it has learned included; null: no such
  // strategy runs. Valid until the next call.
  virtual const RuleTables* rulesNow() { return nullptr; }
  // What a part of the run has set itself at this moment; empty where it sets nothing or does not run.
  virtual std::vector<AutoReading> ownNow(const TunableComponent& /*part*/) { return {}; }
  // Begins to run `detector` with these settings (KEY=VALUE) over the newest recordings; the newest question counts.
  virtual void tryOnRecordings(const QString& /*detector*/, const QStringList& /*settings*/) {}
  virtual SensitivityTrial trial() { return {}; }
  // Of the run that is shown. It is the run's, not the page's: pages come and go, what was set stays.
  virtual TuningController& controller() = 0;
  // Keeps these values: in the profile the run was made from, else in a parameter file of its own. Gives the file.
  virtual Result<QString> saveValues(const config::ParamSet& values) = 0;
};

}  // namespace stillcut::ui
