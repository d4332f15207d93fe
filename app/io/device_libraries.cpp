#include "app/io/device_libraries.h"

#ifdef STILLCUT_ALSA
#include <alsa/asoundlib.h>
#endif
#ifdef STILLCUT_COMEDI
#include <comedilib.h>
#endif
#ifdef STILLCUT_IIO
#include <iio.h>
#endif
#ifdef STILLCUT_SERIAL
#include <QtGlobal>
#endif

namespace stillcut::app {

std::vector<std::string> deviceLibraries() {
  std::vector<std::string> libraries;
#ifdef STILLCUT_ALSA
  libraries.push_back(std::string("ALSA ") + ::snd_asoundlib_version());
#endif
#ifdef STILLCUT_COMEDI
  libraries.push_back("Comedilib " + std::to_string(COMEDILIB_VERSION_MAJOR) + "." +
                      std::to_string(COMEDILIB_VERSION_MINOR) + "." + std::to_string(COMEDILIB_VERSION_MICRO));
#endif
#ifdef STILLCUT_IIO
  unsigned major = 0;
  unsigned minor = 0;
  char commit[8] = {};
  ::iio_library_get_version(&major, &minor, commit);
  libraries.push_back("libiio " + std::to_string(major) + "." + std::to_string(minor));
#endif
#ifdef STILLCUT_SERIAL
  libraries.push_back(std::string("Qt ") + qVersion());
#endif
  return libraries;
}

}  // namespace stillcut::app
