// What every test includes: the standard library and GoogleTest.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "packaging/cmake/precompiled/standard.h"
