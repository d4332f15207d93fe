#include "core/formats/hdf5/hdf5_arrays.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/formats/utf_text.h"
#include "core/formats/variable_channels.h"

namespace stillcut::record {
namespace {

constexpr std::size_t kMostObjects = 4096;
constexpr hsize_t kMostColumns = 256;
constexpr std::uint64_t kLargestChunk = std::uint64_t{64} << 20U;  // [bytes]
constexpr std::size_t kLongestText = 256;

struct Shape {
  int rank = 0;
  std::array<hsize_t, 2> size{1, 1};
};

class Hdf5Column final : public Column {
 public:
  Hdf5Column(std::shared_ptr<Hdf5Id> file, Hdf5Id dataset, const Hdf5Array& array, int column, std::string where)
      : file_(std::move(file)),
        dataset_(std::move(dataset)),
        array_(array),
        column_(static_cast<hsize_t>(column)),
        where_(std::move(where)) {}

  Status read(std::span<double> out) override {
    quietHdf5();
    const Hdf5Id fileSpace(H5Dget_space(dataset_.get()));
    std::array<hsize_t, 2> start{next_, column_};
    std::array<hsize_t, 2> count{out.size(), 1};
    if (!array_.frameIsRow) {
      std::swap(start[0], start[1]);
      std::swap(count[0], count[1]);
    }
    const hsize_t length = out.size();
    const Hdf5Id memory(H5Screate_simple(1, &length, nullptr));
    whole_.resize(fromFirst_ ? out.size() : 0);
    void* into = fromFirst_ ? static_cast<void*>(whole_.data()) : out.data();
    if (H5Sselect_hyperslab(fileSpace.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0 ||
        H5Dread(dataset_.get(), fromFirst_ ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE, memory.get(), fileSpace.get(),
                H5P_DEFAULT, into) < 0) {
      return Error{where_, message("'%1' cannot be read", cleanName(array_.path)), hdf5Cause()};
    }
    if (next_ == 0 && !whole_.empty()) first_ = static_cast<std::uint64_t>(whole_.front());
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      out[i] = static_cast<double>(static_cast<std::int64_t>(static_cast<std::uint64_t>(whole_[i]) - first_));
    }
    next_ += out.size();
    return Done{};
  }
  void countFromFirst() override {
    const Hdf5Id type(H5Dget_type(dataset_.get()));
    fromFirst_ = type && H5Tget_class(type.get()) == H5T_INTEGER;
  }

