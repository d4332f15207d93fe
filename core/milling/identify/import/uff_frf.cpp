#include "core/milling/identify/import/uff_frf.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/milling/identify/import/direct_responses.h"
#include "core/units/number_scan.h"

namespace stillcut::identify {
namespace {

using uff::Uff58Dataset;
using uff::Uff58Quantity;

bool isUnset(const std::string& unit) {
  return unit.empty() || unit == "NONE" || unit == "None" || unit == "none";
}

Axis axisOf(int direction) {
  const int size = std::abs(direction);
  return size == 1 ? Axis::X : size == 2 ? Axis::Y : size == 3 ? Axis::Z : Axis::Unknown;
}

// Turned once for each degree of freedom that points against its axis.
double signOf(int response, int reference) {
  return (response < 0) != (reference < 0) ? -1.0 : 1.0;
}

std::optional<FrfQuantity> quantityOf(Uff58Quantity quantity) {
  if (quantity == Uff58Quantity::Displacement) return FrfQuantity::Compliance;
  if (quantity == Uff58Quantity::Velocity) return FrfQuantity::Mobility;
  if (quantity == Uff58Quantity::Acceleration) return FrfQuantity::Accelerance;
  return std::nullopt;
}

bool isForce(Uff58Quantity quantity) {
  return quantity == Uff58Quantity::ExcitationForce || quantity == Uff58Quantity::ReactionForce;
}

// From the words of the axes first, from dataset 164 second.
Result<SettledUnit> unitOf(const Uff58Dataset& set, const std::optional<UffUnits>& units, const std::string& where,
                           const ImportOptions& options) {
  if (!options.unit.empty() || (options.quantity && options.scale)) return settleUnit("", where, options);
  if (const auto whole = frfUnit(set.ordinate.unit)) return settleUnit(set.ordinate.unit, where, options);
  std::optional<ResponseUnit> unit = responseUnit(set.ordinate.unit);
  if (!unit && !isUnset(set.ordinate.unit)) return settleUnit(set.ordinate.unit, where, options);
  const auto byType = quantityOf(set.ordinate.quantity);
  if (!unit && byType && units) unit = ResponseUnit{*byType, 1.0 / units->perMetre};
  std::optional<double> force = forceUnit(set.denominator.unit);
  if (!force && !isUnset(set.denominator.unit)) {
    return Error{where, message("force unit '%1' is not known", uff::printable(set.denominator.unit)),
                 message("give the unit of its response with --unit, as --unit m/N, um/N, (m/s^2)/N or g/N")};
  }
  if (!force && units) force = 1.0 / units->perNewton;
  SettledUnit settled;
  settled.known = unit && force;
  if (settled.known) settled.unit = {unit->quantity, unit->factor / *force};
  settled.unit.quantity =
      options.quantity.value_or(settled.known ? settled.unit.quantity : byType.value_or(FrfQuantity::Compliance));
  settled.unit.factor = options.scale.value_or(settled.unit.factor);
  return settled;
}

std::string nameOf(const Uff58Dataset& set, std::size_t number) {
  const auto end = [](long node, int direction) {
    const std::string axis(name(axisOf(direction)));
    return std::to_string(node) + (direction < 0 ? "-" : "") + axis;
  };
  return std::to_string(number) + ": " + end(set.responseNode, set.responseDirection) + " by " +
         end(set.referenceNode, set.referenceDirection);
}

Result<Frf> frfOf(const Uff58Dataset& set, const std::optional<UffUnits>& units, const std::string& where,
                  const ImportOptions& options) {
  if (!set.complex) return Error{where, message("its frequency response is real"), message("a complex one is needed")};
  for (std::size_t i = 1; i < set.x.size(); ++i) {
    if (!(set.x[i] > set.x[i - 1])) {
      return Error{where, message("the frequency does not rise at row %1", std::to_string(i + 1))};
    }
  }
  if (set.x.empty() || set.x.front() < 0.0) return Error{where, message("holds negative frequencies")};
  if (isForce(set.ordinate.quantity) && quantityOf(set.denominator.quantity)) {
    return Error{where, message("holds force over response, a dynamic stiffness"),
                 message("export response over force")};
  }
  const auto unit = unitOf(set, units, where, options);
  if (!unit) return unit.error();
  if (unit->decibels || unit->inverse) {
    return Error{where, message("unit '%1' is not that of a response over a force", uff::printable(set.ordinate.unit)),
                 message("export response over force, linear")};
  }
  const std::string& label = options.frequencyUnit.empty() ? set.abscissa.unit : options.frequencyUnit;
  const double hertz = frequencyUnit(label).value_or(1.0);  // the format's own unit where nothing else is said
  Frf frf;
  frf.quantity = unit->unit.quantity;
  frf.unitKnown = unit->known;
  frf.frequency = set.x;
  frf.value = set.y;
  const double factor = unit->unit.factor * signOf(set.responseDirection, set.referenceDirection);
  for (double& f : frf.frequency) f *= hertz;
  for (auto& v : frf.value) v *= factor;
  frf.source = where;
  return frf;
}

// The coherence of the same pair of points, where the file holds it on the same lines.
void addCoherence(const std::vector<Uff58Dataset>& sets, const Uff58Dataset& of, Frf& frf) {
  for (const Uff58Dataset& set : sets) {
    const bool same = set.responseNode == of.responseNode && set.responseDirection == of.responseDirection &&
                      set.referenceNode == of.referenceNode && set.referenceDirection == of.referenceDirection;
    if (set.function != uff::Uff58Function::Coherence || !same || set.y.size() != of.y.size()) continue;
    for (const auto& v : set.y) frf.coherence.push_back(v.real());
    return;
  }
}

Result<std::vector<std::size_t>> wantedSets(const std::vector<const Uff58Dataset*>& responses, const std::string& where,
                                            const ImportOptions& options) {
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    if (!options.dataset || *options.dataset == i) wanted.push_back(i);
  }
  if (!wanted.empty()) return wanted;
  return Error{where, message("holds %1 frequency responses", std::to_string(responses.size())),
               message("number %1 (from 0) was asked for", std::to_string(*options.dataset))};
}

}  // namespace

