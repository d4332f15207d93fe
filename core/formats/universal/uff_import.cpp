#include "core/formats/universal/uff_import.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/formats/column_reader.h"
#include "core/formats/universal/uff58_cursor.h"
#include "core/formats/variable_channels.h"

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

bool isTimeResponse(const Uff58Header& header) {
  return header.function == uff::Uff58Function::TimeResponse ||
         (header.function == uff::Uff58Function::General && header.abscissa.quantity == Uff58Quantity::Time);
}

// The step is written with six digits: a whole number of hertz within half of the last one is meant.
double rateOf(double increment) {
  const double unit = std::pow(10.0, std::floor(std::log10(increment)) - 5.0);
  return wholeRate(1.0 / increment, 0.5 * unit / increment);
}

Status checkPoints(Uff58Cursor& cursor) {
  std::array<uff::Uff58Point, 256> points;
  while (true) {
    const Result<std::size_t> got = cursor.read(points);
    if (!got) return got.error();
    if (*got == 0) return cursor.finish();
  }
}

Status checkChannel(const Uff58Cursor::Place& place, const RecordingFormat& format, const std::string& path) {
  const Uff58Header& header = place.header;
  const std::string where = path + ": dataset " + std::to_string(place.dataset);
  if (!header.even) return Error{where, message("its samples are not evenly spaced in time")};
  if (format.frames == 0) return Done{};
  if (static_cast<std::int64_t>(header.points) != format.frames) {
    return Error{
        where, message("has %1 samples, those before %2", std::to_string(header.points), std::to_string(format.frames)),
        message("channels of one recording are of one length")};
  }
  if (rateOf(header.increment) != format.rate.value)
    return Error{where, message("has another sampling rate than those before")};
  return Done{};
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openUff(const std::string& path, const ReadOptions& options) {
  Result<uff::ByteWindow> window = uff::ByteWindow::open(path);
  if (!window) return window.error();
  Uff58Cursor cursor(std::move(*window), path);
  RecordingFormat format;
  format.kind = "universal file, dataset 58";
  std::vector<ColumnChannel> all;
  while (true) {
    const Result<bool> more = cursor.next();
    if (!more) return more.error();
    if (!*more) break;
    const Uff58Cursor::Place place = cursor.place();
    if (const Status s = checkPoints(cursor); !s) return s.error();
    RecordedChannel channel = channelOf(place.header, place.dataset);
    if (!isTimeResponse(place.header)) {
      format.skipped.push_back(channel.info.name);
      continue;
    }
    if (const Status s = checkChannel(place, format, path); !s) return s.error();
    format.frames = static_cast<std::int64_t>(place.header.points);
    format.rate = Hertz(rateOf(place.header.increment));
    all.push_back({std::move(channel), [path, place]() -> Result<std::unique_ptr<Column>> {
                     Result<uff::ByteWindow> own = uff::ByteWindow::open(path);
                     if (!own) return own.error();
                     return std::unique_ptr<Column>(new UffColumn(std::move(*own), path, place));
                   }});
    constexpr std::size_t kMostDatasets = 4096;
    if (all.size() > kMostDatasets) return Error{path, message("holds more than 4096 channels")};
  }
  if (all.empty()) {
    const Message others = message("%1 datasets 58 hold other functions", format.skipped.size());
    return Error{path, message("holds no time recording"),
                 format.skipped.empty() ? message("no dataset 58 in it") : others};
  }
  return openColumns(path, std::move(format), std::move(all), options);
}

}  // namespace stillcut::record
