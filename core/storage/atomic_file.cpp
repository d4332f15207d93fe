#include "core/storage/atomic_file.h"

#include "core/storage/part_file.h"

namespace stillcut {

Status writeFileAtomically(const std::filesystem::path& path, std::string_view content) {
  PartFile file(path.string());
  if (!file.opened()) return file.failure();
  file.writeAt(0, content);
  return file.finish();
}

}  // namespace stillcut
