#include "core/evaluate/picture/sample_store.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>

namespace stillcut::evaluate {
namespace {

constexpr std::int64_t kChunk = 16384;  // frames read at once

Error noRoom(int problem) {
  return {message("the recording"), message("cannot be kept for the screen"), foreign(std::strerror(problem))};
}

// All of it, or how far it came.
std::size_t readAll(int file, char* into, std::size_t bytes, std::int64_t at) {
  std::size_t done = 0;
  while (done < bytes) {
    const ssize_t got = ::pread(file, into + done, bytes - done, at + static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace

Result<std::shared_ptr<SampleStore>> SampleStore::make(int channels) {
  std::error_code none;
  // Not in memory, where the disk for what outlives a start is there.
  std::filesystem::path folder = std::filesystem::temp_directory_path(none);
  if (const std::filesystem::path large = "/var/tmp"; std::filesystem::is_directory(large, none)) folder = large;
  std::string name = (folder / "stillcut-samples-XXXXXX").string();
  const int file = ::mkstemp(name.data());
  if (file < 0) return noRoom(errno);
  ::unlink(name.c_str());
  return std::shared_ptr<SampleStore>(new SampleStore(file, channels));
}

SampleStore::~SampleStore() {
  ::close(file_);
}

Status SampleStore::append(const std::vector<std::span<const float>>& channels) {
  const std::size_t frames = channels.empty() ? 0 : channels.front().size();
  interleaved_.resize(frames * channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (std::size_t k = 0; k < frames; ++k) interleaved_[k * channels.size() + c] = channels[c][k];
  }
  const char* from = reinterpret_cast<const char*>(interleaved_.data());
  std::size_t left = interleaved_.size() * sizeof(float);
  std::int64_t at = frames_ * channels_ * static_cast<std::int64_t>(sizeof(float));
  while (left > 0) {
    const ssize_t put = ::pwrite(file_, from, left, at);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return noRoom(errno);
    from += put;
    at += put;
    left -= static_cast<std::size_t>(put);
  }
  frames_ += static_cast<std::int64_t>(frames);
  return Done{};
}

bool SampleStore::read(int channel, std::int64_t first, std::span<float> out) const {
  std::fill(out.begin(), out.end(), std::numeric_limits<float>::quiet_NaN());
  if (channel < 0 || channel >= channels_) return false;
  const auto stride = static_cast<std::int64_t>(channels_);
  std::vector<float> chunk;
  const std::int64_t end = std::min(first + static_cast<std::int64_t>(out.size()), frames_);
  for (std::int64_t at = std::max<std::int64_t>(first, 0); at < end;) {
    const std::int64_t count = std::min(kChunk, end - at);
    chunk.resize(static_cast<std::size_t>(count * stride));
    const std::size_t bytes = chunk.size() * sizeof(float);
    const std::size_t got = readAll(file_, reinterpret_cast<char*>(chunk.data()), bytes,
                                    at * stride * static_cast<std::int64_t>(sizeof(float)));
    if (got != bytes) return false;
    for (std::int64_t k = 0; k < count; ++k)
      out[static_cast<std::size_t>(at + k - first)] = chunk[static_cast<std::size_t>(k * stride + channel)];
    at += count;
  }
  return true;
}

}  // namespace stillcut::evaluate
