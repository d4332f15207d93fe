#include "core/session/session_overview.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/session/file/session_open.h"
#include "core/session/file/session_samples.h"
#include "core/session/file/session_segments.h"

namespace stillcut::record {
namespace {

constexpr int kMostColumns = 1 << 16;

std::uint64_t ceilDiv(std::uint64_t a, std::uint64_t b) {
  return (a + b - 1) / b;
}

MinMax scaled(MinMax value, double scale) {
  const auto a = static_cast<float>(value.min * scale);
  const auto b = static_cast<float>(value.max * scale);
  return scale < 0.0 ? MinMax{b, a} : MinMax{a, b};
}

}  // namespace

struct SessionOverview::Impl {
  struct ChannelPyramid {
    SampleReader samples;
    std::array<FloatTable, kPyramidLevels> levels;
  };
  explicit Impl(std::string name) : path_(std::move(name)) {}
  Status use(OpenedSession opened);
  // Buckets first .. first + count of `level`, -1: the samples themselves. False: damaged.
  bool buckets(ChannelPyramid& channel, int level, std::uint64_t first, std::uint64_t count, std::vector<MinMax>& out);
  bool samples(ChannelPyramid& channel, std::uint64_t first, std::uint64_t count, std::vector<MinMax>& out);
  Result<std::vector<MinMax>> overview(int channel, Instant from, Instant to, int columns);

