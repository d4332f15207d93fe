// What an HDF5 file is, before something else takes its place. Thread: any; waits for a process that looks.
#pragma once

#include <string>

namespace stillcut::record {

// "other": no session. "session". "simulated": a session without markers that can be run again. "damaged": nobody can
// tell, or the process that looked has died of it.
std::string kindOfHdf5(const std::string& path);

}  // namespace stillcut::record
