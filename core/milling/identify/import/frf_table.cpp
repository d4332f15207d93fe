#include "core/milling/identify/import/frf_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/base/units.h"
#include "core/milling/identify/import/direct_responses.h"
#include "core/milling/identify/import/frf_columns.h"
#include "core/milling/identify/import/table_header.h"
#include "core/units/number_scan.h"
#include "core/units/unit_names.h"

namespace stillcut::identify {
namespace {

using R = ColumnRole;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);
// Frequencies of a tap test that end below this are no hertz.
constexpr double kLowestEnd = 100.0;

// The columns of one response.
struct Columns {
  std::string name;
  Axis along = Axis::Unknown, force = Axis::Unknown;
  std::size_t real = kNone, imaginary = kNone, magnitude = kNone, phase = kNone, coherence = kNone;

  bool cartesian() const { return real != kNone && imaginary != kNone; }
  bool complete() const { return cartesian() || (magnitude != kNone && phase != kNone); }
};

std::string lowered(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// False where the response has such a column already.
bool place(std::size_t column, ColumnRole role, Columns& of) {
  const auto take = [column](std::size_t& member) {
    if (member != kNone) return false;
    member = column;
    return true;
  };
  if (role == R::Complex) return of.imaginary == kNone && take(of.real) && take(of.imaginary);
  if (role == R::Real) return take(of.real);
  if (role == R::Imaginary) return take(of.imaginary);
  if (role == R::Magnitude) return take(of.magnitude);
  if (role == R::Phase) return take(of.phase);
  return take(of.coherence);
}

// Several of one name are numbered.
void nameAlike(std::vector<Columns>& all) {
  std::map<std::string, int> seen;
  for (const Columns& r : all) ++seen[r.name];
  std::map<std::string, int> number;
  for (Columns& r : all) {
    if (seen[r.name] < 2) continue;
    const std::string count = std::to_string(++number[r.name]);
    r.name += (r.name.empty() ? "" : " ") + count;
  }
}

std::vector<Columns> responsesIn(const std::vector<ColumnMeaning>& meanings) {
  std::vector<Columns> all;
  for (std::size_t c = 0; c < meanings.size(); ++c) {
    const ColumnMeaning& m = meanings[c];
    if (m.role == R::Unknown || m.role == R::RowNumber || m.role == R::Frequency) continue;
    const bool placed =
        std::any_of(all.begin(), all.end(), [&](Columns& r) { return r.name == m.response && place(c, m.role, r); });
    if (placed) continue;
    all.push_back({m.response, m.along, m.force});
    place(c, m.role, all.back());
  }
  // A coherence without the name of its response belongs to the only one there is.
  std::size_t coherence = kNone;
  for (const Columns& r : all) coherence = !r.complete() && r.coherence != kNone ? r.coherence : coherence;
  std::erase_if(all, [](const Columns& r) { return !r.complete(); });
  if (all.size() == 1 && all[0].coherence == kNone) all[0].coherence = coherence;
  nameAlike(all);
  return all;
}

// Those that were named; whoever names one knows that it is along the hit, and where one axis is named too, along
// which.
Status keepNamed(std::vector<Columns>& responses, const ImportOptions& options, const std::string& where) {
  const std::vector<std::string>& names = options.responses;
  if (names.empty()) return Done{};
  std::string held;
  for (Columns& r : responses) {
    held += (held.empty() ? "'" : ", '") + r.name + "'";
    if (options.cross) continue;
    if (names.size() == 1 && options.axes.size() == 1) r.along = options.axes.front();
    r.force = r.along;
  }
  std::erase_if(responses, [&](const Columns& r) {
    return std::none_of(names.begin(), names.end(), [&](const std::string& n) { return lowered(n) == r.name; });
  });
  if (!responses.empty()) return Done{};
  return Error{where, message("holds no response '%1'", names.front()), message("it holds %1", held)};
}

// Two units over the parts of one number: at least one of them is wrong.
Status checkAlike(const NumberTable& table, const Columns& r, const std::string& where) {
  if (!r.cartesian()) return Done{};
  const std::string &re = table.columns[r.real].unit, &im = table.columns[r.imaginary].unit;
  const auto a = frfUnit(re), b = frfUnit(im);
  const bool alike = a && b ? a->quantity == b->quantity && a->factor == b->factor : re == im;
  if (alike || re.empty() || im.empty()) return Done{};
  return Error{
      where, message("its real part is in '%1' and its imaginary part in '%2'", uff::printable(re), uff::printable(im)),
      message("correct the header, or give the unit of both with --unit")};
}

// The unit over the columns of one response, else the header's, else the words behind the first row.
std::string labelOf(const NumberTable& table, const Columns& r) {
  for (const std::size_t c : {r.real, r.imaginary, r.magnitude}) {
    if (c != kNone && !table.columns[c].unit.empty()) return table.columns[c].unit;
  }
  std::string label = unitOfAxis(table, 'y');
  if (!label.empty()) return label;
  for (const std::string& word : table.remarks) {
    if (frfUnit(word)) return word;
  }
  for (const std::string& line : table.header) {
    LabelParts parts = splitLabel(line);
    if (frfUnit(parts.unit)) return std::move(parts.unit);
  }
  return "";
}

Result<std::vector<double>> frequenciesIn(const NumberTable& table, std::size_t column, const std::string& where,
                                          const ImportOptions& options, std::vector<Message>& remarks) {
  std::string label = !options.frequencyUnit.empty() ? options.frequencyUnit : table.columns[column].unit;
  if (label.empty()) label = unitOfAxis(table, 'x');
  for (const std::string& word : table.remarks) {
    if (label.empty() && frequencyUnit(word)) label = word;
  }
  const auto factor = frequencyUnit(label);
  if (!factor && !label.empty()) {
    return Error{where, message("the unit of its frequencies, '%1', is not known", uff::printable(label)),
                 message("give --frequency-unit Hz, kHz or rad/s")};
  }
  std::vector<double> f = table.columns[column].real;
  for (std::size_t i = 1; i < f.size(); ++i) {
    if (!(f[i] > f[i - 1]))
      return Error{where, message("the frequency does not rise at row %1", std::to_string(i + 1))};
  }
  if (f.front() < 0.0) return Error{where, message("holds negative frequencies")};
  const bool angular = table.columns[column].name.starts_with("omega");
  if (!factor && (angular || f.back() < kLowestEnd)) {
    return Error{where, message("does not say the unit of its frequencies, which end at %1", std::to_string(f.back())),
                 message("give --frequency-unit Hz, kHz or rad/s")};
  }
  if (!factor) remarks.push_back(message("the frequencies have no unit: read as Hz (--frequency-unit says otherwise)"));
  for (double& v : f) v *= factor.value_or(1.0);
  return f;
}

Result<double> angleFactor(const NumberTable& table, std::size_t column, const std::string& where,
                           const ImportOptions& options) {
  const std::string& label = !options.phaseUnit.empty() ? options.phaseUnit : table.columns[column].unit;
  if (const auto factor = angleUnit(label)) return *factor;
  const auto& phase = table.columns[column].real;
  const bool degrees = std::any_of(phase.begin(), phase.end(), [](double v) { return std::abs(v) > 20.0; });
  if (label.empty() && degrees) return kTwoPi / 360.0;
  return Error{where, message("does not say the unit of its phase"), message("give --phase-unit deg or rad")};
}

Result<std::vector<std::complex<double>>> valuesOf(const NumberTable& table, const Columns& r, const std::string& where,
                                                   const ImportOptions& options, bool decibels) {
  std::vector<std::complex<double>> values(table.rows());
  if (decibels && r.cartesian()) {
    return Error{where, message("real and imaginary part have no decibels"), message("correct the unit in its header")};
  }
  if (r.cartesian()) {
    const TableColumn& re = table.columns[r.real];
    const std::vector<double>& im = r.imaginary == r.real ? re.imaginary : table.columns[r.imaginary].real;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {re.real[i], im[i]};
    return values;
  }
  const auto factor = angleFactor(table, r.phase, where, options);
  if (!factor) return factor.error();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double said = table.columns[r.magnitude].real[i];
    if (said < 0.0 && !decibels) {
      return Error{where, message("its magnitudes fall below zero"),
                   message("if they are decibels, say of what: --unit \"dB re 1 m/N\"")};
    }
    const double size = decibels ? std::pow(10.0, said / 20.0) : said;
    values[i] = std::polar(size, *factor * table.columns[r.phase].real[i]);
  }
  return values;
}

Result<Frf> frfOf(const NumberTable& table, const Columns& r, const std::string& where, const ImportOptions& options) {
  if (options.unit.empty() && !options.scale) {
    if (const Status alike = checkAlike(table, r, where); !alike) return alike.error();
  }
  const auto unit = settleUnit(labelOf(table, r), where, options);
  if (!unit) return unit.error();
  auto values = valuesOf(table, r, where, options, unit->decibels);
  if (!values) return values.error();
  if (unit->inverse) {
    for (auto& v : *values) v = v == 0.0 ? 0.0 : 1.0 / v;
  }
  Frf frf;
  frf.quantity = unit->unit.quantity;
  frf.unitKnown = unit->known;
  frf.value = std::move(*values);
  for (auto& v : frf.value) v *= unit->unit.factor;
  if (r.coherence != kNone) frf.coherence = table.columns[r.coherence].real;
  frf.source = where;
  return frf;
}

}  // namespace

