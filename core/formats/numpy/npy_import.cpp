#include "core/formats/numpy/npy_import.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "core/formats/variable_channels.h"
#include "core/formats/zip_listing.h"

namespace stillcut::record {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::uint64_t kMostColumns = 256;

struct NpyHeader {
  char kind = 0;  // 'f', 'i', 'u', 'b'
  std::size_t size = 0;
  bool bigEndian = false;
  bool columnsApart = false;  // Fortran's order
  std::string timeUnit;       // of dates ("datetime64[ns]"); empty: plain numbers
  std::vector<std::uint64_t> shape;
  std::uint64_t bytes = 0;  // before the numbers
  std::uint64_t count() const {
    std::uint64_t all = 1;
    for (const std::uint64_t side : shape) all *= side;
    return all;
  }
};

std::uint64_t littleEndian(std::span<const unsigned char> bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i > 0; --i) value = value << 8U | bytes[i - 1];
  return value;
}

// What stands behind 'key': in the header, a literal of Python.
std::string_view valueOf(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  header.remove_prefix(at + key.size());
  header.remove_prefix(std::min(header.find_first_not_of("': "), header.size()));
  return header;
}

bool readShape(std::string_view text, NpyHeader& header) {
  if (!text.starts_with('(')) return false;
  text = text.substr(1, text.find(')') - 1);
  while (!text.empty()) {
    text.remove_prefix(std::min(text.find_first_not_of(", L"), text.size()));
    if (text.empty()) break;
    std::uint64_t side = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), side);
    constexpr std::uint64_t kLongest = std::uint64_t{1} << 31U;
    if (problem != std::errc{} || side > kLongest) return false;
    header.shape.push_back(side);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return header.shape.size() <= 2;
}

bool readType(std::string_view text, NpyHeader& header) {
  if (text.size() < 3 || std::string_view("<>|=").find(text[0]) == std::string_view::npos) return false;
  header.bigEndian = text[0] == '>';
  header.kind = text[1];
  const auto [end, problem] = std::from_chars(text.data() + 2, text.data() + text.size(), header.size);
  if (problem != std::errc{} || end == text.data() + text.size()) return false;
  if (header.kind == 'M' && *end == '[') {
    const std::size_t open = text.find('['), close = text.find(']');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return false;
    header.timeUnit.assign(text, open + 1, close - open - 1);
    header.kind = 'i';
    return header.size == 8;
  }
  if (*end != '\'') return false;
  const auto is = [&header](std::string_view kinds, std::initializer_list<std::size_t> sizes) {
    return kinds.find(header.kind) != std::string_view::npos &&
           std::find(sizes.begin(), sizes.end(), header.size) != sizes.end();
  };
  return is("f", {4, 8}) || is("iu", {1, 2, 4, 8}) || is("b", {1});
}

// Nothing: no array of real numbers in one or two dimensions.
std::optional<NpyHeader> readHeader(ByteStream& stream) {
  std::array<unsigned char, 12> head{};
  if (!stream.read(std::span(head).first(10)) || std::memcmp(head.data(), kMagic.data(), kMagic.size()) != 0)
    return std::nullopt;
  const bool wide = head[6] >= 2;  // the length takes four bytes
  if (wide && !stream.read(std::span(head).subspan(10, 2))) return std::nullopt;
  const std::uint64_t length = littleEndian(std::span(head).subspan(8, wide ? 4 : 2));
  constexpr std::uint64_t kLongest = 65536;
  if (length > kLongest) return std::nullopt;
  std::string text(static_cast<std::size_t>(length), '\0');
  if (!stream.read({reinterpret_cast<unsigned char*>(text.data()), text.size()})) return std::nullopt;
  NpyHeader header;
  header.bytes = (wide ? 12 : 10) + length;
  header.columnsApart = valueOf(text, "fortran_order").starts_with("True");
  if (!readType(valueOf(text, "'descr'"), header) || !readShape(valueOf(text, "'shape'"), header)) return std::nullopt;
  return header;
}

