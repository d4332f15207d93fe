#include "core/formats/tdms/tdms_index.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

namespace stillcut::record {
namespace {

constexpr std::uint64_t kLeadIn = 28;
constexpr std::uint32_t kMetaData = 1U << 1U, kNewList = 1U << 2U, kRawData = 1U << 3U, kInterleaved = 1U << 5U,
                        kBigEndian = 1U << 6U, kDaqMx = 1U << 7U;
constexpr std::uint32_t kNoData = 0xFFFFFFFFU, kAsBefore = 0, kDaqMxFormat = 0x69120000U, kDaqMxDigital = 0x69130000U;
constexpr std::uint64_t kUnfinished = ~std::uint64_t{0};
// A file that promises more is damaged, or none of measured values.
constexpr std::uint64_t kMostHeader = std::uint64_t{64} << 20U, kMostSegments = 4'000'000;
constexpr std::uint64_t kMostRuns = 20'000'000;  // of all channels
constexpr std::uint32_t kMostObjects = 100'000, kLongestText = 1U << 20U;

Error damaged(const std::string& path) {
  return Error{path, message("is a damaged TDMS file"), message("a header makes no sense")};
}

// The bytes of one header; reading beyond its end gives zeros and is noted.
class Bytes {
 public:
  Bytes(std::vector<unsigned char> bytes, bool bigEndian) : bytes_(std::move(bytes)), bigEndian_(bigEndian) {}

