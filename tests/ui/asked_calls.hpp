// Records the calls of panels and commands, for tests without a program.
#pragma once

#include <optional>

#include "core/document/export/complex_export.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/picture_memory.hpp"

namespace alphascope::testing {

struct Asked {
  std::optional<std::filesystem::path> open, save_session;
  std::optional<ScreenshotRequest> screenshot;
  std::optional<ExportRequest> export_complex;
  bool reset_view = false, cancel = false, compute_anew = false;
  bool run_benchmark = false, cancel_benchmark = false, export_benchmark = false;
};

// Records calls in `asked`. Calls that no test looks for are dropped.
class AskedCalls {
 public:
  explicit AskedCalls(Asked& asked) : files_(asked), view_(asked), jobs_(asked) {}
  Calls calls() { return {files_, view_, jobs_, lessons_}; }

 private:
  struct Files : FileCalls {
    explicit Files(Asked& asked) : asked(asked) {}
    void open(const std::filesystem::path& file) override { asked.open = file; }
    void open_session(const std::filesystem::path&) override {}
    void save_session(const std::filesystem::path& file) override { asked.save_session = file; }
    void go_on_with_session(const std::filesystem::path&) override {}
    void give_session_up() override {}
    void forget_recent() override {}
    void undo() override {}
    void redo() override {}
    void copy(const std::string&) override {}
    void quit() override {}
    Asked& asked;
  } files_;
  struct View : ViewCalls {
    explicit View(Asked& asked) : asked(asked) {}
    void reset() override { asked.reset_view = true; }
    void zoom(double) override {}
    void look_from(const std::array<double, 3>&) override {}
    void look_across(const RealPoint&) override {}
    void zoom_to_selection() override {}
    void zoom_to(const RefSet&) override {}
    void centre_on(const RefSet&) override {}
    void save(const std::string&) override {}
    void go_to(const std::string&) override {}
    void open_context_menu() override {}
    Asked& asked;
  } view_;
  struct Jobs : JobCalls {
    explicit Jobs(Asked& asked) : asked(asked) {}
    void save_picture(const ScreenshotRequest& request) override { asked.screenshot = request; }
    void record(const RecordRequest&) override {}
    void save_table(const SaveTableRequest&) override {}
    void export_complex(const ExportRequest& request) override { asked.export_complex = request; }
    void compare() override {}
    void compute_anew() override { asked.compute_anew = true; }
    void run_benchmark() override { asked.run_benchmark = true; }
    void export_benchmark() override { asked.export_benchmark = true; }
    void cancel(Job job) override {
      (job == Job::benchmark ? asked.cancel_benchmark : asked.cancel) = true;
    }
    Asked& asked;
  } jobs_;
  struct Lessons : LessonCalls {
    void open(const std::string&) override {}
    void next() override {}
    void back() override {}
    void again() override {}
    void reveal() override {}
    void close() override {}
  } lessons_;
};

}  // namespace alphascope::testing
