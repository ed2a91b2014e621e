// SPDX-License-Identifier: GPL-3.0-or-later
// Calls from panels and commands to the program, as four small interfaces. A call made while a
// frame is drawn is carried out after it, in the order of calls. A later call of the same function
// replaces the earlier one; cancel() does so for the same job only. No call blocks: long jobs
// report their progress in ViewState::jobs.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "ui/running_job.hpp"

namespace alphascope {

class RefSet;
struct ExportRequest;
struct MoleculeId;
struct RealPoint;
struct RecordRequest;
struct SaveTableRequest;
struct ScreenshotRequest;

// Calls on files, on the history of the open file, and on the clipboard.
class FileCalls {
 public:
  virtual ~FileCalls() = default;
  virtual void open(
      const std::filesystem::path& file) = 0;  // a molecule, or a session if its name ends so
  virtual void open_session(const std::filesystem::path& file) = 0;
  virtual void close_file() = 0;  // closes the molecule and cancels its jobs
  // Fetches the molecule, unless it was fetched before, and opens it. `again`: fetches it anyway.
  virtual void fetch(const MoleculeId& id, bool again) = 0;
  virtual void save_session(const std::filesystem::path& file) = 0;
  // Opens the session that waits for an answer (ViewState::session_problem). `molecule` replaces
  // the molecule that the session names. An empty path opens the session with its files as they are
  // now.
  virtual void continue_session(const std::filesystem::path& molecule) = 0;
  // Fetches the molecule of that session anew, then opens it.
  virtual void fetch_for_session() = 0;
  virtual void abandon_session() = 0;
  virtual void forget_recent() = 0;
  virtual void undo() = 0;
  virtual void redo() = 0;
  virtual void copy(const std::string& text) = 0;  // into the clipboard
  virtual void quit() = 0;
};

// Calls that move the camera. Points are in Å, in the coordinates of the file.
class ViewCalls {
 public:
  virtual ~ViewCalls() = default;
  virtual void reset() = 0;              // shows the whole molecule
  virtual void zoom(double factor) = 0;  // factor on sizes in the picture
  // `side` is the direction from the middle of the view to the viewer.
  virtual void look_from(const std::array<double, 3>& side) = 0;
  // Turns the view until it looks across this line: as little as possible, but not to a view from
  // above or below.
  virtual void look_across(const RealPoint& line) = 0;
  virtual void zoom_to_selection() = 0;
  virtual void zoom_to(const RefSet& items) = 0;  // fills the view with the items
  // Moves the items to the middle and keeps their size.
  virtual void centre_on(const RefSet& items) = 0;
  virtual void save(const std::string& name) = 0;  // replaces a camera of that name
  virtual void go_to(const std::string& name) = 0;
  virtual void back() = 0;               // to the view before the last move
  virtual void forward() = 0;            // to the view that back() left
  virtual void open_context_menu() = 0;  // the menu is about the thing under the mouse
};

// Calls that start or cancel jobs that take long.
class JobCalls {
 public:
  virtual ~JobCalls() = default;
  virtual void save_picture(const ScreenshotRequest& request) = 0;
  virtual void record(const RecordRequest& request) = 0;
  virtual void save_table(const SaveTableRequest& request) = 0;
  virtual void export_complex(const ExportRequest& request) = 0;
  virtual void compare() = 0;
  virtual void compute_anew() = 0;  // includes the set-up, so it measures a cold time
  virtual void run_benchmark() = 0;
  virtual void export_benchmark() = 0;
  // Cancels the job of this kind, if one runs. Opening and computing are cancelled together,
  // because the picture waits for both.
  virtual void cancel(JobId job) = 0;
  virtual void cancel_result(const std::string& id) = 0;  // a derived result that is being made
};

class LessonCalls {
 public:
  virtual ~LessonCalls() = default;
  virtual void open(const std::string& lesson) = 0;  // its name or its path
  virtual void next() = 0;
  virtual void back() = 0;
  virtual void restart_step() = 0;
  virtual void reveal() = 0;  // shows the answer to the step's question
  virtual void close() = 0;
};

struct Calls {
  FileCalls& files;
  ViewCalls& view;
  JobCalls& jobs;
  LessonCalls& lessons;
};

}  // namespace alphascope
