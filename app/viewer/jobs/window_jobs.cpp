// SPDX-License-Identifier: GPL-3.0-or-later
// Puts what the jobs without a session have found into the state.
#include "app/viewer/jobs/window_jobs.hpp"

#include <chrono>
#include <utility>

#include "app/viewer/resources.hpp"
#include "ui/panels/dialogs/browser_state.hpp"

namespace alphascope {

WindowJobs::WindowJobs(ViewState& state, DueFrames& due, const std::function<void()>& wake,
                       EngineFactory make_engine)
    : state_(state),
      due_(due),
      list_(state, due),
      folder_reader_(wake),
      guide_reader_(wake, docs_folder()),
      machine_(std::async(std::launch::async,
                          [wake] {
                            const MachineInfo& machine = machine_info();
                            wake();
                            return machine;
                          })),
      benchmark_(wake, std::move(make_engine), state.benchmark) {}

void WindowJobs::list_own() {
  list_.add(folder_reader_);
  list_.add(benchmark_);
}

bool WindowJobs::take_machine() {
  if (state_.gpu || machine_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return false;
  }
  state_.gpu = machine_.get().gpu;
  due_.ask();
  return true;
}

void WindowJobs::follow_browser() {
  state_.listing = folder_reader_.listing(wanted_listing(state_.browser));
}

void WindowJobs::follow_guide() {
  if (guide_reader_.poll(state_.guide)) due_.ask();
}

bool WindowJobs::busy() const {
  return !state_.gpu || folder_reader_.busy() || guide_reader_.busy();
}

}  // namespace alphascope
