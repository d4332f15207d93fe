# One function per kind of target, so that a room's CMakeLists.txt is a list of its files and its link line.

add_library(stillcut_options INTERFACE)
target_compile_features(stillcut_options INTERFACE cxx_std_20)
target_compile_options(stillcut_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  -Wimplicit-fallthrough -Werror
  -ffp-contract=off # the same sums on every machine: replays are compared bit by bit
  # Libraries are also linked into modules that other programs load (Python's, Vamp's). Nothing of ours is replaced from
  # outside, so that calls stay as direct as in a program.
  -fPIC -fno-semantic-interposition)
target_include_directories(stillcut_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
# GCC 12 sees a copy out of bounds in std::string's operator+ (its bug 105651), and no longer holds it back as a system
# header's where that header is precompiled. The address sanitizer looks for real ones.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(stillcut_options INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
endif()
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

# One precompiled header for all targets of a kind (standard, cli, test, gui, widgets, widgets_test), made when the first one asks for it.
# Targets that are compiled with other flags than their kind (kernels, core_stability) go without.
option(STILLCUT_PRECOMPILE "Precompiled headers: off shows sources that do not include what they use" ON)
set(stillcut_precompiled ${CMAKE_CURRENT_LIST_DIR}/precompiled)
function(stillcut_precompile target kind)
  if(NOT STILLCUT_PRECOMPILE)
    return()
  endif()
  set(holder precompiled_${kind})
  if(NOT TARGET ${holder})
    add_library(${holder} OBJECT EXCLUDE_FROM_ALL ${stillcut_precompiled}/holder.cpp)
    target_link_libraries(${holder} PRIVATE stillcut_options)
    if(kind MATCHES "^widgets")
      target_link_libraries(${holder} PRIVATE Qt6::Widgets)
    elseif(kind STREQUAL cli)
      target_link_libraries(${holder} PRIVATE CLI11::CLI11)
      target_compile_options(${holder} PRIVATE ${stillcut_command_options})
    elseif(kind STREQUAL gui)
      target_link_libraries(${holder} PRIVATE Qt6::Gui)
    endif()
    if(kind MATCHES "test$")
      target_compile_options(${holder} PRIVATE ${stillcut_test_options})
      target_link_libraries(${holder} PRIVATE GTest::gmock)
    endif()
    set_target_properties(${holder} PROPERTIES AUTOMOC OFF AUTORCC OFF)
    target_precompile_headers(${holder} PRIVATE ${stillcut_precompiled}/${kind}.h)
  endif()
  target_precompile_headers(${target} REUSE_FROM ${holder})
endfunction()
# Tests are compiled once and run once: less optimised they are ready sooner. What they test is optimised as always.
set(stillcut_test_options -O1)
# Commands read options and print: CLI11 is the most of what they compile, and nothing in them is hot.
set(stillcut_command_options -O1)

# stillcut_room(core_detect SOURCES a.cpp b.cpp LINKS core_model core_dsp [PRIVATE_LINKS ...])
# A static library; LINKS are the rooms its headers may include (checked by the include-edge test as well).
function(stillcut_room name)
  cmake_parse_arguments(ROOM "NOT_PRECOMPILED" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  if(ROOM_SOURCES)
    add_library(${name} STATIC ${ROOM_SOURCES})
    target_link_libraries(${name} PUBLIC stillcut_options ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
    if(NOT ROOM_NOT_PRECOMPILED)
      if(name MATCHES "^ui_(base|models)$")
        stillcut_precompile(${name} gui)
      elseif(name MATCHES "^ui_|^app_session$")
        stillcut_precompile(${name} widgets)
      else()
        stillcut_precompile(${name} standard)
      endif()
    endif()
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
  target_compile_options(${name} PRIVATE ${stillcut_test_options})
  if("${TEST_LINKS}" MATCHES "ui_|app_session")
    stillcut_precompile(${name} widgets_test)
  else()
    stillcut_precompile(${name} test)
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${test_timeout} LABELS ${name} ENVIRONMENT "${TEST_ENVIRONMENT}")
endfunction()
