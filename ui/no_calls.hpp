// SPDX-License-Identifier: GPL-3.0-or-later
// Calls that do nothing. A list of commands that is only printed needs calls, but makes none.
#pragma once

#include "ui/calls.hpp"

namespace alphascope {

struct NoFileCalls : FileCalls {
  void open(const std::filesystem::path&) override {}
  void open_session(const std::filesystem::path&) override {}
  void close_file() override {}
  void fetch(const MoleculeId&, bool) override {}
  void save_session(const std::filesystem::path&) override {}
  void continue_session(const std::filesystem::path&) override {}
  void fetch_for_session() override {}
  void abandon_session() override {}
  void forget_recent() override {}
  void undo() override {}
  void redo() override {}
  void copy(const std::string&) override {}
  void quit() override {}
};

struct NoViewCalls : ViewCalls {
  void reset() override {}
  void zoom(double) override {}
  void look_from(const std::array<double, 3>&) override {}
  void look_across(const RealPoint&) override {}
  void zoom_to_selection() override {}
  void zoom_to(const RefSet&) override {}
  void centre_on(const RefSet&) override {}
  void save(const std::string&) override {}
  void go_to(const std::string&) override {}
  void back() override {}
  void forward() override {}
  void open_context_menu() override {}
};

struct NoJobCalls : JobCalls {
  void save_picture(const ScreenshotRequest&) override {}
  void record(const RecordRequest&) override {}
  void save_table(const SaveTableRequest&) override {}
  void export_complex(const ExportRequest&) override {}
  void compare() override {}
  void compute_anew() override {}
  void run_benchmark() override {}
  void export_benchmark() override {}
  void cancel(JobId) override {}
  void cancel_result(const std::string&) override {}
};

struct NoLessonCalls : LessonCalls {
  void open(const std::string&) override {}
  void next() override {}
  void back() override {}
  void restart_step() override {}
  void reveal() override {}
  void close() override {}
};

class NoCalls {
 public:
  Calls calls() { return {files_, view_, jobs_, lessons_}; }

 private:
  NoFileCalls files_;
  NoViewCalls view_;
  NoJobCalls jobs_;
  NoLessonCalls lessons_;
};

}  // namespace alphascope