Result<SettledUnit> settleUnit(const std::string& label, const std::string& where, const ImportOptions& options) {
  SettledUnit settled;
  const std::string& said = options.unit.empty() ? label : options.unit;
  const auto logarithm = decibels(said);
  const bool given = options.quantity && options.scale;
  if (const auto unit = frfUnit(said)) {
    settled = {*unit, true, false, decibels(label).has_value()};
  } else if (const auto inverse = inverseFrfUnit(said)) {
    settled = {*inverse, true, true, false};
  } else if (logarithm && (logarithm->reference || given)) {
    settled = {logarithm->reference.value_or(ResponseUnit{}), true, false, true};
  } else if (logarithm) {
    return Error{where, message("its magnitudes are in decibels, and it does not say of what"),
                 message("give --unit, as --unit \"dB re 1 m/N\" or \"dB re 1e-6 m/N\"")};
  } else if (!said.empty() && !given) {
    return Error{where, message("unit '%1' is not known", uff::printable(said)),
                 message("give the unit of its response with --unit, as --unit m/N, um/N, (m/s^2)/N or g/N")};
  }
  settled.unit.quantity = options.quantity.value_or(settled.unit.quantity);
  settled.unit.factor = options.scale.value_or(settled.unit.factor);
  settled.known = settled.known || (options.scale && options.quantity);
  return settled;
}

