// What panels and commands ask the program to do, as four small interfaces. A call made while a
// frame is drawn is carried out after it, in the order of calls; of two equal ones the later
// replaces the earlier. Nothing here blocks: what takes long shows its share done elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/geometry/real_point.hpp"

namespace alphascope {

class RefSet;
struct ExportRequest;
struct RecordRequest;
struct SaveTableRequest;
struct ScreenshotRequest;

// Files, the history of the open one, and the clipboard.
class FileCalls {
 public:
  virtual ~FileCalls() = default;
  virtual void open(
      const std::filesystem::path& file) = 0;  // a molecule, or a session by its ending
  virtual void open_session(const std::filesystem::path& file) = 0;
  virtual void save_session(const std::filesystem::path& file) = 0;
  // The session that waits for an answer (ViewState::session_problem): opened with this molecule in
  // place of the one that it names, or with the files as they are where the path is empty.
  virtual void go_on_with_session(const std::filesystem::path& molecule) = 0;
  virtual void give_session_up() = 0;
  virtual void forget_recent() = 0;
  virtual void undo() = 0;
  virtual void redo() = 0;
  virtual void copy(const std::string& text) = 0;  // into the clipboard
  virtual void quit() = 0;
};

// The camera. Points are in Å, in the coordinates of the file.
class ViewCalls {
 public:
  virtual ~ViewCalls() = default;
  virtual void reset() = 0;                                       // shows the whole molecule
  virtual void zoom(double factor) = 0;                           // how many times as large
  virtual void look_from(const std::array<double, 3>& side) = 0;  // from the middle to the viewer
  virtual void look_across(
      const RealPoint& line) = 0;  // a line; the view turns no more than it must
  virtual void zoom_to_selection() = 0;
  virtual void zoom_to(const RefSet& items) = 0;    // they fill the view
  virtual void centre_on(const RefSet& items) = 0;  // they become its middle, at the same size
  virtual void save(const std::string& name) = 0;   // in place of a camera of that name
  virtual void go_to(const std::string& name) = 0;
  virtual void open_context_menu() = 0;  // of what is under the mouse
};

// computing: opening, computing and comparing; where nothing of it goes on, saving.
enum class Job : std::uint8_t { computing, comparing, saving, benchmark };

// Work that takes long.
class JobCalls {
 public:
  virtual ~JobCalls() = default;
  virtual void save_picture(const ScreenshotRequest& request) = 0;
  virtual void record(const RecordRequest& request) = 0;
  virtual void save_table(const SaveTableRequest& request) = 0;
  virtual void export_complex(const ExportRequest& request) = 0;
  virtual void compare() = 0;
  virtual void compute_anew() = 0;  // set-up included, for its cold time
  virtual void run_benchmark() = 0;
  virtual void export_benchmark() = 0;
  virtual void cancel(Job job) = 0;
};

class LessonCalls {
 public:
  virtual ~LessonCalls() = default;
  virtual void open(const std::string& lesson) = 0;  // a name or a path
  virtual void next() = 0;
  virtual void back() = 0;
  virtual void again() = 0;
  virtual void reveal() = 0;  // the answer to the step's question
  virtual void close() = 0;
};

struct Calls {
  FileCalls& files;
  ViewCalls& view;
  JobCalls& jobs;
  LessonCalls& lessons;
};

}  // namespace alphascope
