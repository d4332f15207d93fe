#include "core/formats/universal/uff_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/formats/column_reader.h"
#include "core/formats/universal/uff58_cursor.h"
#include "core/formats/universal/uff_date.h"
#include "core/formats/variable_channels.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

using uff::Uff58Cursor;
using uff::Uff58Header;
using uff::Uff58Quantity;

class UffColumn final : public Column {
 public:
  UffColumn(uff::ByteWindow window, const std::string& where, const Uff58Cursor::Place& place)
      : cursor_(std::move(window), where), where_(where) {
    cursor_.go(place);
  }

  Status read(std::span<double> out) override {
    std::array<uff::Uff58Point, 256> points;
    for (std::size_t done = 0; done < out.size();) {
      const std::size_t ask = std::min(points.size(), out.size() - done);
      const Result<std::size_t> got = cursor_.read(std::span(points).first(ask));
      if (!got) return got.error();
      if (*got == 0) return Error{where_, message("ends early"), message("it has changed since it was opened")};
      for (std::size_t i = 0; i < *got; ++i) out[done++] = points[i].y.real();
    }
    return Done{};
  }

 private:
  Uff58Cursor cursor_;
  std::string where_;
};

const char* unitOfQuantity(Uff58Quantity quantity) {
  switch (quantity) {
    case Uff58Quantity::Displacement:
      return "m";
    case Uff58Quantity::Velocity:
      return "m/s";
    case Uff58Quantity::Acceleration:
      return "m/s2";
    case Uff58Quantity::ReactionForce:
    case Uff58Quantity::ExcitationForce:
      return "N";
    case Uff58Quantity::Pressure:
      return "Pa";
    default:
      return "";
  }
}

bool isUnset(const std::string& text) {
  return text.empty() || text == "NONE" || text == "none";
}

// The whole name stands in the first line of identification where the short field was too short for it.
std::string nameOf(const Uff58Header& header, int dataset) {
  const std::string& name = header.responseName;
  if (isUnset(name)) return isUnset(header.id[0]) ? "dataset " + std::to_string(dataset) : header.id[0];
  return header.id[0].starts_with(name) ? header.id[0] : name;
}

RecordedChannel channelOf(const Uff58Header& header, int dataset) {
  const std::string& unit = header.ordinate.unit;
  RecordedChannel channel = channelFromWords(
      cleanName(nameOf(header, dataset)), isUnset(unit) ? unitOfQuantity(header.ordinate.quantity) : cleanName(unit));
  constexpr std::array<const char*, 4> kAxes{"", "x", "y", "z"};
  const int direction = std::abs(header.responseDirection);
  if (channel.info.axis.empty() && direction < 4) channel.info.axis = kAxes[static_cast<std::size_t>(direction)];
  return channel;
}

// Some programs call whatever they write a time response: frequencies below it say what it is.
bool isTimeResponse(const Uff58Header& header) {
  const bool overTime = header.abscissa.quantity != Uff58Quantity::Frequency;
  return (header.function == uff::Uff58Function::TimeResponse && overTime) ||
         (header.function == uff::Uff58Function::General && header.abscissa.quantity == Uff58Quantity::Time);
}

bool isFrequencyResponse(const Uff58Header& header) {
  return header.function == uff::Uff58Function::FrequencyResponse ||
         header.function == uff::Uff58Function::Transmissibility;
}

// What it holds, where that is no time response.
Message functionOf(const Uff58Header& header) {
  if (isFrequencyResponse(header)) return message("a frequency response");
  switch (header.function) {
    case uff::Uff58Function::AutoSpectrum:
    case uff::Uff58Function::CrossSpectrum:
    case uff::Uff58Function::PowerSpectralDensity:
    case uff::Uff58Function::Spectrum:
      return message("a spectrum");
    case uff::Uff58Function::Coherence:
      return message("a coherence");
    default:
      return header.abscissa.quantity == Uff58Quantity::Frequency
                 ? message("a spectrum")
                 : message("a function of type %1", std::to_string(static_cast<int>(header.function)));
  }
}

// One unit of the last digit of a number written with six.
double lastDigit(double value) {
  return value == 0.0 ? 0.0 : std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5.0);
}

// Of an abscissa: seconds per unit of it.
double secondsPerUnit(const Uff58Header& header) {
  const std::optional<UnitMeaning> unit = unitFromText(header.abscissa.unit);
  return unit && unit->kind == UnitKind::Time ? unit->toSi : 1.0;
}

// The step is written with six digits: a whole number of hertz within half of the last one is meant.
double rateOf(double increment) {
  return wholeRate(1.0 / increment, 0.5 * lastDigit(increment) / increment);
}

// Reads every point of the dataset at hand; `visit` gets each abscissa.
template <class Visit>
Status readPoints(Uff58Cursor& cursor, Visit visit) {
  std::array<uff::Uff58Point, 256> points;
  while (true) {
    const Result<std::size_t> got = cursor.read(points);
    if (!got) return got.error();
    if (*got == 0) return cursor.finish();
    for (std::size_t i = 0; i < *got; ++i) visit(points[i].x);
  }
}

// One time response.
struct UffChannel {
  RecordedChannel channel;
  Uff58Cursor::Place place;
  double rate = 0.0;  // [Hz]
  std::int64_t frames() const { return static_cast<std::int64_t>(place.header.points); }
  std::string size() const {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%lld x %.6g Hz", static_cast<long long>(frames()), rate);
    return text.data();
  }
};

