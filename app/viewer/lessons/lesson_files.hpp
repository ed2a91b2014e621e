// Finds and reads lessons on a thread of its own: those that come with the program, those in the
// user's folder, and one by its path.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/run/worker.hpp"
#include "ui/panels/lessons/lesson_memory.hpp"

namespace alphascope {

class LessonFiles {
 public:
  // `folders`, in the order in which their lessons are listed; those that are not there are left
  // out.
  LessonFiles(std::function<void()> wake, std::vector<std::filesystem::path> folders)
      : folders_(std::move(folders)), worker_(std::move(wake)) {}

  void read_shelf();
  // A lesson by its name or path; the shelf is read, too.
  void open(const std::string& name_or_path);
  bool busy() const { return worker_.activity().busy; }

  struct News {
    std::shared_ptr<const std::vector<ShelvedLesson>> shelf;
    std::shared_ptr<const Lesson> opened;
    std::string error;  // why it cannot be opened
  };
  News poll();  // on the main thread; what came since the last call

 private:
  void submit(const std::string& wanted);

  const std::vector<std::filesystem::path> folders_;
  News news_;
  Worker worker_;  // last: joined first
};

}  // namespace alphascope
