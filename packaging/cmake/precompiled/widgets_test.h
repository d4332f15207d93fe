// What every test of the screens includes.
#pragma once

#include "packaging/cmake/precompiled/widgets.h"
#include "packaging/cmake/precompiled/test.h"
