// TapController: what the Tap test page needs: devices to listen to with their meters, hits as they come or from files,
// the response they give with the modes fitted to it, and the speeds and depths that follow. app/session implements it;
// devices, fits and lobes run on threads of their own and are taken over by poll(). GUI thread; every function returns
// at once. Axes: 0 is x, along the feed, 1 is y.
#pragma once

#include <QString>
#include <QStringList>
#include <complex>
#include <map>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::ui {

inline constexpr int kTapAxes = 2;

struct TapDevice {
  QString id, name;  // name in the language of the screen
};

struct TapChannel {
  QString name, unit;   // of the profile; unit as "m/s2"
  int axis = -1;        // that it lies along; -1: not told
  bool force = false;   // a hammer
  bool usable = false;  // a response
  double level = 0.0;   // largest of the last moment [unit]
  double most = 0.0;    // largest since it is listened to
  bool clipped = false;
};

struct TapListening {
  enum class State { Off, Opening, Running, Failed };
  State state = State::Off;
  QString device;   // id
  QString problem;  // in the language of the screen
  Hertz rate{};
  std::vector<TapChannel> channels;
  int force = -1;     // channel of the hammer; -1: none, only frequencies and damping can be found
  int response = -1;  // channel along the axis in turn
};

enum class TapFault { None, DoubleHit, ForceOverload, ResponseOverload, Weak, TooSoon, Gap, Incoherent };

struct TapHitRow {
  double peak = 0.0;  // N with a hammer
  Seconds width{};    // of the pulse; 0: no hammer
  TapFault fault = TapFault::None;
  bool used = false;
  QString file;  // empty: measured here
};

struct TapRun {
  enum class Phase { Off, Settling, HitNow, Recording, Ringing, Enough };
  Phase phase = Phase::Off;
  int axis = 0;  // in turn
  int good = 0, wanted = 5;
};

struct TapMode {
  Hertz frequency{};
  double frequencySd = 0.0;
  double damping = 0.0, dampingSd = 0.0;
  double stiffness = 0.0, stiffnessSd = 0.0;  // 0: no hammer, not known [N/m]
  double share = 0.0;                         // of the softest mode's flexibility, 0..1
  double coherence = 0.0;                     // around it; 0: not measured
  QString doubt;                              // one line, or empty
  bool used = true;                           // ticked
};

// Along one axis.
struct TapResponse {
  enum class State { None, Working, Done, Failed };
  State state = State::None;
  bool withForce = true;
  std::vector<double> frequency;               // [Hz]
  std::vector<std::complex<double>> measured;  // compliance [m/N]; without force on a scale of its own
  std::vector<std::complex<double>> fitted;    // by the ticked modes, at the same lines; empty: no fit yet
  std::vector<double> coherence;               // at the same lines; empty: one hit, or no hammer
  double from = 0.0, to = 0.0;                 // band of the fit [Hz]
  std::vector<TapMode> modes;
  QStringList remarks;
  QString problem;            // why there is no fit
  std::uint32_t version = 0;  // another one: something of this has changed
};

struct TapMaterial {
  QString id, name;
};

struct TapCut {
  QString material;  // id
  int teeth = 2;
  Metres diameter{0.012};
  double immersion = 0.5;  // radial depth over diameter
  bool upMilling = false;
  Rpm lowest{2000.0}, highest{18000.0};
  Metres feedPerTooth{0.05e-3};
  Metres deepest{0.010};  // that the tool can cut: length of its flutes
  bool operator==(const TapCut&) const = default;
};

struct TapLimit {
  Rpm speed{};
  Metres limit{}, low{}, high{};  // the middle 80 % of what the doubt of modes and material allows
};

struct TapSpeed {
  Rpm speed{};
  int wavesBetweenTeeth = 1;
  Hertz frequency{};
};

