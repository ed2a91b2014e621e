// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the lessons of the folders, and reads one by name or path.
#include "app/viewer/lessons/lesson_files.hpp"

#include <algorithm>
#include <utility>

#include "app/options/did_you_mean.hpp"
#include "core/files/read_error.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".md";
constexpr std::size_t kMostFiles = 500;  // in a folder

// "03_power_diagram.md" has the name power_diagram. The number only sorts the list.
std::string name_of(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t behind = stem.find_first_not_of("0123456789");
  const bool numbered = behind != std::string::npos && behind > 0 && stem[behind] == '_';
  return printable(numbered ? stem.substr(behind + 1) : stem);
}

std::vector<fs::path> lessons_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->path().extension() != kEnding || !at->is_regular_file(ignored)) continue;
    files.push_back(at->path());
    if (files.size() == kMostFiles) break;
  }
  std::sort(files.begin(), files.end());
  return files;
}

ListedLesson read(const fs::path& file) {
  ListedLesson shelved{.name = name_of(file)};
  try {
    shelved.lesson = std::make_shared<const Lesson>(load_lesson(file));
  } catch (const ReadError& error) {
    shelved.problem = error.what();
  }
  return shelved;
}

std::vector<ListedLesson> read_all(const std::vector<fs::path>& folders,
                                   const RunContext& context) {
  std::vector<ListedLesson> all;
  for (const fs::path& folder : folders) {
    for (const fs::path& file : lessons_in(folder)) {
      context.cancel.throw_if_cancelled();
      all.push_back(read(file));
    }
  }
  return all;
}

bool is_path(const std::string& text) {
  std::error_code ignored;
  return text.find('/') != std::string::npos || fs::path(text).extension() == kEnding ||
         fs::is_regular_file(text, ignored);
}

// Throws std::runtime_error that lists the existing lessons.
ListedLesson find(const std::vector<ListedLesson>& shelf, const std::string& name) {
  std::vector<std::string> names;
  for (const ListedLesson& shelved : shelf) {
    if (shelved.name == name) return shelved;
    names.push_back(shelved.name);
  }
  std::string known;
  for (const std::string& one : names) known += (known.empty() ? "" : ", ") + one;
  throw std::runtime_error("There is no lesson \"" + printable(name) + "\"." +
                           did_you_mean(name, names) +
                           (known.empty() ? "" : " The lessons are " + known + "."));
}

}  // namespace

void LessonFiles::read_list() {
  submit("");
}

void LessonFiles::open(const std::string& name_or_path) {
  submit(name_or_path);
}

void LessonFiles::submit(const std::string& wanted) {
  worker_.submit(
      [this, wanted](const RunContext& context) -> Worker::Delivery {
        auto shelf = std::make_shared<const std::vector<ListedLesson>>(read_all(folders_, context));
        ListedLesson opened;
        if (!wanted.empty()) {
          std::error_code ignored;
          opened = is_path(wanted) ? read(fs::absolute(wanted, ignored)) : find(*shelf, wanted);
        }
        return [this, shelf, opened, opens = !wanted.empty()] {
          news_.shelf = shelf;
          if (!opens) return;  // a lesson opened meanwhile stays in news_
          news_.opened = opened.lesson;
          news_.error = opened.problem;
        };
      },
      [this](const Worker::Failure& failure) {
        if (!failure.cancelled) news_.error = failure.message;
      });
}

LessonFiles::News LessonFiles::poll() {
  worker_.poll();
  return std::exchange(news_, {});
}

}  // namespace alphascope
