// The CPU's threads for one kind of work. Several who share them never have more at work together.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace alphascope {

class WorkThreads {
 public:
  // 0: as many as the machine has.
  explicit WorkThreads(int count = 0);
  ~WorkThreads();
  WorkThreads(const WorkThreads&) = delete;
  WorkThreads& operator=(const WorkThreads&) = delete;

  // Runs `work`, with all that it does in parallel through oneTBB, on these threads, the caller's
  // being one of them where it can; returns when it is done. What one caller waits for is never
  // held up by a part of another's work that its thread took on. Throws what `work` throws.
  void run(const std::function<void()>& work);

  int asked() const { return count_; }  // the machine may have fewer
  int used() const;
  std::string text() const;  // "CPU, 2 threads": EngineInfo::device

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
  int count_;
};

// The same threads for everybody who asks for the same number of them. From any thread.
class SharedThreads {
 public:
  std::shared_ptr<WorkThreads> of(int count);

 private:
  std::mutex mutex_;
  std::map<int, std::weak_ptr<WorkThreads>> by_count_;
};

}  // namespace alphascope
