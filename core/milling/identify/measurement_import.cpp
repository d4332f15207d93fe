#include "core/milling/identify/measurement_import.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/universal/uff58.h"
#include "core/milling/identify/file_bytes.h"
#include "core/milling/identify/number_table.h"
#include "core/milling/identify/unit_label.h"
#include "core/units/number_scan.h"

namespace stillcut::identify {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

bool headerHas(const NumberTable& table, std::initializer_list<std::string_view> words) {
  for (const std::string& line : table.header) {
    const std::string text = lower(line);
    for (const std::string_view word : words) {
      if (text.find(word) != std::string::npos) return true;
    }
  }
  return false;
}

Status checkRising(const std::vector<double>& x, const std::string& where, const std::string& what) {
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!(x[i] > x[i - 1])) return Error{where, message("%1 does not rise at row %2", what, std::to_string(i + 1))};
  }
  return Done{};
}

// Bracketed words of a header line: "acc (g)" gives "g", "H [(m/s^2)/N]" gives "(m/s^2)/N".
std::vector<std::string> bracketed(std::string_view line) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '[' && line[i] != '(') continue;
    const char open = line[i];
    const char close = open == '[' ? ']' : ')';
    int depth = 1;
    std::size_t end = i + 1;
    while (end < line.size() && depth > 0) {
      if (line[end] == open) ++depth;
      if (line[end] == close) --depth;
      ++end;
    }
    if (depth > 0) break;
    out.emplace_back(line.substr(i + 1, end - i - 2));
    i = end - 1;
  }
  return out;
}

Result<Measurement> frfFromTable(NumberTable table, const std::string& where, const ImportOptions& options) {
  Measurement measured;
  if (headerHas(table, {"phase", "magnitude"})) {
    return Error{where, message("holds magnitude and phase"), message("export real and imaginary parts")};
  }
  Status rising = checkRising(table.columns[0], where, "the frequency");
  if (!rising) return rising.error();
  if (table.columns[0].front() < 0.0) return Error{where, message("holds negative frequencies")};
  Frf frf;
  double factor = 1.0;
  bool known = false;
  for (const std::string& line : table.header) {
    for (const std::string& label : bracketed(line)) {
      const auto unit = frfUnit(label);
      if (!unit) continue;
      known = true;
      frf.quantity = unit->quantity;
      factor = unit->factor;
    }
  }
  if (!known && !options.quantity) measured.remarks.emplace_back("no unit in the file: taken as compliance in m/N");
  frf.quantity = options.quantity.value_or(frf.quantity);
  factor = options.scale.value_or(factor);
  frf.source = where;
  frf.value.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    frf.value.emplace_back(factor * table.columns[1][i], factor * table.columns[2][i]);
  }
  frf.frequency = std::move(table.columns[0]);
  measured.data = std::move(frf);
  return measured;
}

Result<double> rateOf(const std::vector<double>& time, const std::string& where) {
  Status rising = checkRising(time, where, "the time");
  if (!rising) return rising.error();
  const double step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (std::abs(time[i] - time[i - 1] - step) > 0.5 * step) {
      return Error{where, message("the time steps are uneven at row %1", std::to_string(i + 1)),
                   message("samples are missing")};
    }
  }
  return 1.0 / step;
}

Result<Measurement> hammerFromTable(NumberTable table, const std::string& where, const ImportOptions& options) {
  Measurement measured;
  auto rate = rateOf(table.columns[0], where);
  if (!rate) return rate.error();
  std::size_t force = 1;
  double factor = 1.0;
  for (const std::string& line : table.header) {
    const std::string text = lower(line);
    const std::size_t response = std::min(text.find("acc"), text.find("response"));
    const std::size_t hammer = std::min(text.find("force"), text.find("hammer"));
    if (hammer != std::string::npos && response != std::string::npos && response < hammer) force = 2;
    for (const std::string& label : bracketed(line)) {
      const auto unit = responseUnit(label);
      if (unit && unit->quantity == FrfQuantity::Accelerance) factor = unit->factor;
    }
  }
  if (force == 2) measured.remarks.emplace_back("by its header, column 3 is the force");
  HammerRecord record;
  record.rate = *rate;
  record.source = where;
  record.force = std::move(table.columns[force]);
  record.response = std::move(table.columns[3 - force]);
  factor = options.scale.value_or(factor);
  for (double& v : record.response) v *= factor;
  measured.data = std::move(record);
  return measured;
}

bool looksLikeTime(const NumberTable& table) {
  const bool time = headerHas(table, {"time", "sec"});
  const bool frequency = headerHas(table, {"freq", "hz"});
  if (time != frequency) return time;
  const auto& x = table.columns[0];
  return (x.back() - x.front()) / static_cast<double>(x.size() - 1) < 5e-3;
}

bool isUnset(const std::string& unit) {
  return unit.empty() || lower(unit) == "none";
}

std::optional<FrfQuantity> quantityOf(uff::Uff58Quantity quantity) {
  if (quantity == uff::Uff58Quantity::Displacement) return FrfQuantity::Compliance;
  if (quantity == uff::Uff58Quantity::Velocity) return FrfQuantity::Mobility;
  if (quantity == uff::Uff58Quantity::Acceleration) return FrfQuantity::Accelerance;
  return std::nullopt;
}

