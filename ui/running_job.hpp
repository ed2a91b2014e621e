// SPDX-License-Identifier: GPL-3.0-or-later
// The jobs that run while the user works in the window, as plain data for the panels.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace alphascope {

enum class JobId : std::uint8_t {
  fetching,   // a molecule is fetched from a server
  opening,    // a molecule or a session is read
  computing,  // a complex
  comparing,  // with CGAL
  listing,    // a folder is read for the file dialog
  lessons,    // lessons are looked for
  session,    // a session is written
  picture,    // a picture or a recording is drawn and written
  table,
  complex,          // a complex is exported
  benchmark_files,  // table and figures of a benchmark are written
  benchmark,
  deriving  // a result is made that follows from the molecule, such as a table
};

struct RunningJob {
  JobId id = JobId::computing;
  std::string title;         // "Opening 1aon.pdb.gz", "Saving figure.png"
  std::string step = {};     // "sample 3 of 16, 5 s left"; empty: unknown
  double share = -1;         // share done, 0 to 1; negative: unknown
  double seconds = 0;        // since its start
  double seconds_left = -1;  // of this step, or of all if there is no step; negative: unknown
  bool waits = false;        // for its turn
  std::string result = {};   // id of a derived result
};

using RunningJobs = std::vector<RunningJob>;  // in the order of JobId

// Whether the picture cannot change before this job ends. The user can go on working during all
// other jobs.
inline bool delays_picture(JobId id) {
  return id == JobId::opening || id == JobId::computing;
}

// The job that the picture waits for; null: none.
inline const RunningJob* awaited_job(const RunningJobs& jobs) {
  const auto at = std::find_if(jobs.begin(), jobs.end(),
                               [](const RunningJob& job) { return delays_picture(job.id); });
  return at == jobs.end() ? nullptr : &*at;
}

// The first job that fetches or writes a file; null: none.
inline const RunningJob* file_job(const RunningJobs& jobs) {
  const auto at = std::find_if(jobs.begin(), jobs.end(), [](const RunningJob& job) {
    return job.id == JobId::fetching ||
           (job.id >= JobId::session && job.id <= JobId::benchmark_files);
  });
  return at == jobs.end() ? nullptr : &*at;
}

}  // namespace alphascope
