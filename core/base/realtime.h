// Marks for the sample path. A function marked STILLCUT_RT runs between device and gate after prepare(): it must not
// allocate, lock, format text, do I/O or throw (house rule 5; counted by tests/component/rt_path_test.cpp). Any thread.
#pragma once

#define STILLCUT_RT noexcept
