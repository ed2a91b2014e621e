// SPDX-License-Identifier: GPL-3.0-or-later
// Finds and reads lessons on a thread of its own. They come with the program, lie in the user's
// folder, or are named by a path.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/run/worker.hpp"
#include "ui/panels/lessons/lesson_state.hpp"

namespace alphascope {

class LessonFiles {
 public:
  // `folders` in the order in which their lessons are listed. Missing folders are skipped.
  LessonFiles(std::function<void()> wake, std::vector<std::filesystem::path> folders)
      : folders_(std::move(folders)), worker_(std::move(wake)) {}

  void read_list();
  // Opens a lesson by name or path, and reads the shelf, too.
  void open(const std::string& name_or_path);
  bool busy() const { return worker_.activity().busy; }

  struct News {
    std::shared_ptr<const std::vector<ListedLesson>> shelf;
    std::shared_ptr<const Lesson> opened;
    std::string error;  // why the lesson cannot be opened
  };
  News poll();  // events since the last call; on the main thread

 private:
  void submit(const std::string& wanted);

  const std::vector<std::filesystem::path> folders_;
  News news_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