struct TapLobes {
  enum class State { None, Working, Done, Failed };
  State state = State::None;
  QString problem;
  TapCut cut;  // that they are of
  std::vector<TapLimit> limits;
  // The deepest cut that stays stable whatever the doubt, where it removes most.
  Rpm speed{};
  Metres depth{}, anySpeed{};  // and that at every speed of the range
  double removal = 0.0;        // [m3/s]
  bool open = false;           // the tool's own length ends it, not chatter
  int rigid = -1;              // axis along which nothing was measured; -1: both were
  // Without a hammer: speeds whose tooth passing meets the modes, to be tried; no depth can be told.
  std::vector<TapSpeed> toTry;
  std::uint32_t version = 0;
};

// What a file of a tap test may leave open. A person knows; a factor is never guessed.
enum class TapQuestion {
  Hammer,               // name of the hammer's channel
  Sensor,               // and of the response's
  ForceUnit,            // "N", "lbf"
  ResponseUnit,         // "m/s^2", "g"
  ForceSensitivity,     // of a channel in volts: "2.25 mV/N"
  ResponseSensitivity,  // "100 mV/g"
  ForceFullScale,       // of those units: what full scale of a sound file is
  ResponseFullScale,
  Unit,           // of a frequency response: "um/N"
  FrequencyUnit,  // "Hz", "kHz", "rad/s"
  PhaseUnit,      // "deg", "rad"
};

struct TapAnswers {
  std::map<TapQuestion, QString> said;
  bool flip = false;  // the response points against the force
  bool operator==(const TapAnswers&) const = default;
};

// The files that somebody asked for last.
struct TapFileReading {
  bool runs = false;
  QString problem;                     // why they were not taken, in the language of the screen; what was there stays
  std::vector<TapQuestion> questions;  // that they leave open, and those answered before
  bool flipAsked = false;              // it looks as if the response pointed against the force
  TapAnswers answers;
};

enum class TapKept { Modes, Cut };

class TapController {
 public:
  virtual ~TapController() = default;

  // Takes over what has been heard and computed. True: something below has changed. Every display tick.
  virtual bool poll() = 0;

  virtual std::vector<TapDevice> devices() const = 0;
  virtual void listen(const QString& device) = 0;
  virtual void stopListening() = 0;
  virtual const TapListening& listening() const = 0;
  virtual void chooseForce(int channel) = 0;  // -1: none
  virtual void chooseResponse(int channel) = 0;

  // The hits of an axis anew. Nothing is listened to: nothing happens.
  virtual void begin(int axis) = 0;
  virtual void end() = 0;  // what was hit stays
  virtual TapRun run() const = 0;
  virtual const std::vector<TapHitRow>& hits(int axis) const = 0;
  virtual void useHit(int axis, std::size_t hit, bool use) = 0;

  // Hammer records, frequency responses or modes, instead of a device. What names no axis lies along `axis`; the other
  // axis keeps what it has. Without any force the response alone gives frequencies and damping.
  virtual void openFiles(const QStringList& paths, int axis) = 0;
  virtual const QStringList& files() const = 0;  // whose measurement was shown last; empty: a device's
  virtual const TapFileReading& reading() const = 0;
  // The same files again, with what they do not say.
  virtual void answer(const TapAnswers& answers) = 0;

  virtual const TapResponse& response(int axis) const = 0;
  virtual void useMode(int axis, std::size_t mode, bool use) = 0;

  virtual std::vector<TapMaterial> materials() const = 0;
  // What is computed for another cut, or for other modes, ends.
  virtual void compute(const TapCut& cut) = 0;
  virtual const TapLobes& lobes() const = 0;

  // Names of the shop's tools; and what one of them says of a cut: teeth, diameter, limits.
  virtual QStringList tools() const = 0;
  virtual TapCut withTool(TapCut cut, const QString& tool) const = 0;
  // The ticked modes with the cut of compute() as one file that profiles take, and the tool's in the library; gives its
  // name. `tool` may be empty: the file alone.
  virtual Result<QString> saveCut(const QString& tool) = 0;
  // The file that would be overwritten; empty: there is none yet.
  virtual QString keptAlready(TapKept what, const QString& name) const = 0;
  // The ticked modes of both axes alone, as `modal` writes them; gives the file's name.
  virtual Result<QString> saveModes(const QString& name) = 0;
};

}  // namespace stillcut::ui
