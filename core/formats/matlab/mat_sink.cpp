// MATLAB version 5, written in one pass over the recording: the number of frames is known, so the place of every sample
// is, and matio, which wants whole arrays in memory, is not needed. Source: MAT-File Format, The MathWorks, chapter 1.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <set>

#include "core/formats/recording_sink.h"
#include "core/formats/utf_text.h"
#include "core/storage/part_file.h"

namespace stillcut::record {
namespace {

constexpr std::uint32_t kInt8 = 1, kInt32 = 5, kUint32 = 6, kDouble = 9, kMatrix = 14,
                        kUtf16 = 17;  // element types
constexpr std::uint32_t kCharClass = 4, kDoubleClass = 6;
constexpr std::uint64_t kLargest = 0x7fffff00;  // of one variable, in MATLAB of this version [bytes]

void put32(std::string& out, std::uint32_t value) {
  char bytes[4];
  std::memcpy(bytes, &value, 4);
  out.append(bytes, 4);
}

void pad(std::string& out) {
  out.resize((out.size() + 7) / 8 * 8, '\0');
}

// A matrix up to the first byte of its numbers; `bytes` of them follow, padded to eight.
std::string matrixHead(const std::string& name, std::uint32_t kind, std::uint32_t rows, std::uint32_t columns,
                       std::uint32_t type, std::uint32_t bytes) {
  std::string body;
  for (const std::uint32_t v : {kUint32, 8U, kind, 0U, kInt32, 8U, rows, columns}) put32(body, v);
  put32(body, kInt8);
  put32(body, static_cast<std::uint32_t>(name.size()));
  body += name;
  pad(body);
  put32(body, type);
  put32(body, bytes);
  std::string head;
  put32(head, kMatrix);
  put32(head, static_cast<std::uint32_t>(body.size()) + (bytes + 7) / 8 * 8);
  return head + body;
}

std::string numberMatrix(const std::string& name, std::uint32_t rows, const std::vector<double>& values) {
  const auto bytes = static_cast<std::uint32_t>(values.size() * sizeof(double));
  std::string out =
      matrixHead(name, kDoubleClass, rows, static_cast<std::uint32_t>(values.size()) / rows, kDouble, bytes);
  out.append(reinterpret_cast<const char*>(values.data()), bytes);
  return out;
}

std::string textMatrix(const std::string& name, const std::string& utf8) {
  // A pair of halves is two letters for MATLAB and one for others (SciPy), which then refuse the whole file.
  std::vector<std::uint16_t> letters;
  for (const std::uint16_t unit : toUtf16(utf8)) {
    const bool highHalf = unit >= 0xD800 && unit < 0xDC00, lowHalf = unit >= 0xDC00 && unit < 0xE000;
    if (!lowHalf) letters.push_back(highHalf ? '?' : unit);
  }
  const auto bytes = static_cast<std::uint32_t>(letters.size() * 2);
  const auto columns = static_cast<std::uint32_t>(letters.size());
  std::string out = matrixHead(name, kCharClass, 1, columns, kUtf16, bytes);
  out.append(reinterpret_cast<const char*>(letters.data()), bytes);
  pad(out);
  return out;
}

// What stands beside a channel under its name with these endings.
constexpr std::array<const char*, 5> kBeside{"", "_name", "_unit", "_quantity", "_axis"};

// A name MATLAB takes, different from those before it and what is beside them.
std::string variableName(const std::string& name, std::set<std::string>& taken) {
  constexpr std::size_t kLongest = 48;
  std::string plain;
  for (const char c : name) plain += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  if (plain.empty() || std::isalpha(static_cast<unsigned char>(plain[0])) == 0) plain = "ch_" + plain;
  plain.resize(std::min(plain.size(), kLongest));
  const auto isTaken = [&taken](const std::string& candidate) {
    return std::any_of(kBeside.begin(), kBeside.end(), [&](const char* by) { return taken.contains(candidate + by); });
  };
  std::string unique = plain;
  for (int n = 2; isTaken(unique); ++n) unique = plain + "_" + std::to_string(n);
  for (const char* by : kBeside) taken.insert(unique + by);
  return unique;
}

class MatSink final : public RecordingSink {
 public:
  MatSink(const std::string& path, const ExportPlan& plan) : file_(path), plan_(plan) {}

  bool opened() const { return file_.opened(); }
  Error failure() const { return file_.failure(); }

  void header() {
    std::string out = "MATLAB 5.0 MAT-file, written by Stillcut";
    out.resize(124, ' ');
    std::fill(out.begin() + 116, out.end(), '\0');
    out += std::string("\x00\x01IM", 4);
    out += numberMatrix("rate_hz", 1, {plan_.rate.value});
    std::set<std::string> taken{"rate_hz", "gaps", "t", "time"};
    std::vector<std::string> names;
    for (const RecordedChannel& channel : plan_.channels) {
      const std::string name = variableName(channel.info.name, taken);
      names.push_back(name);
      out += textMatrix(name + "_name", channel.info.name);
      out += textMatrix(name + "_unit", plainUnit(channel));
      if (channel.quantityKnown)
        out += textMatrix(name + "_quantity", std::string(stillcut::name(channel.info.quantity)));
      if (!channel.info.axis.empty()) out += textMatrix(name + "_axis", channel.info.axis);
    }
    if (!plan_.gaps.empty()) {
      std::vector<double> pairs;
      for (const FilledGap& gap : plan_.gaps) pairs.push_back(static_cast<double>(gap.first));
      for (const FilledGap& gap : plan_.gaps) pairs.push_back(static_cast<double>(gap.frames));
      out += numberMatrix("gaps", static_cast<std::uint32_t>(plan_.gaps.size()), pairs);
    }
    file_.writeAt(0, out);
    std::uint64_t at = out.size();
    const auto frames = static_cast<std::uint32_t>(plan_.frames);
    for (const std::string& name : names) {
      const std::string head = matrixHead(name, kDoubleClass, frames, 1, kDouble, frames * 8);
      file_.writeAt(at, head);
      at += head.size();
      begins_.push_back(at);
      at += std::uint64_t{frames} * 8;
    }
  }

  Status write(const SampleBlock& block) override {
    std::vector<double> values(static_cast<std::size_t>(block.frames));
    for (std::size_t c = 0; c < begins_.size(); ++c) {
      const std::span<const float> from = block.channel(static_cast<int>(c));
      for (std::size_t f = 0; f < from.size(); ++f)
        values[f] = plan_.channels[c].info.scale * static_cast<double>(from[f]);
      file_.writeAt(begins_[c] + written_ * 8, {reinterpret_cast<const char*>(values.data()), values.size() * 8});
    }
    written_ += static_cast<std::uint64_t>(block.frames);
    return Done{};
  }

  Status finish() override { return file_.finish(); }

 private:
  PartFile file_;
  ExportPlan plan_;
  std::vector<std::uint64_t> begins_;  // of every channel's numbers in the file
  std::uint64_t written_ = 0;          // frames
};

}  // namespace

Result<std::unique_ptr<RecordingSink>> createMatSink(const std::string& path, const ExportPlan& plan) {
  if (static_cast<std::uint64_t>(plan.frames) > kLargest / 8) {
    return Error{path, message("cannot be written: more than 268 million samples a channel"),
                 message("export a span, or to .h5")};
  }
  auto sink = std::make_unique<MatSink>(path, plan);
  if (!sink->opened()) return sink->failure();
  sink->header();
  return std::unique_ptr<RecordingSink>(std::move(sink));
}

}  // namespace stillcut::record
