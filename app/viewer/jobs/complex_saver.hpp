// Exports the complex on screen in the background: a thread of its own writes the files.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/viewer/jobs/picture_saver.hpp"
#include "core/run/worker.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class ComplexSaver {
 public:
  // `wake` as in Worker.
  explicit ComplexSaver(std::function<void()> wake) : worker_(std::move(wake)) {}

  // `header`: the provenance of the answer. Throws std::runtime_error while another export runs.
  void start(std::shared_ptr<const Answer> answer, ComplexHeader header,
             const ExportRequest& request);
  // The files stay unchanged, unless the export is already complete.
  void cancel() { worker_.cancel(); }
  bool busy() const { return saving_.has_value(); }

  using Outcome = PictureSaver::Outcome;
  Outcome poll();  // events since the last call; on the main thread
  // Fills `info` for the line of progress.
  void describe(BusyInfo& info) const;

 private:
  std::optional<std::filesystem::path> saving_;
  std::chrono::steady_clock::time_point since_;
  Outcome outcome_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
