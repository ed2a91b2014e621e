// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all jobs of the window, and those that need no session: the folder of the file
// dialog, the pages of the user guide, the search for a GPU, and the benchmark.
#pragma once

#include <functional>
#include <future>

#include "app/session/machine.hpp"
#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/jobs/benchmark.hpp"
#include "app/viewer/jobs/folder_reader.hpp"
#include "app/viewer/jobs/guide_reader.hpp"
#include "app/viewer/jobs/job_list.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class WindowJobs {
 public:
  // Begins the search for a GPU. `wake` as in Worker.
  WindowJobs(ViewState& state, DueFrames& due, const std::function<void()>& wake,
             EngineFactory make_engine);

  JobList& list() { return list_; }
  // Adds the folder and the benchmark to the list. Call when others have added their jobs: of two
  // notices in one frame, that of the later job stays.
  void list_own();

  // Takes in the result of the search for a GPU. Returns true once, when the search has ended.
  bool take_machine();
  void follow_browser();  // lists the folder of the file dialog
  void follow_guide();    // reads the user guide when it is opened first
  Benchmark& benchmark() { return benchmark_; }
  const Benchmark& benchmark() const { return benchmark_; }
  bool busy() const;  // a folder or the guide is read, or the search for a GPU goes on

 private:
  ViewState& state_;
  DueFrames& due_;
  JobList list_;
  FolderReader folder_reader_;
  GuideReader guide_reader_;
  std::future<MachineInfo> machine_;  // in the background: the search for a GPU can take a second
  Benchmark benchmark_;
};

}  // namespace alphascope
