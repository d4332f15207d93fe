#include "core/storage/journaled_driver.h"

#include <cstdlib>

namespace stillcut::record {
namespace {

struct DriverInfo {
  JournaledFile* file;
};

// The library's own part comes first, as it asks.
struct OpenFile {
  H5FD_t base;
  JournaledFile* file;
  haddr_t end;  // of what the library has allocated
};

OpenFile* opened(H5FD_t* file) {
  return reinterpret_cast<OpenFile*>(file);
}
const OpenFile* opened(const H5FD_t* file) {
  return reinterpret_cast<const OpenFile*>(file);
}

H5FD_t* openFile(const char* /*name*/, unsigned flags, hid_t access, haddr_t /*most*/) {
  const auto* info = static_cast<const DriverInfo*>(H5Pget_driver_info(access));
  if (info == nullptr || info->file == nullptr) return nullptr;
  // The library reads the first part before it has filled it: everything zero.
  auto* file = static_cast<OpenFile*>(std::calloc(1, sizeof(OpenFile)));
  if (file == nullptr) return nullptr;
  file->file = info->file;
  if ((flags & H5F_ACC_TRUNC) != 0) file->file->truncate(0);
  return &file->base;
}

herr_t closeFile(H5FD_t* file) {
  std::free(opened(file));
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  const JournaledFile* left = opened(a)->file;
  const JournaledFile* right = opened(b)->file;
  return left < right ? -1 : left == right ? 0 : 1;
}

herr_t query(const H5FD_t* /*file*/, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t endOfAllocated(const H5FD_t* file, H5FD_mem_t /*type*/) {
  return opened(file)->end;
}
herr_t setEndOfAllocated(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t end) {
  opened(file)->end = end;
  return 0;
}
haddr_t endOfFile(const H5FD_t* file, H5FD_mem_t /*type*/) {
  return opened(file)->file->size();
}

// Structure behind the end reads as zeros, which its checksums refuse; samples and rows have none and would be
// believed.
herr_t readBytes(H5FD_t* file, H5FD_mem_t type, hid_t /*transfer*/, haddr_t at, size_t size, void* out) {
  const std::uint64_t end = opened(file)->file->size();
  if (type == H5FD_MEM_DRAW && (at > end || size > end - at)) return -1;
  return opened(file)->file->read(at, {static_cast<std::byte*>(out), size}) ? 0 : -1;
}

// Chunks of samples and rows only ever grow: what is in them is written again as it was. All else is the library's own
// structure.
herr_t writeBytes(H5FD_t* file, H5FD_mem_t type, hid_t /*transfer*/, haddr_t at, size_t size, const void* bytes) {
  return opened(file)->file->write(at, {static_cast<const std::byte*>(bytes), size}, type == H5FD_MEM_DRAW) ? 0 : -1;
}

herr_t truncateFile(H5FD_t* file, hid_t /*transfer*/, hbool_t /*closing*/) {
  opened(file)->file->truncate(opened(file)->end);
  return 0;
}

// The journal's lock says who writes.
herr_t lockFile(H5FD_t* /*file*/, hbool_t /*forWriting*/) {
  return 0;
}
herr_t unlockFile(H5FD_t* /*file*/) {
  return 0;
}

hid_t driver() {
  static const hid_t kDriver = [] {
    static H5FD_class_t table{};
    table.name = "stillcut-journaled";
    table.maxaddr = static_cast<haddr_t>(1) << 62U;
    table.fc_degree = H5F_CLOSE_WEAK;
    table.fapl_size = sizeof(DriverInfo);
    table.open = openFile;
    table.close = closeFile;
    table.cmp = compare;
    table.query = query;
    table.get_eoa = endOfAllocated;
    table.set_eoa = setEndOfAllocated;
    table.get_eof = endOfFile;
    table.read = readBytes;
    table.write = writeBytes;
    table.truncate = truncateFile;
    table.lock = lockFile;
    table.unlock = unlockFile;
    const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    for (int i = 0; i < H5FD_MEM_NTYPES; ++i) table.fl_map[i] = map[i];
    return H5FDregister(&table);
  }();
  return kDriver;
}

}  // namespace

Hdf5Id journaledAccess(JournaledFile& file) {
  Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS));
  const DriverInfo info{&file};
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  if (H5Pset_driver(access.get(), driver(), &info) < 0) access.reset();
  return access;
}

}  // namespace stillcut::record
