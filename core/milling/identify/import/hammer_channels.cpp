#include "core/milling/identify/import/hammer_channels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/milling/identify/import/direct_responses.h"
#include "core/milling/identify/import/unit_label.h"
#include "core/units/number_scan.h"

namespace stillcut::identify {
namespace {

// The unit of sound files, whose samples are parts of what their recorder could take.
constexpr std::string_view kFullScale = "full scale";

std::string nameOf(const TimeChannels& all, std::size_t c) {
  return all.channels[c].name.empty() ? std::to_string(c) : all.channels[c].name;
}

std::string namesOf(const TimeChannels& all) {
  std::string names;
  for (std::size_t c = 0; c < all.channels.size(); ++c) {
    names += (c > 0 ? ", " : "") + std::to_string(c) + " '" + all.channels[c].name + "'";
  }
  return names;
}

// By its name, or by its number from 0.
Result<std::size_t> channelNamed(const TimeChannels& all, const std::string& text, const std::string& option) {
  for (std::size_t c = 0; c < all.channels.size(); ++c) {
    if (all.channels[c].name == text || std::to_string(c) == text) return c;
  }
  return Error{option, message("there is no channel '%1'", text), message("it holds %1", namesOf(all))};
}

// Part of the time that the signal spends above a tenth of its peak: next to nothing for a hammer.
double timeAboveTenth(const TimeChannel& channel) {
  double peak = 0.0;
  for (const double v : channel.samples) peak = std::max(peak, std::abs(v));
  const auto above = std::count_if(channel.samples.begin(), channel.samples.end(),
                                   [peak](double v) { return std::abs(v) > 0.1 * peak; });
  return static_cast<double>(above) / static_cast<double>(std::max<std::size_t>(channel.samples.size(), 1));
}

Result<std::size_t> findForce(const TimeChannels& all, const ImportOptions& options, std::vector<Message>& remarks) {
  if (!options.force.empty()) return channelNamed(all, options.force, "--force");
  std::vector<std::size_t> said;
  for (std::size_t c = 0; c < all.channels.size(); ++c) {
    if (all.channels[c].force) said.push_back(c);
  }
  if (said.size() == 1) return said[0];
  const Error unknown{all.source, message("does not say which channel is the hammer's force"),
                      message("name it with --force; it holds %1", namesOf(all))};
  if (!said.empty() || all.channels.size() != 2) return unknown;
  const double first = timeAboveTenth(all.channels[0]);
  const double second = timeAboveTenth(all.channels[1]);
  // Both may ring; a hammer's pulse is over while the structure answers for many of its lengths.
  if (std::max(first, second) < 3.0 * std::min(first, second)) return unknown;
  const std::size_t force = first < second ? 0 : 1;
  remarks.push_back(
      message("channel %1 is read as the force, by its short pulses (--force says otherwise)", std::to_string(force)));
  return force;
}

Result<std::vector<std::size_t>> findResponses(const TimeChannels& all, std::size_t force,
                                               const ImportOptions& options) {
  std::vector<std::size_t> found;
  for (const std::string& name : options.responses) {
    const auto channel = channelNamed(all, name, "--response");
    if (!channel) return channel.error();
    found.push_back(*channel);
  }
  if (!found.empty()) return found;
  for (std::size_t c = 0; c < all.channels.size(); ++c) {
    if (c != force && all.channels[c].response) found.push_back(c);
  }
  if (found.empty() && all.channels.size() == 2) found.push_back(1 - force);
  if (!found.empty()) return found;
  return Error{all.source, message("does not say which channel is the response"),
               message("name it with --response; it holds %1", namesOf(all))};
}

// What a channel's numbers are multiplied with, and what they then are; or what has to be asked for.
struct Meaning {
  double factor = 1.0;
  FrfQuantity quantity = FrfQuantity::Accelerance;
  std::optional<Message> missing;  // what the file does not say
  std::string option;              // and the option that says it
};

// What the options say of one channel.
struct Given {
  std::string unit;
  std::string sensitivity;
  std::optional<double> scale;
  std::string prefix;  // of the options: "--force"
};

Given givenFor(bool force, const ImportOptions& o) {
  return force ? Given{o.forceUnit, o.forceSensitivity, o.forceScale, "--force"}
               : Given{o.responseUnit, o.responseSensitivity, o.responseScale, "--response"};
}

// Of a channel in volts: `meaning` comes with the factor to volts.
Result<Meaning> bySensitivity(Meaning meaning, const std::string& channel, bool force, const Given& given) {
  if (given.sensitivity.empty()) {
    meaning.missing = message("the sensitivity of '%1', which is in volts", channel);
    meaning.option = force ? "--force-sensitivity 2.25mV/N" : "--response-sensitivity 100mV/g";
    return meaning;
  }
  const auto known = sensitivityFromText(given.sensitivity);
  if (!known || known->response.has_value() == force) {
    return Error{given.prefix + "-sensitivity", message("'%1' is no sensitivity", given.sensitivity),
                 message("as 2.25mV/N, 10mV/lbf, 100mV/g or 10.2mV/(m/s^2)")};
  }
  meaning.factor /= known->voltsPerUnit;
  meaning.quantity = known->response.value_or(meaning.quantity);
  return meaning;
}

Result<Meaning> byUnit(Meaning meaning, const std::string& label, const std::string& channel, bool force,
                       const Given& given) {
  const auto response = responseUnit(label);
  const auto newtons = forceUnit(label);
  if (force ? newtons.has_value() : response.has_value()) {
    meaning.factor *= force ? *newtons : response->factor;
    if (!force) meaning.quantity = response->quantity;
    return meaning;
  }
  if (!given.unit.empty()) {
    return Error{given.prefix + "-unit", message("unit '%1' is not known", uff::printable(given.unit)),
                 force ? message("as N, kN, lbf or V") : message("as m/s^2, g, m/s, mm/s, um or V")};
  }
  const bool said = !label.empty() && label != kFullScale;
  meaning.missing = said ? message("what '%1' means as the unit of '%2'", uff::printable(label), channel)
                         : message("the unit of '%1'", channel);
  meaning.option = given.prefix + (force ? "-unit N, kN or lbf" : "-unit m/s^2, g, mm/s or um");
  return meaning;
}

Result<Meaning> meaningOf(const TimeChannels& all, std::size_t c, bool force, const ImportOptions& options) {
  const TimeChannel& channel = all.channels[c];
  Given given = givenFor(force, options);
  const std::string label = given.unit.empty() ? channel.unit : given.unit;
  const auto volts = voltageUnit(label);
  Meaning meaning;
  meaning.quantity = channel.response.value_or(FrfQuantity::Accelerance);
  if (!given.sensitivity.empty() && !volts) {
    return Error{all.source, message("channel '%1' is not in volts", nameOf(all, c)),
                 message("its sensitivity says nothing then; or say %1 V", given.prefix + "-unit")};
  }
  if (given.unit.empty() && channel.toSi) {
    meaning.factor = *channel.toSi;
    return meaning;
  }
  if (channel.unit == kFullScale && !channel.toSi && !given.scale) {
    meaning.missing = message("what the full scale of '%1' is", nameOf(all, c));
    meaning.option = given.prefix + "-unit and " + given.prefix + "-scale";
    return meaning;
  }
  if (given.sensitivity.empty()) given.sensitivity = channel.sensitivity;
  if (!channel.sensitivity.empty() && label.empty()) {
    meaning.missing = message("whether '%1', whose sensitivity is %2, is in V or mV", nameOf(all, c),
                              uff::printable(channel.sensitivity));
    meaning.option = given.prefix + "-unit V or mV";
    return meaning;
  }
  meaning.factor = given.scale.value_or(1.0) * volts.value_or(1.0);
  return volts ? bySensitivity(meaning, nameOf(all, c), force, given)
               : byUnit(meaning, label, nameOf(all, c), force, given);
}

// Everything that is missing in one line, so that a person is asked once.
std::optional<Error> askFor(const TimeChannels& all, const std::vector<Meaning>& meanings) {
  std::vector<Message> missing;
  std::string options;
  for (const Meaning& m : meanings) {
    if (!m.missing) continue;
    missing.push_back(*m.missing);
    if (options.find(m.option) == std::string::npos) options += (options.empty() ? "" : "; ") + m.option;
  }
  if (missing.empty()) return std::nullopt;
  return Error{all.source, message("does not say %1", Message::Argument(missing, "; ")), message("give %1", options)};
}

std::vector<double> scaled(const std::vector<double>& samples, double factor) {
  std::vector<double> out(samples.size());
  std::transform(samples.begin(), samples.end(), out.begin(), [factor](double v) { return factor * v; });
  return out;
}

}  // namespace

Result<ImportedHammer> hammerFromChannels(const TimeChannels& all, const ImportOptions& options) {
  ImportedHammer imported;
  const auto force = findForce(all, options, imported.remarks);
  if (!force) return force.error();
  const auto responses = findResponses(all, *force, options);
  if (!responses) return responses.error();
  std::vector<OfferedResponse> offered;
  // A response that was named is along the hit, whatever the file calls its axis; so is its axis where one was named.
  const bool named = !options.responses.empty();
  const bool axisGiven = named && responses->size() == 1 && !options.axes.empty();
  const Axis pushed = named ? Axis::Unknown : all.channels[*force].axis;
  offered.reserve(responses->size());
  for (const std::size_t c : *responses) {
    offered.push_back({nameOf(all, c), axisGiven ? Axis::Unknown : all.channels[c].axis, pushed});
  }
  const auto choice = chooseResponses(offered, options.axes, all.source, "--response", ForceAxis::Overruled);
  if (!choice) return choice.error();
  imported.remarks.insert(imported.remarks.end(), choice->remarks.begin(), choice->remarks.end());
  std::vector<Meaning> meanings;
  const auto push = meaningOf(all, *force, true, options);
  if (!push) return push.error();
  meanings.push_back(*push);
  for (const ChosenResponse& chosen : choice->responses) {
    const auto meaning = meaningOf(all, (*responses)[chosen.offered], false, options);
    if (!meaning) return meaning.error();
    meanings.push_back(*meaning);
  }
  if (const auto missing = askFor(all, meanings)) return *missing;
  for (std::size_t i = 0; i < choice->responses.size(); ++i) {
    const std::size_t c = (*responses)[choice->responses[i].offered];
    HammerRecord record;
    record.rate = all.rate;
    record.source = all.source;
    record.axis = choice->responses[i].axis;
    record.quantity = meanings[i + 1].quantity;
    record.force = scaled(all.channels[*force].samples, push->factor * all.channels[*force].sign);
    record.response = scaled(all.channels[c].samples, meanings[i + 1].factor * all.channels[c].sign);
    imported.records.push_back(std::move(record));
  }
  return imported;
}

}  // namespace stillcut::identify
