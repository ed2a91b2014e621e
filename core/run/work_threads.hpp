// SPDX-License-Identifier: GPL-3.0-or-later
// A number of CPU threads for one kind of work. Several callers share them and together never use
// more.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace alphascope {

// "CPU, 2 threads"
std::string cpu_text(int threads);

class WorkThreads {
 public:
  // 0: all threads of the machine.
  explicit WorkThreads(int count = 0);
  ~WorkThreads();
  WorkThreads(const WorkThreads&) = delete;
  WorkThreads& operator=(const WorkThreads&) = delete;

  // Runs `work` and all its parallel parts on these threads, and returns when it is done. The
  // calling thread is one of them if possible. A thread that waits for a part of this work takes no
  // task of another caller meanwhile, so callers do not delay each other. Throws the exceptions of
  // `work`.
  void run(const std::function<void()>& work);

  int asked() const { return count_; }  // the machine may have fewer
  int used() const;
  std::string text() const { return cpu_text(used()); }  // EngineInfo::device

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
  int count_;
};

// How many threads work on what the calling thread does: those of WorkThreads whose work it runs,
// or those of its task arena. At most as many as the machine has.
int threads_here();

// Gives callers that ask for the same number the same threads. May be called from any thread.
class SharedThreads {
 public:
  std::shared_ptr<WorkThreads> of(int count);

 private:
  std::mutex mutex_;
  std::map<int, std::weak_ptr<WorkThreads>> by_count_;
};

}  // namespace alphascope