  std::string path_;
  std::unique_ptr<JournaledFile> journaled_;
  Hdf5Id file_;
  RecordingFormat format_;
  std::vector<ChannelPyramid> channels_;
  std::vector<SegmentRow> segments_;
  std::uint64_t frames_ = 0;  // of the shortest channel
};

SessionOverview::SessionOverview(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SessionOverview::~SessionOverview() = default;

Result<std::unique_ptr<SessionOverview>> SessionOverview::open(const std::string& path) {
  Result<OpenedSession> opened = openSessionFile(path);
  if (!opened) return opened.error();
  auto impl = std::make_unique<Impl>(path);
  if (const Status s = impl->use(std::move(*opened)); !s) return s.error();
  return std::unique_ptr<SessionOverview>(new SessionOverview(std::move(impl)));
}

const RecordingFormat& SessionOverview::format() const {
  return impl_->format_;
}

Result<std::vector<MinMax>> SessionOverview::overview(int channel, Instant from, Instant to, int columns) {
  return impl_->overview(channel, from, to, columns);
}

Status SessionOverview::Impl::use(OpenedSession opened) {
  Result<RecordingFormat> format = readSessionFormat(opened, path_);
  if (!format) return format.error();
  format_ = std::move(*format);
  journaled_ = std::move(opened.journaled);
  file_ = std::move(opened.file);
  for (int c = 0; c < static_cast<int>(format_.channels.size()); ++c) {
    ChannelPyramid channel;
    if (!channel.samples.open(file_.get(), c)) return Error{path_, message("the samples cannot be read"), hdf5Cause()};
    for (int level = 0; level < kPyramidLevels; ++level) {
      // A level that is missing has no rows.
      (void)channel.levels[static_cast<std::size_t>(level)].open(file_.get(), pyramidPath(c, level), 2);
    }
    frames_ = c == 0 ? channel.samples.frames() : std::min(frames_, channel.samples.frames());
    channels_.push_back(std::move(channel));
  }
  if (!readSegments(file_.get(), segments_)) return Error{path_, message("its times cannot be read"), hdf5Cause()};
  format_.frames = static_cast<std::int64_t>(frames_);
  return Done{};
}

Instant SessionOverview::begin() const {
  const std::vector<SegmentRow>& segments = impl_->segments_;
  return segments.empty() ? Instant{} : timeOf(segments.front(), segments.front().offset);
}

Instant SessionOverview::end() const {
  const std::vector<SegmentRow>& segments = impl_->segments_;
  return segments.empty() ? Instant{} : timeOf(segments.back(), std::max(impl_->frames_, segments.back().offset));
}

bool SessionOverview::Impl::samples(ChannelPyramid& channel, std::uint64_t first, std::uint64_t count,
                                    std::vector<MinMax>& out) {
  std::vector<float> values(count);
  if (!channel.samples.read(first, values)) return false;
  for (const float v : values) out.push_back({v, v});
  return true;
}

bool SessionOverview::Impl::buckets(ChannelPyramid& channel, int level, std::uint64_t first, std::uint64_t count,
                                    std::vector<MinMax>& out) {
  if (level < 0) return samples(channel, first, count, out);
  const FloatTable& table = channel.levels[static_cast<std::size_t>(level)];
  const std::uint64_t stored = first < table.rows() ? std::min(count, table.rows() - first) : 0;
  std::vector<float> values(2 * stored);
  if (!table.read(std::min(first, table.rows()), values)) return false;
  for (std::uint64_t i = 0; i < stored; ++i) out.push_back({values[2 * i], values[2 * i + 1]});
  // The rest has no row (yet): one bucket after the other from the level below.
  const std::uint64_t parts = level == 0 ? kPyramidBase : kPyramidFactor;
  const std::uint64_t partFrames = bucketFrames(level) / parts;
  std::vector<MinMax> below;
  for (std::uint64_t bucket = first + stored; bucket < first + count; ++bucket) {
    const std::uint64_t from = bucket * parts;
    const std::uint64_t to = std::min(from + parts, ceilDiv(frames_, partFrames));
    below.clear();
    if (to > from && !buckets(channel, level - 1, from, to - from, below)) return false;
    Extremes extremes;
    for (const MinMax& part : below) extremes.add(part);
    out.push_back(extremes.value());
  }
  return true;
}

Result<std::vector<MinMax>> SessionOverview::Impl::overview(int channel, Instant from, Instant to, int columns) {
  if (channel < 0 || channel >= static_cast<int>(channels_.size())) {
    return Error{path_, message("there is no channel %1", std::to_string(channel))};
  }
  if (columns < 1 || columns > kMostColumns || to <= from) {
    return Error{path_, message("cannot be drawn so"), message("from must lie before to, with 1 to 65536 columns")};
  }
  quietHdf5();
  const double length_ns = static_cast<double>((to - from).count());
  const auto edge = [&](int column) {
    const Instant time = from + Duration(static_cast<std::int64_t>(length_ns * column / columns));
    return frameAt(segments_, frames_, time);
  };
  const std::uint64_t firstFrame = edge(0);
  const std::uint64_t lastFrame = edge(columns);
  int level = -1;
  while (level + 1 < kPyramidLevels &&
         bucketFrames(level + 1) <= (lastFrame - firstFrame) / static_cast<std::uint64_t>(columns)) {
    ++level;
  }
  const std::uint64_t size = level < 0 ? 1 : bucketFrames(level);
  const std::uint64_t firstBucket = firstFrame / size;
  const std::uint64_t endBucket = std::min(ceilDiv(lastFrame + 1, size), ceilDiv(frames_, size));
  std::vector<MinMax> values;
  if (endBucket > firstBucket &&
      !buckets(channels_[static_cast<std::size_t>(channel)], level, firstBucket, endBucket - firstBucket, values)) {
    return Error{path_, message("the samples cannot be read"), hdf5Cause()};
  }
  const double scale = format_.channels[static_cast<std::size_t>(channel)].info.scale;
  std::vector<MinMax> picture;
  std::uint64_t begin = firstFrame;
  for (int c = 0; c < columns; ++c) {
    std::uint64_t end = edge(c + 1);
    const std::uint64_t next = end;
    if (end == begin &&
        withinSample(segments_, begin, from + Duration(static_cast<std::int64_t>(length_ns * c / columns)))) {
      end = begin + 1;
    }
    Extremes extremes;
    for (std::uint64_t b = begin / size; begin < end && b < std::min(ceilDiv(end, size), endBucket); ++b) {
      extremes.add(values[b - firstBucket]);
    }
    picture.push_back(scaled(extremes.value(), scale));
    begin = next;
  }
  return picture;
}

}  // namespace stillcut::record
