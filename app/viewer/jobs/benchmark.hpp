// Runs the thesis' suite for the window: on a thread of its own, its rows shown as they come.
#pragma once

#include <memory>
#include <mutex>

#include "app/bench/thesis_suite.hpp"
#include "app/session/session.hpp"
#include "core/run/worker.hpp"
#include "ui/panels/dialogs/benchmark_info.hpp"

namespace alphascope {

// "0, 1.4, 3" as numbers: blanks or semicolons between them. Throws std::invalid_argument that says
// what is none.
std::vector<Alpha> parse_alphas(const std::string& text);

class Benchmark {
 public:
  Benchmark(std::function<void()> wake, EngineFactory factory)
      : factory_(std::move(factory)), worker_(std::move(wake)) {}

  // Of the open molecule at the present solvent radius. What is wrong with the controls becomes
  // info.error.
  void start(const SessionState& session, const BenchmarkControls& controls, BenchmarkInfo& info);
  void cancel() { worker_.cancel(); }
  // thesis.csv and the figures; failures become info.error.
  void save(const BenchmarkControls& controls, BenchmarkInfo& info) const;

  bool busy() const { return running_; }
  // On the main thread, when woken. True when `info` has changed.
  bool poll(BenchmarkInfo& info);

 private:
  struct Arrived {
    std::mutex mutex;
    std::vector<ThesisRow> rows;
  };
  void finish(BenchmarkInfo& info);

  EngineFactory factory_;
  std::shared_ptr<Arrived> arrived_;
  // The last one; while it is measured, its rows so far.
  std::shared_ptr<const ThesisReport> report_;
  std::shared_ptr<ThesisReport> partial_;
  bool cancelled_ = false;
  std::string failure_;
  bool running_ = false, finished_ = false;
  Worker worker_;  // last: joined first
};

}  // namespace alphascope
