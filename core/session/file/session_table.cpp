#include "core/session/file/session_table.h"

namespace stillcut::record {
namespace {

Hdf5Id nativeType(const RowField& column) {
  switch (column.type) {
    case FieldType::U8:
      return Hdf5Id(H5Tcopy(H5T_NATIVE_UINT8));
    case FieldType::U16:
      return Hdf5Id(H5Tcopy(H5T_NATIVE_UINT16));
    case FieldType::U32:
      return Hdf5Id(H5Tcopy(H5T_NATIVE_UINT32));
    case FieldType::I32:
      return Hdf5Id(H5Tcopy(H5T_NATIVE_INT32));
    case FieldType::U64:
      return Hdf5Id(H5Tcopy(H5T_NATIVE_UINT64));
    case FieldType::I64:
      return Hdf5Id(H5Tcopy(H5T_NATIVE_INT64));
    case FieldType::F64:
      return Hdf5Id(H5Tcopy(H5T_NATIVE_DOUBLE));
    case FieldType::Text:
      break;
  }
  Hdf5Id text(H5Tcopy(H5T_C_S1));
  H5Tset_size(text.get(), column.count);
  return text;
}

Hdf5Id rowType(std::span<const RowField> columns, std::size_t rowSize) {
  Hdf5Id row(H5Tcreate(H5T_COMPOUND, rowSize));
  for (const RowField& column : columns) {
    Hdf5Id type = nativeType(column);
    if (column.count > 1 && column.type != FieldType::Text) {
      const hsize_t count = column.count;
      type = Hdf5Id(H5Tarray_create2(type.get(), 1, &count));
    }
    H5Tinsert(row.get(), column.name, column.offset, type.get());
  }
  return row;
}

}  // namespace

bool SessionTable::create(hid_t file, const char* path, std::span<const RowField> columns, std::size_t rowSize) {
  memory_ = rowType(columns, rowSize);
  const Hdf5Id packed(H5Tcopy(memory_.get()));
  H5Tpack(packed.get());
  const hsize_t none = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const hsize_t chunk = 512;
  const Hdf5Id space(H5Screate_simple(1, &none, &unlimited));
  const Hdf5Id properties(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_chunk(properties.get(), 1, &chunk);
  const Hdf5Id links(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(links.get(), 1);
  dataset_ = Hdf5Id(H5Dcreate2(file, path, packed.get(), space.get(), links.get(), properties.get(), H5P_DEFAULT));
  return static_cast<bool>(dataset_);
}

bool SessionTable::open(hid_t file, const char* path, std::span<const RowField> columns, std::size_t rowSize) {
  memory_ = rowType(columns, rowSize);
  dataset_ = Hdf5Id(H5Dopen2(file, path, H5P_DEFAULT));
  if (!dataset_) return false;
  const Hdf5Id stored(H5Dget_type(dataset_.get()));
  if (H5Tget_class(stored.get()) != H5T_COMPOUND) return false;
  for (const RowField& column : columns) {
    if (!column.later && H5Tget_member_index(stored.get(), column.name) < 0) return false;
  }
  const std::optional<std::uint64_t> length = lengthOf(dataset_.get());
  rows_ = length.value_or(0);
  return length.has_value();
}

bool SessionTable::append(const void* rows, std::uint64_t count) {
  const hsize_t start = rows_;
  const hsize_t length = rows_ + count;
  if (H5Dset_extent(dataset_.get(), &length) < 0) return false;
  const hsize_t size = count;
  const Hdf5Id file(H5Dget_space(dataset_.get()));
  const Hdf5Id memory(H5Screate_simple(1, &size, nullptr));
  H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, &start, nullptr, &size, nullptr);
  if (H5Dwrite(dataset_.get(), memory_.get(), memory.get(), file.get(), H5P_DEFAULT, rows) < 0) return false;
  rows_ = length;
  return true;
}

bool SessionTable::read(std::uint64_t first, std::uint64_t count, void* rows) const {
  const hsize_t start = first;
  const hsize_t size = count;
  const Hdf5Id file(H5Dget_space(dataset_.get()));
  const Hdf5Id memory(H5Screate_simple(1, &size, nullptr));
  return H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, &start, nullptr, &size, nullptr) >= 0 &&
         H5Dread(dataset_.get(), memory_.get(), memory.get(), file.get(), H5P_DEFAULT, rows) >= 0;
}

}  // namespace stillcut::record