  std::uint64_t whole(std::size_t size) {
    if (at_ + size > bytes_.size()) {
      beyond_ = true;
      return 0;
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8U | bytes_[at_ + (bigEndian_ ? i : size - 1 - i)];
    at_ += size;
    return value;
  }
  std::uint32_t u32() { return static_cast<std::uint32_t>(whole(4)); }
  std::string text() {
    const std::uint32_t length = u32();
    if (length > kLongestText || at_ + length > bytes_.size()) {
      beyond_ = true;
      return {};
    }
    const auto from = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
    at_ += length;
    return {from, from + length};
  }
  bool beyond() const { return beyond_; }

 private:
  std::vector<unsigned char> bytes_;
  bool bigEndian_;
  std::size_t at_ = 0;
  bool beyond_ = false;
};

// "/'Group'/'Channel'"; a quote within a name is written twice.
std::vector<std::string> partsOf(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at + 1 < path.size();) {
    if (path[at] != '/' || path[at + 1] != '\'') break;
    std::string part;
    for (at += 2; at < path.size(); ++at) {
      if (path[at] != '\'') {
        part += path[at];
      } else if (at + 1 < path.size() && path[at + 1] == '\'') {
        part += '\'';
        ++at;
      } else {
        ++at;
        break;
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

struct Object {
  std::string path;
  TdmsType type = TdmsType::Double;
  std::uint64_t values = 0;  // in one chunk of a segment
  std::uint64_t bytes = 0;   // of them
  bool known = false;        // its data were described
  TdmsChannel channel;
};

class Indexer {
 public:
  explicit Indexer(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    std::error_code unknown;
    size_ = std::filesystem::file_size(path, unknown);
  }

  Result<TdmsIndex> run() {
    if (!file_) return Error{path_, message("cannot be opened"), foreign(std::strerror(errno))};
    std::uint64_t at = 0, segments = 0;
    while (at + kLeadIn <= size_ && !index_.cut) {
      const Result<std::uint64_t> next = segment(at);
      if (!next) return next.error();
      if (*next <= at || ++segments > kMostSegments) return damaged(path_);
      at = *next;
    }
    index_.cut = index_.cut || at != size_;
    for (Object& object : objects_) {
      if (object.channel.values > 0) {
        index_.channels.push_back(std::move(object.channel));
      } else if (object.channel.name.empty()) {
        index_.above.push_back(std::move(object.channel));
      }
    }
    return std::move(index_);
  }

 private:
  std::optional<std::vector<unsigned char>> read(std::uint64_t from, std::uint64_t count) {
    if (from > size_ || count > size_ - from || count > kMostHeader) return std::nullopt;
    std::vector<unsigned char> bytes(static_cast<std::size_t>(count));
    file_.seekg(static_cast<std::streamoff>(from));
    file_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
    return file_ ? std::optional(std::move(bytes)) : std::nullopt;
  }

  // Gives where the next one begins.
  Result<std::uint64_t> segment(std::uint64_t at) {
    auto lead = read(at, kLeadIn);
    if (!lead) return damaged(path_);
    if (std::memcmp(lead->data(), "TDSm", 4) != 0) return damaged(path_);
    lead->erase(lead->begin(), lead->begin() + 4);
    // The mask itself is always little-endian.
    const std::uint32_t contents = Bytes(*lead, false).u32();
    Bytes rest(std::vector<unsigned char>(lead->begin() + 4, lead->end()), (contents & kBigEndian) != 0);
    (void)rest.u32();  // version
    std::uint64_t whole = rest.whole(8);
    const std::uint64_t header = rest.whole(8);
    const std::uint64_t held = size_ - at - kLeadIn;
    if (whole == kUnfinished || whole > held) {
      index_.cut = true;
      whole = held;
    }
    if (header > whole) return damaged(path_);
    if ((contents & kMetaData) != 0) {
      auto bytes = read(at + kLeadIn, header);
      if (!bytes) return damaged(path_);
      if (const Status s = objects(Bytes(std::move(*bytes), (contents & kBigEndian) != 0), contents); !s)
        return s.error();
    }
    if ((contents & kRawData) != 0) {
      if ((contents & kDaqMx) != 0) return raw();
      if (const Status s = data(at + kLeadIn + header, whole - header, contents); !s) return s.error();
    }
    return at + kLeadIn + whole;
  }
  Error raw() const {
    return Error{
        path_, message("holds unscaled values of a DAQmx device, which are not read"),
        message("export it as CSV, or write it as HDF5 in Python: %1", "nptdms.TdmsFile.read(FILE).as_hdf('cut.h5')")};
  }

  Object& objectAt(const std::string& path) {
    const auto known =
        std::find_if(objects_.begin(), objects_.end(), [&path](const Object& o) { return o.path == path; });
    if (known != objects_.end()) return *known;
    Object object;
    object.path = path;
    const std::vector<std::string> parts = partsOf(path);
    if (!parts.empty()) object.channel.group = parts[0];
    if (parts.size() > 1) object.channel.name = parts[1];
    objects_.push_back(std::move(object));
    return objects_.back();
  }

  Status objects(Bytes bytes, std::uint32_t contents) {
    if ((contents & kNewList) != 0) order_.clear();
    const std::uint32_t count = bytes.u32();
    if (count > kMostObjects) return damaged(path_);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::string path = bytes.text();
      Object& object = objectAt(path);
      const std::uint32_t index = bytes.u32();
      if (index == kDaqMxFormat || index == kDaqMxDigital) return raw();
      if (index != kNoData && index != kAsBefore) {
        object.type = static_cast<TdmsType>(bytes.u32());
        (void)bytes.u32();  // dimensions: 1
        object.values = bytes.whole(8);
        const bool text = object.type == TdmsType::Text;
        object.bytes = text ? bytes.whole(8) : object.values * sizeOf(object.type);
        object.known = true;
        object.channel.type = object.type;
      }
      const auto place = static_cast<std::size_t>(&object - objects_.data());
      if (index == kNoData) {
        std::erase(order_, place);
      } else if (object.known && std::find(order_.begin(), order_.end(), place) == order_.end()) {
        order_.push_back(place);
      }
      if (Status s = properties(bytes, object); !s) return s;
    }
    return bytes.beyond() ? Status(damaged(path_)) : Status(Done{});
  }

  Status properties(Bytes& bytes, Object& object) {
    const std::uint32_t count = bytes.u32();
    if (count > kMostObjects) return damaged(path_);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::string name = bytes.text();
      const auto type = static_cast<TdmsType>(bytes.u32());
      if (type == TdmsType::Text) {
        object.channel.texts[name] = bytes.text();
      } else if (type == TdmsType::TimeStamp) {
        takeTime(bytes, object, name);
      } else if (const std::size_t size = sizeOf(type); size > 0) {
        object.channel.numbers[name] = tdmsNumber(bytes.whole(size), type);
      } else {
        return damaged(path_);
      }
      if (bytes.beyond()) return damaged(path_);
    }
    return Done{};
  }
  // Fractions of 2^-64 s, then seconds since 1904; the other way round where bytes are.
  void takeTime(Bytes& bytes, Object& object, const std::string& name) {
    const std::uint64_t fraction = bytes.whole(8);
    const auto seconds = static_cast<std::int64_t>(bytes.whole(8));
    const std::optional<std::int64_t> ns = tdmsTime(seconds, fraction);
    if (!ns) return;
    if (name == "wf_start_time") object.channel.started_ns = *ns;
    if (index_.started_ns == 0 && *ns > 0) index_.started_ns = *ns;
  }

  // A segment holds as many chunks as its length has room for; the last may be cut off.
  Status data(std::uint64_t from, std::uint64_t length, std::uint32_t contents) {
    std::uint64_t chunk = 0, row = 0;
    for (const std::size_t o : order_) {
      if (objects_[o].bytes > size_) return damaged(path_);
      chunk += objects_[o].bytes;
      row += sizeOf(objects_[o].type);
    }
    if (chunk == 0) return Done{};
    const bool bigEndian = (contents & kBigEndian) != 0;
    const bool interleaved = (contents & kInterleaved) != 0;
    if (interleaved) {
      std::uint64_t at = from;
      for (const std::size_t o : order_) {
        Object& object = objects_[o];
        const std::uint64_t size = sizeOf(object.type);
        if (size == 0 || row == 0) return Error{path_, message("holds interleaved values that are no numbers")};
        add(object, {at, length / row, row, bigEndian});
        at += size;
      }
      return Done{};
    }
    const std::uint64_t chunks = (length + chunk - 1) / chunk;
    runs_ += chunks * order_.size();
    if (runs_ > kMostRuns)
      return Error{path_, message("is a damaged TDMS file"), message("its values lie too scattered")};
    std::uint64_t at = from;
    const std::uint64_t end = from + length;
    for (std::uint64_t k = 0; k < chunks; ++k) {
      for (const std::size_t o : order_) {
        Object& object = objects_[o];
        const std::uint64_t size = sizeOf(object.type);
        const std::uint64_t there = std::min(object.bytes, end - std::min(end, at));
        if (size > 0) add(object, {at, there / size, size, bigEndian});
        at += object.bytes;
      }
    }
    return Done{};
  }
  static void add(Object& object, const TdmsRun& run) {
    if (run.count == 0) return;
    std::vector<TdmsRun>& runs = object.channel.runs;
    object.channel.values += run.count;
    const bool follows = !runs.empty() && runs.back().stride == run.stride && runs.back().bigEndian == run.bigEndian &&
                         runs.back().from + runs.back().count * runs.back().stride == run.from;
    if (follows) {
      runs.back().count += run.count;
    } else {
      runs.push_back(run);
    }
  }

  std::string path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  TdmsIndex index_;
  std::vector<Object> objects_;
  std::vector<std::size_t> order_;  // objects with data in the segment at hand
  std::uint64_t runs_ = 0;          // pieces that values lie in, at most
};

}  // namespace

Result<TdmsIndex> readTdmsIndex(const std::string& path) {
  return Indexer(path).run();
}

}  // namespace stillcut::record
