// SPDX-License-Identifier: GPL-3.0-or-later
// Records the calls of panels and commands, for tests without a program.
#pragma once

#include <optional>

#include "core/document/export/complex_export.hpp"
#include "core/document/fetch/molecule_id.hpp"
#include "ui/no_calls.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"

namespace alphascope::testing {

struct Asked {
  std::optional<std::filesystem::path> open, save_session;
  std::optional<MoleculeId> fetch;
  std::string copied, cancelled_result;
  std::optional<ScreenshotRequest> screenshot;
  std::optional<ExportRequest> export_complex;
  bool reset_view = false, cancel = false, compute_anew = false;
  bool run_benchmark = false, cancel_benchmark = false, export_benchmark = false;
};

// Records calls in `asked`. Calls that no test needs have no effect.
class AskedCalls {
 public:
  explicit AskedCalls(Asked& asked) : files_(asked), view_(asked), jobs_(asked) {}
  Calls calls() { return {files_, view_, jobs_, lessons_}; }

 private:
  struct Files : NoFileCalls {
    explicit Files(Asked& asked) : asked(asked) {}
    void open(const std::filesystem::path& file) override { asked.open = file; }
    void save_session(const std::filesystem::path& file) override { asked.save_session = file; }
    void fetch(const MoleculeId& id, bool) override { asked.fetch = id; }
    void copy(const std::string& text) override { asked.copied = text; }
    Asked& asked;
  } files_;
  struct View : NoViewCalls {
    explicit View(Asked& asked) : asked(asked) {}
    void reset() override { asked.reset_view = true; }
    Asked& asked;
  } view_;
  struct Jobs : NoJobCalls {
    explicit Jobs(Asked& asked) : asked(asked) {}
    void save_picture(const ScreenshotRequest& request) override { asked.screenshot = request; }
    void export_complex(const ExportRequest& request) override { asked.export_complex = request; }
    void compute_anew() override { asked.compute_anew = true; }
    void run_benchmark() override { asked.run_benchmark = true; }
    void export_benchmark() override { asked.export_benchmark = true; }
    void cancel(JobId job) override {
      (job == JobId::benchmark ? asked.cancel_benchmark : asked.cancel) = true;
    }
    void cancel_result(const std::string& id) override { asked.cancelled_result = id; }
    Asked& asked;
  } jobs_;
  NoLessonCalls lessons_;
};

}  // namespace alphascope::testing
