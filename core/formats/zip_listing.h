// What a ZIP archive holds, from its directory at the end. Source: APPNOTE.TXT 6.3, PKWARE: sections 4.3.12 and 4.3.16.
// Thread: its caller's; not real-time.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/formats/byte_stream.h"

namespace stillcut::record {

struct ZipEntry {
  std::string name;
  FilePart part;
};

// Only stored and deflated entries; encrypted ones and archives above 4 GiB are refused. Sizes are believed as far as
// the file has bytes for them.
Result<std::vector<ZipEntry>> listZip(const std::string& path);

}  // namespace stillcut::record
