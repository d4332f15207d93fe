#include "app/cli/tap_options.h"

#include <map>

#include "app/cli/reading_options.h"
#include "core/session/open_recording.h"

namespace stillcut::app {

using namespace identify;

void TapOptions::add(CLI::App& command) {
  command.add_option("--axis", axes_, "Axis of the hit: x (along the feed) or y; x,y for both, or one for each file")
      ->delimiter(',')
      ->check(CLI::IsMember({"x", "y"}));
  command.add_option("--band", band_, "FROM:TO in Hz; an end left out: found from the resonances");
  command.add_option("--modes", request_.fit.modes, "Number of modes; left out: as many as the measurement calls for");
  command.add_option("--order", request_.fit.highestOrder, "Highest model order of the stabilisation");
  const std::map<std::string, MeasurementKind> kinds = {
      {"auto", MeasurementKind::Automatic}, {"frf", MeasurementKind::Frf}, {"hammer", MeasurementKind::Hammer}};
  ImportOptions& import = request_.import;
  command.add_option("--kind", import.kind, "What the file holds: auto, frf, hammer")
      ->transform(CLI::CheckedTransformer(kinds));
  command.add_option("--unit", import.unit, "Unit of a frequency response: m/N, um/N, (m/s^2)/N, g/N, in/lbf ...");
  command.add_option("--frequency-unit", import.frequencyUnit, "Unit of its frequencies: Hz, kHz, rad/s");
  command.add_option("--phase-unit", import.phaseUnit, "Unit of its phase: deg, rad");
  command.add_option("--quantity", quantity_, "compliance, mobility or accelerance, instead of what the file says")
      ->check(CLI::IsMember({"compliance", "mobility", "accelerance"}));
  command.add_option("--scale", scale_, "SI units of a frequency response per unit of the file");
  command.add_option("--dataset", dataset_, "Which frequency response of a UFF file, from 0");
  command.add_option("--force", import.force, "Channel of the hammer: its name or number, from 0");
  command.add_option("--response", import.responses, "Channel of the response along the hit: name or number")
      ->delimiter(',');
  command.add_option("--force-unit", import.forceUnit, "Unit of the hammer's channel: N, kN, lbf, V");
  command.add_option("--response-unit", import.responseUnit, "Unit of the response: m/s^2, g, m/s, mm/s, um, V");
  command.add_option("--force-scale", import.forceScale, "Of that unit per unit of the file: what full scale is");
  command.add_option("--response-scale", import.responseScale, "The same of the response");
  command.add_option("--force-sensitivity", import.forceSensitivity, "Of a hammer in volts: 2.25mV/N, 10mV/lbf");
  command.add_option("--response-sensitivity", import.responseSensitivity,
                     "Of a response in volts: 100mV/g, 10.2mV/(m/s^2)");
  command.add_option("--rate", rate_, "Sampling rate of a recording that does not say it [Hz]");
  addTimeUnit(command, timeUnit_);
  HammerOptions& hammer = request_.hammer;
  command.add_flag("--flip", hammer.flipResponse, "The response points against the force");
  command.add_flag("--flip-force", hammer.flipForce, "The force channel counts a push as negative");
  command.add_option("--estimate", estimate_, "h1 (noise on the response) or h2 (noise on the force)")
      ->check(CLI::IsMember({"h1", "h2"}));
  command.add_option("--without", hammer.without, "Hits to leave out, as they are numbered: N[,N]")->delimiter(',');
  command.add_option("--force-window", forceWindowMs_, "Zero the force this long after its peak [ms]");
  command.add_option("--exponential", hammer.exponentialEnd,
                     "Share of amplitude an exponential window leaves at the end; its damping is taken off again");
  command.add_option("--overload", hammer.overload, "Size at which force or response is overloaded");
  command.add_flag("--use-double-hits", hammer.useDoubleHits, "Keep double hits");
}

Status readBand(const std::string& text, ModalOptions& fit) {
  if (text.empty()) return Done{};
  const Error bad{"--band", message("'%1' is no band", text), message("FROM:TO in Hz, as 600:3100")};
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return bad;
  const auto number = [](const std::string& s, double& value) {
    return s.empty() || (CLI::detail::lexical_cast(s, value) && value >= 0.0);
  };
  if (!number(text.substr(0, colon), fit.from) || !number(text.substr(colon + 1), fit.to)) return bad;
  return Done{};
}

Result<ModalRequest> TapOptions::understand() const {
  ModalRequest request = request_;
  if (const Status band = readBand(band_, request.fit); !band) return band.error();
  for (const std::string& axis : axes_) request.import.axes.push_back(axisFromLetter(axis[0]));
  if (scale_ != 0.0) request.import.scale = scale_;
  if (quantity_ == "compliance") request.import.quantity = FrfQuantity::Compliance;
  if (quantity_ == "mobility") request.import.quantity = FrfQuantity::Mobility;
  if (quantity_ == "accelerance") request.import.quantity = FrfQuantity::Accelerance;
  if (dataset_ >= 0) request.import.dataset = static_cast<std::size_t>(dataset_);
  if (rate_ > 0.0) request.import.rate = Hertz(rate_);
  request.import.secondsPerTime = secondsOfTimeUnit(timeUnit_);
  request.hammer.forceWindow = 1e-3 * forceWindowMs_;
  request.hammer.estimate = estimate_ == "h2" ? FrfEstimate::H2 : FrfEstimate::H1;
  request.import.open = [](const std::string& path, const record::ReadOptions& options) {
    return record::openRecording(path, options);
  };
  return request;
}

}  // namespace stillcut::app
