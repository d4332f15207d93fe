# One function per kind of target, so that a room's CMakeLists.txt is a list of its files and its link line.

add_library(stillcut_options INTERFACE)
target_compile_features(stillcut_options INTERFACE cxx_std_20)
target_compile_options(stillcut_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  -Wimplicit-fallthrough -Werror
  -ffp-contract=off) # the same sums on every machine: replays are compared bit by bit
target_include_directories(stillcut_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
# The code is held to GCC's warnings; clang, for sanitizers and the fuzzer, has others.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  target_compile_options(stillcut_options INTERFACE -Wno-error)
endif()
if(STILLCUT_SANITIZE)
  target_compile_options(stillcut_options INTERFACE -fsanitize=${STILLCUT_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(stillcut_options INTERFACE -fsanitize=${STILLCUT_SANITIZE})
  # The instrumentation hides initialisations from GCC 12's flow analysis: it warns of uses that are not there.
  target_compile_options(stillcut_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  if(STILLCUT_SANITIZE MATCHES "undefined")
    target_compile_options(stillcut_options INTERFACE -fno-sanitize-recover=undefined)
  endif()
endif()
find_program(STILLCUT_LLD ld.lld)
if(STILLCUT_LLD)
  # Fast, and unlike Debian 12's mold (1.10.1) it never ends the read-only part of a program where no page ends.
  target_link_options(stillcut_options INTERFACE -fuse-ld=lld)
endif()

# stillcut_room(core_detect SOURCES a.cpp b.cpp LINKS core_model core_dsp [PRIVATE_LINKS ...])
# A static library; LINKS are the rooms its headers may include (checked by the include-edge test as well).
function(stillcut_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  if(ROOM_SOURCES)
    add_library(${name} STATIC ${ROOM_SOURCES})
    target_link_libraries(${name} PUBLIC stillcut_options ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE stillcut_options ${ROOM_LINKS})
  endif()
endfunction()

# A test that hangs is ended after this many seconds. A thread sanitizer takes up to a hundred times as long.
set(test_timeout 300)
if(STILLCUT_SANITIZE)
  set(test_timeout 1200)
endif()

# stillcut_test(unit_detect SOURCES ... LINKS ...) : one gtest program, its cases registered with ctest.
function(stillcut_test name)
  cmake_parse_arguments(TEST "" "" "SOURCES;LINKS;ENVIRONMENT" ${ARGN})
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE stillcut_options test_support ${TEST_LINKS} GTest::gmock GTest::gtest_main)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${test_timeout} LABELS ${name} ENVIRONMENT "${TEST_ENVIRONMENT}")
endfunction()
