// SPDX-License-Identifier: GPL-3.0-or-later
// The thread that frees large objects, and its queue.
#include "core/run/freed_on_other_thread.hpp"

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/run/large_pages.hpp"

namespace alphascope {
namespace {

class Freer {
 public:
  Freer() : thread_([this] { run(); }) {}
  // Frees all waiting objects before it ends.
  ~Freer() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    work_.notify_one();
    thread_.join();
  }

  void add(void (*free_it)(const void*) noexcept, const void* object) {
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back({free_it, object});
      ++given_;
    }
    work_.notify_one();
  }

  void wait() {
    std::unique_lock lock(mutex_);
    const std::size_t all = given_;
    done_.wait(lock, [&] { return freed_ >= all; });
  }

 private:
  struct Waiting {
    void (*free_it)(const void*) noexcept;
    const void* object;
  };

  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      work_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      const std::vector<Waiting> now = std::exchange(waiting_, {});
      lock.unlock();
      for (const Waiting& w : now) w.free_it(w.object);
      lock.lock();
      freed_ += now.size();
      done_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable work_, done_;
  std::vector<Waiting> waiting_;
  std::size_t given_ = 0, freed_ = 0;
  bool stop_ = false;
  std::thread thread_;  // last: starts when everything above exists
};

// Lives until the program ends.
Freer& freer() {
  static Freer the_one;
  return the_one;
}

}  // namespace

void free_on_other_thread(void (*free_it)(const void*) noexcept, const void* object) noexcept {
  try {
    freer().add(free_it, object);
  } catch (const std::bad_alloc&) {
    free_it(object);
  } catch (const std::system_error&) {  // the thread could not be started
    free_it(object);
  }
}

void wait_until_freed() {
  freer().wait();
  free_kept_large();
}

}  // namespace alphascope
