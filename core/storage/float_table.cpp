#include "core/storage/float_table.h"

#include <array>

namespace stillcut::record {

bool FloatTable::create(hid_t file, const std::string& path, std::uint64_t columns, std::uint64_t chunkRows) {
  columns_ = columns;
  const std::array<hsize_t, 2> none{0, columns};
  const std::array<hsize_t, 2> most{H5S_UNLIMITED, columns};
  const std::array<hsize_t, 2> chunk{chunkRows, columns};
  const Hdf5Id space(H5Screate_simple(dimensions(), none.data(), most.data()));
  const Hdf5Id properties(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_chunk(properties.get(), dimensions(), chunk.data());
  const Hdf5Id links(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(links.get(), 1);
  dataset_ =
      Hdf5Id(H5Dcreate2(file, path.c_str(), H5T_NATIVE_FLOAT, space.get(), links.get(), properties.get(), H5P_DEFAULT));
  return static_cast<bool>(dataset_);
}

bool FloatTable::open(hid_t file, const std::string& path, std::uint64_t columns) {
  columns_ = columns;
  dataset_ = Hdf5Id(H5Dopen2(file, path.c_str(), H5P_DEFAULT));
  if (!dataset_) return false;
  const Hdf5Id space(H5Dget_space(dataset_.get()));
  std::array<hsize_t, 2> size{};
  if (!space || H5Sget_simple_extent_ndims(space.get()) != dimensions() ||
      H5Sget_simple_extent_dims(space.get(), size.data(), nullptr) < 0 || (columns_ > 1 && size[1] != columns_)) {
    return false;
  }
  rows_ = size[0];
  return true;
}

bool FloatTable::append(std::span<const float> values) {
  const std::array<hsize_t, 2> start{rows_, 0};
  const std::array<hsize_t, 2> size{values.size() / columns_, columns_};
  const std::array<hsize_t, 2> length{rows_ + size[0], columns_};
  if (H5Dset_extent(dataset_.get(), length.data()) < 0) return false;
  const Hdf5Id file(H5Dget_space(dataset_.get()));
  const Hdf5Id memory(H5Screate_simple(dimensions(), size.data(), nullptr));
  H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr);
  if (H5Dwrite(dataset_.get(), H5T_NATIVE_FLOAT, memory.get(), file.get(), H5P_DEFAULT, values.data()) < 0) {
    return false;
  }
  rows_ = length[0];
  return true;
}

bool FloatTable::read(std::uint64_t firstRow, std::span<float> values) const {
  const std::array<hsize_t, 2> start{firstRow, 0};
  const std::array<hsize_t, 2> size{values.size() / columns_, columns_};
  if (firstRow > rows_ || size[0] > rows_ - firstRow) return false;
  if (values.empty()) return true;
  const Hdf5Id file(H5Dget_space(dataset_.get()));
  const Hdf5Id memory(H5Screate_simple(dimensions(), size.data(), nullptr));
  return H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) >= 0 &&
         H5Dread(dataset_.get(), H5T_NATIVE_FLOAT, memory.get(), file.get(), H5P_DEFAULT, values.data()) >= 0;
}

}  // namespace stillcut::record
