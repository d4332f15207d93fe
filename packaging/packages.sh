# The Debian packages Stillcut needs, a function that installs those that are missing, and the way every script configures
# a build folder. Sourced by app/run, tests/run and their kin; nothing else installs anything.

build_packages="g++ cmake ninja-build pkg-config ccache lld libeigen3-dev libfftw3-dev libsndfile1-dev
  libhdf5-dev libmatio-dev zlib1g-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libspdlog-dev libcomedi-dev
  libasound2-dev libiio-dev libsqlite3-dev libavformat-dev libavcodec-dev libavutil-dev
  libmosquitto-dev"
desktop_packages="libgl1-mesa-dev qt6-base-dev qt6-charts-dev libqt6opengl6-dev qt6-svg-dev qt6-serialport-dev
  qt6-serialbus-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools fonts-dejavu-core fonts-noto-cjk"
# clang with its runtime builds the sanitizers' presets, in two thirds of the time of GCC, and the fuzzer.
test_packages="libgtest-dev libgmock-dev libbenchmark-dev clang libclang-rt-14-dev clang-format clang-tidy git
  python3-h5py python3-scipy hdf5-tools poppler-utils xvfb"
# Real machines, devices and programs for the tests of links, sources and examples; a test whose peer is absent skips with one line.
peer_packages="linuxcnc-uspace linuxcnc-uspace-dev python3-pymodbus python3-serial-asyncio socat libmodbus-dev
  pulseaudio libasound2-plugins octave mosquitto mosquitto-clients openssl python3-protobuf postgresql"

# What makes and checks the Debian packages, those of the Python module and the Vamp plugin among them.
package_packages="python3-dev python3-numpy pybind11-dev vamp-plugin-sdk dpkg-dev gpg gpg-agent lintian help2man librsvg2-bin desktop-file-utils appstream man-db mmdebstrap"

# install_missing PACKAGE... : asks dpkg first, so that a second run costs nothing and needs no network.
install_missing() {
  local package missing=()
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "stillcut: needs root or sudo to install: ${missing[*]}" >&2; return 3; }
    root=(sudo)
  fi
  echo "stillcut: installing ${missing[*]}"
  "${root[@]}" apt-get update -qq </dev/null
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" \
    </dev/null >/dev/null
}

# Compiler cache: one place for all build folders, precompiled headers included.
use_ccache() {
  export CCACHE_BASEDIR="$1" CCACHE_NOHASHDIR=1
  export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
}

# configure PRESET NAME=VALUE... [or NAME?=VALUE...] : makes build/PRESET, or sets what differs there, so that nobody works
# in a folder as somebody else left it. NAME?=VALUE is for a new folder only. A second run costs nothing.
configure() {
  local preset=$1 cache=build/$1/CMakeCache.txt want options=()
  shift
  for want in "$@"; do
    [[ $want == *'?='* && -f $cache ]] && continue
    want=${want/'?='/=}
    grep -q "^${want%%=*}:[A-Z]*=${want#*=}\$" "$cache" 2>/dev/null || options+=("-D$want")
  done
  [ ${#options[@]} -eq 0 ] && [ -f "build/$preset/build.ninja" ] && return 0
  cmake --preset "$preset" "${options[@]}" >/dev/null
}

# build PRESET TARGET... : two jobs at a time (what 4 GiB of memory bear), said in steps: "building 210 of 480".
build() {
  local preset=$1
  shift
  NINJA_STATUS='@%f %t@' ninja -C "build/$preset" -j2 "$@" | awk '
    /^@[0-9]+ [0-9]+@/ {
      split(substr($0, 2), step, /[ @]/)
      if (step[1] % 20 == 0 || step[1] == step[2]) { print "stillcut: building " step[1] " of " step[2]; fflush() }
      next
    }
    /^ninja: (no work|Entering)/ { next }
    { print; fflush() }'
}