Result<ImportedFrfs> frfsFromTable(const NumberTable& table, const std::string& where, const ImportOptions& options) {
  const std::vector<ColumnMeaning> meanings = meaningOfColumns(table);
  const auto frequency =
      std::find_if(meanings.begin(), meanings.end(), [](const ColumnMeaning& m) { return m.role == R::Frequency; });
  std::vector<Columns> responses = responsesIn(meanings);
  if (frequency == meanings.end() || responses.empty()) {
    return Error{where, message("its columns do not say which is frequency, real and imaginary part"),
                 message("name them in its first line: Frequency [Hz], Real [m/N], Imag [m/N]")};
  }
  if (const Status named = keepNamed(responses, options, where); !named) return named.error();
  ImportedFrfs imported;
  if (table.leftOut > 0) {
    imported.remarks.push_back(message("%1 rows without a finite value are left out", std::to_string(table.leftOut)));
  }
  const auto at = static_cast<std::size_t>(frequency - meanings.begin());
  const auto lines = frequenciesIn(table, at, where, options, imported.remarks);
  if (!lines) return lines.error();
  std::vector<OfferedResponse> offered;
  offered.reserve(responses.size());
  for (const Columns& r : responses) offered.push_back({r.name, r.along, r.force});
  const auto choice = options.cross ? chooseCross(offered, where)
                                    : chooseResponses(offered, options.axes, where, "--response", ForceAxis::Fixed);
  if (!choice) return choice.error();
  imported.remarks.insert(imported.remarks.end(), choice->remarks.begin(), choice->remarks.end());
  for (const ChosenResponse& chosen : choice->responses) {
    auto frf = frfOf(table, responses[chosen.offered], where, options);
    if (!frf) return frf.error();
    frf->frequency = *lines;
    frf->axis = chosen.axis;
    if (settleUnit(labelOf(table, responses[chosen.offered]), where, options)->inverse) {
      imported.remarks.push_back(message("force over response in the file: turned into response over force"));
    }
    imported.frfs.push_back(std::move(*frf));
  }
  return imported;
}

bool looksLikeFrfs(const NumberTable& table) {
  bool frequency = frequencyUnit(unitOfAxis(table, 'x')).has_value();
  bool time = false;
  for (const TableColumn& column : table.columns) {
    const auto unit = record::unitFromText(column.unit);
    time = time || (unit && unit->kind == record::UnitKind::Time) ||
           record::meaningOfName(column.name) == record::NameMeaning::Time;
    const ColumnRole role = meaningOfColumn(column).role;
    frequency = frequency || (role != R::Unknown && role != R::RowNumber);
  }
  for (const std::string& word : table.remarks) frequency = frequency || frequencyUnit(word) || frfUnit(word);
  if (time != frequency) return frequency;
  const auto& x = table.columns[0].real;
  return (x.back() - x.front()) / static_cast<double>(x.size() - 1) >= 5e-3;
}

}  // namespace stillcut::identify
