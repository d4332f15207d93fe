// Universal files: one dataset 58 a channel. ".uff" is binary (58b, single precision, little endian), ".unv" is text
// (double precision); every sample's place is known, so one pass over the recording writes all of them.
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>

#include "core/formats/recording_sink.h"
#include "core/formats/universal/uff58.h"
#include "core/formats/utf_text.h"
#include "core/storage/part_file.h"

namespace stillcut::record {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are written as they lie in memory");

constexpr std::uint64_t kCell = 20;             // E20.12
constexpr std::uint64_t kLine = 4 * kCell + 1;  // four cells and a line end

uff::Uff58Header headerOf(const RecordedChannel& channel, const ExportPlan& plan, bool text) {
  using Q = uff::Uff58Quantity;
  constexpr std::array<Q, 7> kQuantities{Q::Acceleration,    Q::Velocity, Q::Displacement, Q::Pressure,
                                         Q::ExcitationForce, Q::General,  Q::General};
  uff::Uff58Header header;
  constexpr std::size_t kIdentification = 80, kResponseName = 10;  // columns of the format
  header.id[0] = cutUtf8(channel.info.name, kIdentification);
  header.function = uff::Uff58Function::TimeResponse;
  header.responseName = cutUtf8(channel.info.name, kResponseName);
  const std::size_t axis = std::string("xyz").find(channel.info.axis);
  if (channel.info.axis.size() == 1 && axis != std::string::npos) header.responseDirection = static_cast<int>(axis) + 1;
  header.doublePrecision = text;
  header.points = static_cast<std::uint64_t>(plan.frames);
  header.increment = 1.0 / plan.rate.value;
  header.abscissa = {Q::Time, "Time", "s"};
  header.ordinate = {channel.quantityKnown ? kQuantities[static_cast<std::size_t>(channel.info.quantity)] : Q::Unknown,
                     channel.quantityKnown ? std::string(name(channel.info.quantity)) : "", plainUnit(channel)};
  return header;
}

class UffSink final : public RecordingSink {
 public:
  UffSink(const std::string& path, const ExportPlan& plan, bool text) : file_(path), plan_(plan), text_(text) {}

  bool opened() const { return file_.opened(); }
  Error failure() const { return file_.failure(); }

  void header() {
    const auto frames = static_cast<std::uint64_t>(plan_.frames);
    const std::uint64_t textBytes = frames / 4 * kLine + (frames % 4 == 0 ? 0 : frames % 4 * kCell + 1);
    const std::string tail = text_ ? "    -1\n" : "\n    -1\n";
    std::uint64_t at = 0;
    for (const RecordedChannel& channel : plan_.channels) {
      const auto form = text_ ? uff::Uff58Form::Ascii : uff::Uff58Form::LittleEndian;
      const std::string head = formatUff58Head(headerOf(channel, plan_, text_), form);
      file_.writeAt(at, head);
      at += head.size();
      begins_.push_back(at);
      at += text_ ? textBytes : frames * 4;
      file_.writeAt(at, tail);
      at += tail.size();
    }
  }

  Status write(const SampleBlock& block) override {
    for (std::size_t c = 0; c < begins_.size(); ++c) {
      bytes_.clear();
      for (int f = 0; f < block.frames; ++f) {
        const double value = plan_.channels[c].info.scale *
                             static_cast<double>(block.channel(static_cast<int>(c))[static_cast<std::size_t>(f)]);
        text_ ? addCell(value, written_ + static_cast<std::uint64_t>(f)) : addFloat(static_cast<float>(value));
      }
      const std::uint64_t before = text_ ? written_ / 4 * kLine + written_ % 4 * kCell : written_ * 4;
      file_.writeAt(begins_[c] + before, bytes_);
    }
    written_ += static_cast<std::uint64_t>(block.frames);
    return Done{};
  }

  Status finish() override { return file_.finish(); }

 private:
  void addFloat(float value) {
    std::array<char, 4> raw{};
    std::memcpy(raw.data(), &value, raw.size());
    bytes_.append(raw.data(), raw.size());
  }
  void addCell(double value, std::uint64_t frame) {
    std::array<char, 32> cell{};
    std::snprintf(cell.data(), cell.size(), "%20.12E", value);
    bytes_ += cell.data();
    if (frame % 4 == 3 || frame + 1 == static_cast<std::uint64_t>(plan_.frames)) bytes_ += '\n';
  }

  PartFile file_;
  ExportPlan plan_;
  bool text_;
  std::vector<std::uint64_t> begins_;
  std::uint64_t written_ = 0;  // frames
  std::string bytes_;
};

}  // namespace

Result<std::unique_ptr<RecordingSink>> createUffSink(const std::string& path, const ExportPlan& plan) {
  const bool text = std::filesystem::path(path).extension() == ".unv";
  constexpr std::int64_t kMostPoints = 9'999'999'999;  // ten columns
  if (plan.frames > kMostPoints)
    return Error{path, message("cannot be written: too many samples for this format"), message("use .h5")};
  auto sink = std::make_unique<UffSink>(path, plan, text);
  if (!sink->opened()) return sink->failure();
  sink->header();
  return std::unique_ptr<RecordingSink>(std::move(sink));
}

}  // namespace stillcut::record