 private:
  std::shared_ptr<Hdf5Id> file_;
  Hdf5Id dataset_;
  Hdf5Array array_;
  hsize_t column_;
  std::string where_;
  hsize_t next_ = 0;
  bool fromFirst_ = false;
  std::uint64_t first_ = 0;
  std::vector<std::int64_t> whole_;  // the numbers at hand, where they are counted from the first
};

bool shapeOf(hid_t dataset, Shape& shape) {
  const Hdf5Id space(H5Dget_space(dataset));
  if (!space) return false;
  shape.rank = H5Sget_simple_extent_ndims(space.get());
  if (shape.rank < 0 || shape.rank > 2) return false;
  return shape.rank == 0 || H5Sget_simple_extent_dims(space.get(), shape.size.data(), nullptr) >= 0;
}

// Lying sizes: chunks are held in memory whole, and deflate shrinks by a thousand at most.
Status checkStorage(hid_t dataset, const Shape& shape, std::size_t typeSize, std::uint64_t fileBytes,
                    const std::string& where) {
  const Hdf5Id plan(H5Dget_create_plist(dataset));
  if (H5Pget_external_count(plan.get()) > 0) return Error{where, message("its samples lie in another file")};
  const H5D_layout_t layout = H5Pget_layout(plan.get());
  if (layout == H5D_VIRTUAL)
    return Error{where, message("its samples lie in other data sets"), message("virtual data sets are not read")};
  const long double bytes = static_cast<long double>(shape.size[0]) * shape.size[1] * typeSize;
  const std::uint64_t stored = H5Dget_storage_size(dataset);
  std::uint64_t chunk = 0;
  long double most = static_cast<long double>(stored);
  if (layout == H5D_CHUNKED) {
    std::array<hsize_t, 2> size{1, 1};
    if (H5Pget_chunk(plan.get(), 2, size.data()) < 0)
      return Error{where, message("its layout is damaged"), hdf5Cause()};
    const long double chunkBytes = static_cast<long double>(size[0]) * size[1] * typeSize;
    if (chunkBytes > kLargestChunk) return Error{where, message("is stored in pieces of more than 64 MB")};
    chunk = static_cast<std::uint64_t>(chunkBytes);
    constexpr long double kMostDeflated = 1100.0L;
    most = (H5Pget_nfilters(plan.get()) > 0 ? kMostDeflated : 1.0L) * stored + chunk * 2.0L;
  }
  if (stored == 0 || stored > fileBytes || bytes > most) {
    return Error{where, message("promises more samples than the file holds"),
                 message("a truncated file, or its header is wrong")};
  }
  return Done{};
}

struct Walk {
  hid_t file;
  std::string from;
  std::uint64_t fileBytes;
  std::string path;
  Hdf5Listing listing;
  std::optional<Error> problem;
  std::size_t seen = 0;
};

void takeText(hid_t dataset, const std::string& name, const Shape& shape, Hdf5Listing& listing) {
  const hsize_t length = shape.size[0] * shape.size[1];
  if (length == 0 || length > kLongestText) return;
  std::vector<std::uint16_t> letters(static_cast<std::size_t>(length));
  if (H5Dread(dataset, H5T_NATIVE_UINT16, H5S_ALL, H5S_ALL, H5P_DEFAULT, letters.data()) < 0) return;
  listing.texts.emplace_back(name, cleanName(fromUtf16(letters)));
}

void takeDataset(Walk& walk, const std::string& path) {
  const Hdf5Id dataset(H5Dopen2(walk.file, path.c_str(), H5P_DEFAULT));
  const Hdf5Id type(dataset ? H5Dget_type(dataset.get()) : H5I_INVALID_HID);
  Shape shape;
  if (!type) return;
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind == H5T_COMPOUND && walk.listing.table.empty()) walk.listing.table = cleanName(path);
  if (!shapeOf(dataset.get(), shape)) {
    if ((kind == H5T_FLOAT || kind == H5T_INTEGER) && walk.listing.deep.empty()) walk.listing.deep = cleanName(path);
    return;
  }
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) return;
  const std::string name = path.substr(path.rfind('/') + 1);
  const std::string matlab = readAnyText(dataset.get(), "MATLAB_class").value_or("");
  if (matlab == "char") return takeText(dataset.get(), name, shape, walk.listing);
  if (shape.size[0] == 0 || shape.size[1] == 0 || readInteger(dataset.get(), "MATLAB_empty").value_or(0) != 0) return;
  if (shape.size[0] == 1 && shape.size[1] == 1) {
    double value = 0.0;
    if (H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value) >= 0) {
      walk.listing.numbers.emplace_back(name, value);
    }
    return;
  }
  const std::string where = walk.path + ":" + cleanName(path);
  if (const Status s = checkStorage(dataset.get(), shape, H5Tget_size(type.get()), walk.fileBytes, where); !s) {
    if (!walk.problem) walk.problem = s.error();
    return;
  }
  Hdf5Array array;
  array.path = path;
  array.rank = shape.rank;
  array.frameIsRow = shape.rank == 1 || shape.size[0] >= shape.size[1];
  const hsize_t columns = std::min(shape.size[0], shape.size[1]);
  array.columns = shape.rank == 1 ? 1 : static_cast<int>(std::min(columns, kMostColumns + 1));
  array.frames = static_cast<std::int64_t>(std::max(shape.size[0], shape.size[1]));
  if (static_cast<hsize_t>(array.columns) <= kMostColumns) walk.listing.arrays.push_back(std::move(array));
}

herr_t visit(hid_t, const char* name, const H5O_info_t* info, void* context) {
  Walk& walk = *static_cast<Walk*>(context);
  if (++walk.seen > kMostObjects) {
    walk.problem =
        Error{walk.path, message("holds more than 4096 objects"), message("name the one to read: FILE:/path")};
    return 1;
  }
  if (info->type != H5O_TYPE_DATASET) return 0;
  const bool itself = std::string_view(name) == ".";
  std::string path = itself ? walk.from : walk.from + (walk.from.ends_with('/') ? "" : "/") + name;
  if (path.find("#refs#") == std::string::npos) takeDataset(walk, path);
  return 0;
}

}  // namespace