// Written abscissae have as few digits as their writer gave them: each may be off by one of the last of six, and by
// half a step for the clock's own jitter. Whatever lies further off is a gap, which this format cannot tell.
Result<double> rateOfAbscissae(const std::string& path, const Uff58Cursor::Place& place, double first, double last) {
  const std::string where = path + ": dataset " + std::to_string(place.dataset);
  const auto steps = static_cast<double>(place.header.points) - 1.0;
  const double step = (last - first) / steps;
  if (!(step > 0.0)) return Error{where, message("its times do not grow")};
  Result<uff::ByteWindow> window = uff::ByteWindow::open(path);
  if (!window) return window.error();
  Uff58Cursor cursor(std::move(*window), path);
  cursor.go(place);
  double at = first;
  bool even = true;
  const Status read = readPoints(cursor, [&](double x) {
    even = even && std::abs(x - at) <= 0.5 * step + lastDigit(x);
    at += step;
  });
  if (!read) return read.error();
  if (!even) return Error{where, message("its samples are not evenly spaced in time")};
  const double toSeconds = secondsPerUnit(place.header);
  const double relative = lastDigit(std::max(std::abs(first), std::abs(last))) / (last - first);
  return wholeRate(1.0 / (step * toSeconds), relative);
}

// What else than time responses a file holds.
struct OtherFunctions {
  std::vector<std::pair<std::string, Message>> all;  // name, what it is
  bool anyResponse = false;                          // one over frequency
};

// Every time response of the file, each read to its end.
Result<std::vector<UffChannel>> listChannels(const std::string& path, OtherFunctions& others) {
  Result<uff::ByteWindow> window = uff::ByteWindow::open(path);
  if (!window) return window.error();
  Uff58Cursor cursor(std::move(*window), path);
  std::vector<UffChannel> all;
  while (true) {
    const Result<bool> more = cursor.next();
    if (!more) return more.error();
    if (!*more) return all;
    UffChannel found{channelOf(cursor.header(), cursor.place().dataset), cursor.place()};
    double first = NAN;
    double last = NAN;
    const Status read = readPoints(cursor, [&](double x) {
      if (std::isnan(first)) first = x;
      last = x;
    });
    if (!read) return read.error();
    const Uff58Header& header = found.place.header;
    if (!isTimeResponse(header)) {
      others.all.emplace_back(found.channel.info.name, functionOf(header));
      others.anyResponse = others.anyResponse || isFrequencyResponse(header);
      continue;
    }
    found.rate = rateOf(header.increment * secondsPerUnit(header));
    if (!header.even) {
      const Result<double> rate = rateOfAbscissae(path, found.place, first, last);
      if (!rate) return rate.error();
      found.rate = *rate;
    }
    all.push_back(std::move(found));
    constexpr std::size_t kMostDatasets = 4096;
    if (all.size() > kMostDatasets) return Error{path, message("holds more than 4096 channels")};
  }
}

// Channels of one length and one rate are one recording: of several the one that holds most numbers is taken.
const UffChannel& mostNumbers(const std::vector<UffChannel>& all) {
  const UffChannel* best = nullptr;
  std::int64_t most = 0;
  for (const UffChannel& one : all) {
    std::int64_t numbers = 0;
    for (const UffChannel& other : all) {
      if (other.frames() == one.frames() && other.rate == one.rate) numbers += other.frames();
    }
    if (numbers <= most) continue;
    most = numbers;
    best = &one;
  }
  return *best;
}

Error noRecording(const std::string& path, const OtherFunctions& others) {
  if (others.all.empty()) return {path, message("holds no time recording"), message("no dataset 58 in it")};
  return {path, message("is no recording: it holds %1", others.all.front().second),
          others.anyResponse ? message("'stillcut-cli modal' and the page Tap test read it")
                             : message("export the samples over time that it was made of")};
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openUff(const std::string& path, const ReadOptions& options) {
  RecordingFormat format;
  format.kind = "universal file, dataset 58";
  OtherFunctions others;
  Result<std::vector<UffChannel>> found = listChannels(path, others);
  if (!found) return found.error();
  if (found->empty()) return noRecording(path, others);
  for (auto& [name, what] : others.all) leaveOut(format, std::move(name), message("it holds %1", what));
  const UffChannel& chosen = mostNumbers(*found);
  format.frames = chosen.frames();
  format.rate = Hertz(chosen.rate);
  format.started_ns = uff::madeAt(chosen.place.header.id[2]).value_or(0);
  std::vector<ColumnChannel> all;
  for (const UffChannel& one : *found) {
    if (one.frames() != chosen.frames() || one.rate != chosen.rate) {
      leaveOut(format, one.channel.info.name, message("it has another rate or length"));
      format.notes.push_back(
          message("channel '%1' is left out: %2 beside %3", one.channel.info.name, one.size(), chosen.size()));
      continue;
    }
    all.push_back({one.channel, [path, place = one.place]() -> Result<std::unique_ptr<Column>> {
                     Result<uff::ByteWindow> own = uff::ByteWindow::open(path);
                     if (!own) return own.error();
                     return std::unique_ptr<Column>(new UffColumn(std::move(*own), path, place));
                   }});
  }
  return openColumns(path, std::move(format), std::move(all), options);
}

}  // namespace stillcut::record