// Quantity and factor of a universal file's FRF: from the units first, from the data types second.
Result<ResponseUnit> unitOf(const uff::Uff58Dataset& set, const std::string& where, Measurement& measured) {
  if (const auto whole = frfUnit(set.ordinate.unit)) return *whole;
  const auto byType = quantityOf(set.ordinate.quantity);
  ResponseUnit unit;
  if (const auto response = responseUnit(set.ordinate.unit)) {
    unit = *response;
  } else if (!isUnset(set.ordinate.unit)) {
    return Error{where, message("unit '%1' is not known", uff::printable(set.ordinate.unit)),
                 message("give quantity and scale")};
  } else if (byType) {
    unit.quantity = *byType;
    measured.remarks.emplace_back("no unit in the file: taken as SI");
  } else {
    measured.remarks.emplace_back("no quantity in the file: taken as compliance in m/N");
  }
  if (isUnset(set.denominator.unit)) return unit;
  const auto force = forceUnit(set.denominator.unit);
  if (!force) return Error{where, message("force unit '%1' is not known", uff::printable(set.denominator.unit))};
  unit.factor /= *force;
  return unit;
}

Result<Measurement> frfFromUff(const uff::Uff58Dataset& set, const std::string& where, const ImportOptions& options) {
  Measurement measured;
  if (!set.complex) return Error{where, message("its frequency response is real"), message("a complex one is needed")};
  Status rising = checkRising(set.x, where, "the frequency");
  if (!rising) return rising.error();
  if (set.x.front() < 0.0) return Error{where, message("holds negative frequencies")};
  ResponseUnit unit{options.quantity.value_or(FrfQuantity::Compliance), options.scale.value_or(1.0)};
  if (!options.quantity || !options.scale) {
    auto found = unitOf(set, where, measured);
    if (!found && !options.quantity) return found.error();
    if (found) {
      unit.quantity = options.quantity.value_or(found->quantity);
      unit.factor = options.scale.value_or(found->factor);
    }
  }
  Frf frf;
  frf.quantity = unit.quantity;
  frf.frequency = set.x;
  frf.value = set.y;
  for (auto& v : frf.value) v *= unit.factor;
  frf.source = where;
  measured.data = std::move(frf);
  return measured;
}

bool isForce(uff::Uff58Quantity quantity) {
  return quantity == uff::Uff58Quantity::ExcitationForce || quantity == uff::Uff58Quantity::ReactionForce;
}

Result<Measurement> hammerFromUff(const std::vector<uff::Uff58Dataset>& sets, const std::string& where,
                                  const ImportOptions& options) {
  const uff::Uff58Dataset* force = nullptr;
  const uff::Uff58Dataset* response = nullptr;
  for (const uff::Uff58Dataset& set : sets) {
    if (set.function != uff::Uff58Function::TimeResponse) continue;
    if (!force && isForce(set.ordinate.quantity)) force = &set;
    if (!response && set.ordinate.quantity == uff::Uff58Quantity::Acceleration) response = &set;
  }
  if (!force || !response) {
    return Error{where, message("holds neither a frequency response nor force and acceleration")};
  }
  if (force->x.size() != response->x.size() || force->x.size() < 2) {
    return Error{where, message("force and acceleration differ in length")};
  }
  auto rate = rateOf(force->x, where);
  if (!rate) return rate.error();
  HammerRecord record;
  record.rate = *rate;
  record.source = where;
  const double forceFactor = forceUnit(force->ordinate.unit).value_or(1.0);
  const auto unit = responseUnit(response->ordinate.unit);
  const double factor = options.scale.value_or(unit ? unit->factor : 1.0);
  for (std::size_t i = 0; i < force->y.size(); ++i) {
    record.force.push_back(forceFactor * force->y[i].real());
    record.response.push_back(factor * response->y[i].real());
  }
  Measurement measured;
  measured.data = std::move(record);
  return measured;
}

Result<Measurement> fromUff(std::string_view bytes, const std::string& where, const ImportOptions& options) {
  auto sets = uff::parseUff58(bytes, where);
  if (!sets) return sets.error();
  std::vector<const uff::Uff58Dataset*> responses;
  for (const uff::Uff58Dataset& set : *sets) {
    if (set.function == uff::Uff58Function::FrequencyResponse) responses.push_back(&set);
  }
  if (options.kind == MeasurementKind::Hammer || (options.kind == MeasurementKind::Automatic && responses.empty())) {
    return hammerFromUff(*sets, where, options);
  }
  if (options.dataset >= responses.size()) {
    return Error{where, message("holds %1 frequency responses", std::to_string(responses.size())),
                 message("number %1 (from 0) was asked for", std::to_string(options.dataset))};
  }
  auto measured = frfFromUff(*responses[options.dataset], where, options);
  if (measured && responses.size() > 1) {
    measured->remarks.push_back("frequency response " + std::to_string(options.dataset + 1) + " of " +
                                std::to_string(responses.size()) + " in the file");
  }
  return measured;
}

}  // namespace

Result<Measurement> parseMeasurement(std::string_view bytes, const std::string& where, const ImportOptions& options) {
  if (options.scale && !(std::isfinite(*options.scale) && *options.scale != 0.0)) {
    return Error{where, message("the scale is not a number other than 0")};
  }
  if (uff::looksLikeUff(bytes)) return fromUff(bytes, where, options);
  auto table = parseNumberTable(bytes, where, 3);
  if (!table) return table.error();
  const bool hammer =
      options.kind == MeasurementKind::Hammer || (options.kind == MeasurementKind::Automatic && looksLikeTime(*table));
  return hammer ? hammerFromTable(std::move(*table), where, options) : frfFromTable(std::move(*table), where, options);
}

Result<Measurement> importMeasurement(const std::string& path, const ImportOptions& options) {
  auto bytes = readFileBytes(path);
  if (!bytes) return bytes.error();
  return parseMeasurement(*bytes, path, options);
}

}  // namespace stillcut::identify
