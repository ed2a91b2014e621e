// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the thesis' suite for the window on a thread of its own. Its rows appear as they are
// measured. Another job writes them to files.
#pragma once

#include <chrono>
#include <memory>
#include <mutex>

#include "app/bench/thesis_suite.hpp"
#include "app/session/session.hpp"
#include "app/viewer/jobs/file_job.hpp"
#include "app/viewer/jobs/job_list.hpp"
#include "core/run/worker.hpp"
#include "ui/panels/dialogs/benchmark_info.hpp"

namespace alphascope {

// Reads "0, 1.4, 3" as numbers separated by blanks or semicolons, with commas allowed after them.
// Throws std::invalid_argument that names the faulty part.
std::vector<Alpha> parse_alphas(const std::string& text);

class Benchmark : public ViewerJob {
 public:
  // `info` gets the rows as they are measured, and must outlive this. `wake` as in Worker.
  Benchmark(std::function<void()> wake, EngineFactory factory, BenchmarkInfo& info)
      : factory_(std::move(factory)),
        info_(info),
        files_(JobId::benchmark_files, wake),
        worker_(std::move(wake)) {}

  // Measures the open molecule at the present solvent radius. A fault of the controls goes to
  // info.error.
  void start(const SessionState& session, const BenchmarkSettings& controls);
  // Begins to write thesis.csv and the figures; all appear complete, or none. A failure goes to
  // info.error.
  void save(const BenchmarkSettings& controls);
  bool busy() const { return running_; }
  bool exports() const { return files_.busy(); }

  // Either a run or an export.
  std::optional<RunningJob> running() const override;
  void cancel() override;
  JobNews poll() override;

 private:
  struct Arrived {
    std::mutex mutex;
    std::vector<ThesisRow> rows;
  };
  void finish();
  JobNews poll_files();

  EngineFactory factory_;
  BenchmarkInfo& info_;
  std::chrono::steady_clock::time_point since_;
  std::shared_ptr<Arrived> arrived_;
  // The report of the last run, which may have only its first rows. Then the rows so far of the
  // running one. Either may be null.
  std::shared_ptr<const ThesisReport> report_;
  std::shared_ptr<ThesisReport> partial_;
  bool cancelled_ = false;
  std::string failure_;
  bool running_ = false, finished_ = false;
  // Last members, so that their threads are joined first.
  FileJob files_;
  Worker worker_;
};

}  // namespace alphascope