bool holdsFrfs(const std::vector<uff::Uff58Dataset>& sets) {
  return std::any_of(sets.begin(), sets.end(),
                     [](const Uff58Dataset& s) { return s.function == uff::Uff58Function::FrequencyResponse; });
}

Result<ImportedFrfs> frfsFromUff(const std::vector<Uff58Dataset>& sets, const std::optional<UffUnits>& units,
                                 const std::string& where, const ImportOptions& options) {
  std::vector<const Uff58Dataset*> responses;
  for (const Uff58Dataset& set : sets) {
    if (set.function == uff::Uff58Function::FrequencyResponse) responses.push_back(&set);
  }
  if (responses.empty()) return Error{where, message("holds no frequency response")};
  const auto wanted = wantedSets(responses, where, options);
  if (!wanted) return wanted.error();
  std::vector<OfferedResponse> offered;
  for (const std::size_t i : *wanted) {
    const Uff58Dataset& set = *responses[i];
    offered.push_back({nameOf(set, i), axisOf(set.responseDirection), axisOf(set.referenceDirection)});
    if (options.dataset) {  // named: whoever asks for it knows what it is
      if (options.axes.size() == 1) offered.back().along = options.axes.front();
      offered.back().force = offered.back().along;
    }
    // Another point of the structure is no driving point, whatever its direction.
    if (set.responseNode != set.referenceNode && wanted->size() > 1) offered.back().along = Axis::Unknown;
  }
  const auto choice = options.cross ? chooseCross(offered, where)
                                    : chooseResponses(offered, options.axes, where, "--dataset", ForceAxis::Fixed);
  if (!choice) return choice.error();
  ImportedFrfs imported;
  imported.remarks = choice->remarks;
  for (const ChosenResponse& chosen : choice->responses) {
    const Uff58Dataset& set = *responses[(*wanted)[chosen.offered]];
    auto frf = frfOf(set, units, where, options);
    if (!frf) return frf.error();
    addCoherence(sets, set, *frf);
    frf->axis = chosen.axis;
    imported.frfs.push_back(std::move(*frf));
  }
  return imported;
}

Result<TimeChannels> timeChannelsFromUff(const std::vector<Uff58Dataset>& sets, const std::optional<UffUnits>& units,
                                         const std::string& where) {
  TimeChannels out;
  out.source = where;
  for (const Uff58Dataset& set : sets) {
    if (set.function != uff::Uff58Function::TimeResponse || set.x.size() < 2) continue;
    const double step = (set.x.back() - set.x.front()) / static_cast<double>(set.x.size() - 1);
    if (!(step > 0.0)) return Error{where, message("its times do not rise")};
    if (out.rate > 0.0 && std::abs(out.rate * step - 1.0) > 1e-3) {
      return Error{where, message("its channels have different sampling rates")};
    }
    out.rate = 1.0 / step;
    TimeChannel channel;
    channel.name = set.ordinate.label;
    channel.unit = isUnset(set.ordinate.unit) ? "" : set.ordinate.unit;
    channel.force = isForce(set.ordinate.quantity);
    channel.response = quantityOf(set.ordinate.quantity);
    channel.axis = axisOf(set.responseDirection);
    channel.sign = set.responseDirection < 0 ? -1.0 : 1.0;
    if (channel.unit.empty() && units && channel.force) channel.toSi = 1.0 / units->perNewton;
    if (channel.unit.empty() && units && channel.response) channel.toSi = 1.0 / units->perMetre;
    for (const auto& v : set.y) channel.samples.push_back(v.real());
    out.channels.push_back(std::move(channel));
  }
  if (out.channels.empty()) return Error{where, message("holds neither frequency responses nor samples over time")};
  return out;
}

}  // namespace stillcut::identify
