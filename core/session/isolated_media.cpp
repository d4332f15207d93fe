#include "core/formats/hdf5/isolated_messages.h"
#include "core/formats/media/media_import.h"
#include "core/session/isolated_server.h"

namespace stillcut::record {

int serveMedia(int peer, const std::string& path, const std::string& options) {
  limitIsolated();
  return serveOpened(peer, openMedia(path, apart::optionsFrom(options)));
}

}  // namespace stillcut::record
