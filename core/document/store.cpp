// See the header.
#include "core/document/store.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "core/run/background.hpp"

namespace alphascope {
namespace {

std::string gigabytes(std::uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f GB", static_cast<double>(bytes) / 1e9);
  return text;
}

}  // namespace

Store::Store(std::function<void()> wake, std::function<std::uint64_t()> budget)
    : budget_(std::move(budget)), worker_(std::move(wake)) {}

Store::Entry& Store::entry(std::string_view id, std::string_view title) {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.id == id; });
  if (found != entries_.end()) return *found;
  entries_.emplace_back();
  entries_.back().id = id;
  entries_.back().title = title;
  return entries_.back();
}

void Store::drop_value(Entry& e) {
  e.value = nullptr;
  e.have = 0;
  e.held = 0;
}

void Store::request(Entry& e, Key key, Priority priority, bool keep_stale) {
  e.asked_at = polls_;
  e.priority = priority;
  if (key != e.wanted) {
    if (running_ == &e) worker_.cancel();
    e.wanted = key;
    e.make = nullptr;
    e.why.clear();
    e.state = DerivedState::none;
    if (key != e.have && !keep_stale) drop_value(e);
  }
  if (key == 0) return;
  if (key == e.have) {
    e.state = DerivedState::ready;
  } else if (e.state == DerivedState::none || e.state == DerivedState::ready) {
    e.state = DerivedState::waiting;
    e.make = nullptr;
  }
}

void Store::cancel(std::string_view id) {
  for (Entry& e : entries_) {
    if (e.id != id || (e.state != DerivedState::waiting && e.state != DerivedState::running)) {
      continue;
    }
    e.state = DerivedState::cancelled;
    e.make = nullptr;
    if (running_ == &e) worker_.cancel();
  }
}

double Store::share(const Entry& e) const {
  return running_ == &e ? worker_.activity().share : 0;
}

std::uint64_t Store::held_bytes() const {
  std::uint64_t bytes = 0;
  for (const Entry& e : entries_) bytes += e.held;
  return bytes;
}

bool Store::busy() const {
  return running_ != nullptr || std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
           return e.state == DerivedState::waiting && is_asked_for(e);
         });
}

std::vector<JobInfo> Store::jobs() const {
  std::vector<JobInfo> jobs;
  for (const Entry& e : entries_) {
    const bool over = e.state == DerivedState::none || e.state == DerivedState::ready;
    if (over || !is_asked_for(e)) continue;
    const std::string stage = running_ == &e ? worker_.activity().stage : "";
    jobs.push_back({e.title, stage, e.state, share(e), e.why});
  }
  return jobs;
}

bool Store::poll() {
  worker_.poll();
  ++polls_;
  if (running_ != nullptr && !is_asked_for(*running_)) worker_.cancel();
  begin_next();
  return std::exchange(arrived_, false);
}

// What somebody looks at goes first.
void Store::begin_next() {
  while (running_ == nullptr) {
    Entry* next = nullptr;
    for (Entry& e : entries_) {
      if (e.state != DerivedState::waiting || !e.make || !is_asked_for(e)) continue;
      if (next == nullptr || e.priority > next->priority) next = &e;
    }
    if (next == nullptr) return;
    if (has_room(*next)) return begin(*next);
  }
}

// Lets go of what nobody asks for when that makes the room.
bool Store::has_room(Entry& wanted) {
  const std::uint64_t budget = budget_();
  const auto fits = [&] { return held_bytes() - wanted.held + wanted.need.peak <= budget; };
  while (!fits()) {
    Entry* oldest = nullptr;
    for (Entry& e : entries_) {
      if (&e == &wanted || !e.value || is_asked_for(e)) continue;
      if (oldest == nullptr || e.asked_at < oldest->asked_at) oldest = &e;
    }
    if (oldest == nullptr) break;
    drop_value(*oldest);
    oldest->state = DerivedState::none;
  }
  if (fits()) return true;
  const std::uint64_t held = held_bytes() - wanted.held;
  wanted.state = DerivedState::no_room;
  wanted.make = nullptr;
  wanted.why = "It needs about " + gigabytes(wanted.need.peak) + " of memory, and " +
               gigabytes(budget > held ? budget - held : 0) + " is available for it.";
  return false;
}

void Store::begin(Entry& e) {
  running_ = &e;
  e.state = DerivedState::running;
  worker_.submit(
      [this, &e, key = e.wanted, make = std::exchange(e.make, nullptr),
       held = e.need.held](const RunContext& context) -> Worker::Delivery {
        let_others_go_first();
        std::shared_ptr<const void> value;
        tbb::task_arena(1).execute([&] { value = make(context); });
        return [this, &e, key, held, value] {
          running_ = nullptr;
          if (key != e.wanted) return;  // its inputs have changed meanwhile
          e.value = value;
          e.have = key;
          e.held = held;
          e.state = DerivedState::ready;
          arrived_ = true;
        };
      },
      [this, &e, key = e.wanted](const Worker::Failure& failure) {
        running_ = nullptr;
        if (key != e.wanted || e.state == DerivedState::cancelled) return;
        if (failure.cancelled) {  // nobody asked for it any more
          e.state = DerivedState::none;
          return;
        }
        e.state = failure.out_of_memory ? DerivedState::no_room : DerivedState::failed;
        e.why = failure.out_of_memory ? "There is not enough memory for it." : failure.message;
      });
}

}  // namespace alphascope
