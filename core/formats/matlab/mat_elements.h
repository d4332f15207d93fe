// The elements of a MATLAB file of version 5 or 7, walked before matio sees it, which believes every length it reads.
// Source: MAT-File Format, The MathWorks, chapter 1. Thread: one; not real-time (file access).
#pragma once

#include <string>

#include "core/base/result.h"

namespace stillcut::record {

// The variables must tile the file; those inside an array, that array; and those of a compressed variable, what really
// comes out of it. Bounded memory, whatever the lengths say. An error names the first variable that lies.
Status checkMatElements(const std::string& path);

}  // namespace stillcut::record
