// A folder of recordings: names by job, tool and time, and what may be deleted when.
// Thread: not real-time (file access).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/session/file/session_writer.h"
#include "core/session/record_params.h"

namespace stillcut::record {

// "FOLDER/JOB/TOOL/2026-11-21_19-02-45.h5", in UTC; the folders are made, and a name that is taken gets a number. What
// no file name may hold becomes '-', a long name is cut between two letters; an empty job or tool is called "job" or
// "tool".
Result<std::string> newSessionPath(const std::string& folder, const std::string& job, const std::string& tool,
                                   std::int64_t utc_ns);

// `wanted`, "cut.h5"; where a file or the journal of one is under that name, the first of "cut-2.h5", "cut-3.h5" ...
// that is free. Nothing that was recorded is ever recorded over.
std::string freeSessionPath(const std::string& wanted);
// An error: fewer than `bytes` are left on the disk of `path`, which need not be there yet. What cannot be asked for is
// taken as enough.
Status checkRoom(const std::string& path, std::uint64_t bytes);
// Names a new file; an error when its folder cannot be made.
using NextPath = std::function<Result<std::string>()>;
// A session under the next name that nobody has. Other programs may ask for names at the same moment: whoever comes
// second gets the one after it.
Result<std::unique_ptr<SessionWriter>> createUnderNextName(const NextPath& nextPath, const SessionHeader& header,
                                                           const SessionWriterOptions& options);
enum class MayReplace : std::uint8_t { NoSession, SimulatedSession };  // the latter: without markers
// An error: what is at `path` is a session, or may be one, and something else is about to take its place.
Status checkReplaceable(const std::string& path, MayReplace may);

struct Deleted {
  std::string file;
  std::string why;        // "older than 90 days"
  std::string problem{};  // not empty: it should have gone and is still there, "Permission denied"
};
// Deletes sessions below `folder` that are older than plan.keepFor, and then the oldest until the rest has at most
// plan.keepBytes. A plan that keeps features alone deletes such files by plan.history instead, and no others sooner.
// Never one with a marker, nor one with a journal (still written, or cut off and not yet opened), nor anything that is
// no session. Age goes by the file's last change. What cannot be deleted is told and passed over, and no newer one goes
// in its place: room that is short is no reason not to record.
std::vector<Deleted> applyRetention(const std::string& folder, const RecordPlan& plan, std::int64_t now_utc_ns);

}  // namespace stillcut::record
