// What every command includes: the standard library and the parser of the command line.
#pragma once

#include <CLI/CLI.hpp>

#include "packaging/cmake/precompiled/standard.h"