double toDouble(std::span<unsigned char> bytes, const NpyHeader& header) {
  if (header.bigEndian) std::reverse(bytes.begin(), bytes.end());
  const std::uint64_t bits = littleEndian(bytes);
  if (header.kind == 'f' && bytes.size() == 4)
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  if (header.kind == 'f') return std::bit_cast<double>(bits);
  if (header.kind != 'i') return static_cast<double>(bits);
  const unsigned unused = 64U - 8U * static_cast<unsigned>(bytes.size());
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

// Every `stride`th number from `first` on.
class NpyColumn final : public Column {
 public:
  NpyColumn(std::unique_ptr<ByteStream> stream, NpyHeader header, std::uint64_t stride, std::string where)
      : stream_(std::move(stream)),
        header_(std::move(header)),
        gap_((stride - 1) * header_.size),
        where_(std::move(where)) {}

  Status read(std::span<double> out) override {
    std::array<unsigned char, 8> bytes{};
    const std::span<unsigned char> one = std::span(bytes).first(header_.size);
    for (double& value : out) {
      if ((begun_ && !stream_->skip(gap_)) || !stream_->read(one))
        return Error{where_, message("ends early"), message("a truncated or damaged file")};
      value = fromFirst_ && header_.kind != 'f' ? stepsFromFirst(one) : toDouble(one, header_);
      begun_ = true;
    }
    return Done{};
  }
  void countFromFirst() override { fromFirst_ = true; }

 private:
  double stepsFromFirst(std::span<unsigned char> bytes) {
    if (header_.bigEndian) std::reverse(bytes.begin(), bytes.end());
    const std::uint64_t bits = littleEndian(bytes);
    const unsigned unused = 64U - 8U * static_cast<unsigned>(bytes.size());
    if (!begun_) first_ = bits;
    return static_cast<double>(static_cast<std::int64_t>((bits - first_) << unused) >> unused);
  }

  std::unique_ptr<ByteStream> stream_;
  NpyHeader header_;
  bool fromFirst_ = false;
  std::uint64_t first_ = 0;
  std::uint64_t gap_;  // [bytes] between two numbers of the column
  std::string where_;
  bool begun_ = false;
};

Result<std::unique_ptr<Column>> openColumn(const FilePart& part, const NpyHeader& header, int column,
                                           const std::string& where) {
  Result<std::unique_ptr<ByteStream>> stream = openPart(part);
  if (!stream) return stream.error();
  const bool flat = header.shape.size() < 2;
  const bool rows = flat || header.shape[0] >= header.shape[1];  // the first side is time
  const std::uint64_t longer = flat ? header.shape[0] : std::max(header.shape[0], header.shape[1]);
  const std::uint64_t shorter = flat ? 1 : std::min(header.shape[0], header.shape[1]);
  const bool apart = rows == header.columnsApart && !flat;  // a channel's numbers stand together
  const std::uint64_t first = static_cast<std::uint64_t>(column) * (apart ? longer : 1);
  if (!(*stream)->skip(header.bytes + first * header.size)) return Error{where, message("ends early")};
  return std::unique_ptr<Column>(new NpyColumn(std::move(*stream), header, apart ? 1 : shorter, where));
}

Status takeArray(const FilePart& part, const std::string& name, FileContents& contents) {
  Result<std::unique_ptr<ByteStream>> stream = openPart(part);
  if (!stream) return stream.error();
  const std::optional<NpyHeader> header = readHeader(**stream);
  if (!header || header->count() == 0) {
    contents.skipped.push_back(name);
    return Done{};
  }
  const std::uint64_t held = part.size - std::min(part.size, header->bytes);
  if (header->count() > held / header->size) {
    return Error{contents.path, message("'%1' promises more numbers than the file holds", name),
                 message("a truncated or damaged file")};
  }
  const std::string where = contents.path;
  if (header->count() == 1) {
    auto column = openColumn(
        part, NpyHeader{header->kind, header->size, header->bigEndian, false, "", {1}, header->bytes}, 0, where);
    std::array<double, 1> value{};
    if (column && (*column)->read(value)) contents.numbers.emplace_back(name, value[0]);
    return Done{};
  }
  FileArray array;
  array.name = name;
  array.unit = header->timeUnit;
  const std::uint64_t longer = *std::max_element(header->shape.begin(), header->shape.end());
  const std::uint64_t shorter = header->count() / longer;
  if (shorter > kMostColumns) {
    contents.skipped.push_back(name);
    return Done{};
  }
  array.frames = static_cast<std::int64_t>(longer);
  array.columns = static_cast<int>(shorter);
  array.open = [part, header = *header, where](int column) { return openColumn(part, header, column, where); };
  contents.arrays.push_back(std::move(array));
  return Done{};
}

Result<std::unique_ptr<RecordingReader>> openContents(FileContents contents, const ReadOptions& options) {
  if (contents.arrays.empty()) {
    return Error{contents.path, message("holds no array of real numbers in one or two dimensions"),
                 message("save plain arrays with numpy.save or numpy.savez")};
  }
  return openArrays(std::move(contents), options);
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openNpy(const std::string& path, const ReadOptions& options) {
  std::error_code problem;
  const std::uint64_t size = std::filesystem::file_size(path, problem);
  FileContents contents;
  contents.path = path;
  contents.kind = "NumPy array";
  const std::string name = cleanName(std::filesystem::path(path).stem().string());
  if (const Status s = takeArray({path, 0, size, size, false}, name, contents); !s) return s.error();
  return openContents(std::move(contents), options);
}

Result<std::unique_ptr<RecordingReader>> openNpz(const std::string& path, const std::string& inner,
                                                 const ReadOptions& options) {
  const Result<std::vector<ZipEntry>> entries = listZip(path);
  if (!entries) return entries.error();
  FileContents contents;
  contents.path = path;
  contents.kind = "NumPy archive";
  for (const ZipEntry& entry : *entries) {
    if (!entry.name.ends_with(".npy")) continue;
    const std::string name = cleanName(entry.name.substr(0, entry.name.size() - 4));
    const std::size_t arrays = contents.arrays.size();
    if (const Status s = takeArray(entry.part, name, contents); !s) return s.error();
    if (contents.arrays.size() > arrays && !inner.empty() && inner != "/" + name) contents.arrays.pop_back();
  }
  if (contents.arrays.empty() && !inner.empty())
    return Error{path + ":" + inner, message("there is no such array in the file")};
  return openContents(std::move(contents), options);
}

bool isNpz(const std::string& path) {
  const Result<std::vector<ZipEntry>> entries = listZip(path);
  return entries && std::any_of(entries->begin(), entries->end(),
                                [](const ZipEntry& entry) { return entry.name.ends_with(".npy"); });
}

}  // namespace stillcut::record
