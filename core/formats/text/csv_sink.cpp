#include <algorithm>
#include <cstdio>

#include "core/formats/recording_sink.h"
#include "core/storage/part_file.h"

namespace stillcut::record {
namespace {

// Time and one column a channel, with names and units; seconds since the first sample of the recording, also where only
// a span of it is written.
class CsvSink final : public RecordingSink {
 public:
  CsvSink(const std::string& path, const ExportPlan& plan)
      : file_(path), channels_(plan.channels), begin_(plan.begin) {}

  bool opened() const { return file_.opened(); }
  Error failure() const { return file_.failure(); }

  void header() {
    std::fputs("Time (s)", file_.stream());
    for (const RecordedChannel& channel : channels_) {
      std::string name = channel.info.name;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return c == ',' || c == '\n' || c == '\r'; }, ' ');
      const std::string unit = exportUnit(channel);
      std::fprintf(file_.stream(), ",%s%s", name.c_str(), unit.empty() ? "" : (" (" + unit + ")").c_str());
    }
    std::fputc('\n', file_.stream());
  }

  Status write(const SampleBlock& block) override {
    std::FILE* to = file_.stream();
    for (int f = 0; f < block.frames; ++f) {
      std::fprintf(to, "%.9f", secondsBetween(begin_, block.firstSample).value + f / block.rate.value);
      for (int c = 0; c < block.channels; ++c) {
        const double scale = channels_[static_cast<std::size_t>(c)].info.scale;
        std::fprintf(to, ",%.9g", block.channel(c)[static_cast<std::size_t>(f)] * scale);
      }
      std::fputc('\n', to);
    }
    if (std::ferror(to) != 0) return file_.failure();
    return Done{};
  }

  Status finish() override { return file_.finish(); }

 private:
  PartFile file_;
  std::vector<RecordedChannel> channels_;
  Instant begin_;
};

}  // namespace

Result<std::unique_ptr<RecordingSink>> createCsvSink(const std::string& path, const ExportPlan& plan) {
  auto sink = std::make_unique<CsvSink>(path, plan);
  if (!sink->opened()) return sink->failure();
  sink->header();
  return std::unique_ptr<RecordingSink>(std::move(sink));
}

}  // namespace stillcut::record