Result<Hdf5Listing> listHdf5Arrays(hid_t file, const std::string& from, std::uint64_t fileBytes,
                                   const std::string& path) {
  Walk walk{file, from, fileBytes, path, {}, std::nullopt, 0};
  const std::string place = path + ":" + cleanName(from);
  const Hdf5Id object(H5Oopen(file, from.c_str(), H5P_DEFAULT));
  if (!object) return Error{place, message("there is no such data set or folder in the file")};
  if (H5Ovisit2(object.get(), H5_INDEX_NAME, H5_ITER_NATIVE, visit, &walk, H5O_INFO_BASIC) < 0) {
    return Error{place, message("the file is damaged"), hdf5Cause()};
  }
  if (walk.problem) return *walk.problem;
  std::sort(walk.listing.arrays.begin(), walk.listing.arrays.end(),
            [](const Hdf5Array& a, const Hdf5Array& b) { return a.path < b.path; });
  return std::move(walk.listing);
}

namespace {

// A chunk that does not fit the library's cache of 1 MB would be inflated anew for each block read from it.
Hdf5Id roomForAChunk(hid_t file, const std::string& path) {
  Hdf5Id access(H5Pcreate(H5P_DATASET_ACCESS));
  const Hdf5Id dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT));
  const Hdf5Id properties(dataset ? H5Dget_create_plist(dataset.get()) : H5I_INVALID_HID);
  if (!properties || H5Pget_layout(properties.get()) != H5D_CHUNKED) return access;
  std::array<hsize_t, H5S_MAX_RANK> chunk{};
  const int rank = H5Pget_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
  const Hdf5Id type(H5Dget_type(dataset.get()));
  constexpr double kMost = 256U << 20U, kUsual = 1U << 20U;  // bytes
  double bytes = static_cast<double>(H5Tget_size(type.get()));
  for (int i = 0; i < rank; ++i) bytes *= static_cast<double>(chunk[static_cast<std::size_t>(i)]);
  if (bytes <= kUsual || bytes > kMost) return access;
  H5Pset_chunk_cache(access.get(), H5D_CHUNK_CACHE_NSLOTS_DEFAULT, static_cast<std::size_t>(bytes + kUsual),
                     H5D_CHUNK_CACHE_W0_DEFAULT);
  return access;
}

}  // namespace

Result<std::unique_ptr<Column>> openHdf5Column(const std::shared_ptr<Hdf5Id>& file, const Hdf5Array& array, int column,
                                               const std::string& where) {
  Hdf5Id dataset(H5Dopen2(file->get(), array.path.c_str(), roomForAChunk(file->get(), array.path).get()));
  if (!dataset) return Error{where, message("'%1' cannot be opened", cleanName(array.path)), hdf5Cause()};
  return std::unique_ptr<Column>(new Hdf5Column(file, std::move(dataset), array, column, where));
}

std::optional<std::string> readAnyText(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return std::nullopt;
  const Hdf5Id attribute(H5Aopen(object, name, H5P_DEFAULT));
  const Hdf5Id type(attribute ? H5Aget_type(attribute.get()) : H5I_INVALID_HID);
  if (!type || H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) <= 0) {
    return readText(object, name);
  }
  const Hdf5Id space(H5Aget_space(attribute.get()));
  if (H5Sget_simple_extent_npoints(space.get()) != 1) return std::nullopt;
  char* letters = nullptr;
  if (H5Aread(attribute.get(), type.get(), static_cast<void*>(&letters)) < 0 || letters == nullptr) return std::nullopt;
  std::string text(letters);
  H5free_memory(letters);
  return text;
}

bool isMatlab73(hid_t file, const std::vector<Hdf5Array>& arrays) {
  if (arrays.empty()) return false;
  const Hdf5Id dataset(H5Dopen2(file, arrays.front().path.c_str(), H5P_DEFAULT));
  return dataset && readAnyText(dataset.get(), "MATLAB_class").has_value();
}

}  // namespace stillcut::record
