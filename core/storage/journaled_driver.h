// Lets the HDF5 library read and write through a JournaledFile (a "virtual file driver" in its words).
// Thread: its owner's; not real-time.
#pragma once

#include <hdf5.h>

#include "core/storage/hdf5_file.h"
#include "core/storage/journaled_file.h"

namespace stillcut::record {

// A file access list that opens `file`, which must outlive the HDF5 file; the name given to the library only shows in
// its messages. Commits are the caller's: after a flush, and after closing.
Hdf5Id journaledAccess(JournaledFile& file);

}  // namespace stillcut::record
