// SPDX-License-Identifier: GPL-3.0-or-later
// The owner of all results that follow from balls: triangulation, filtration, tables, charts. It
// makes each once a key, within one memory budget for all large objects of the program. A result
// that does not fit is not made, and its state says so.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/store/definition.hpp"

namespace alphascope {

class WorkThreads;
struct Key;
struct WorkFailure;

enum class Priority : std::uint8_t { background, visible };  // visible: a user looks at it

struct JobInfo {
  std::string id, title, stage;
  Lane lane = Lane::background;
  DerivedState state = DerivedState::waiting;
  double share = 0;
  std::string why;
};

// Only the main thread may use it. No function waits.
class Store {
 public:
  // Returns the slider's threads, for the interactive lane; called when a result begins. Without it
  // the store has threads of its own.
  using Threads = std::function<std::shared_ptr<WorkThreads>()>;
  // `wake` as in Worker. `budget` returns the limit of held_bytes().
  Store(std::function<void()> wake, std::function<std::uint64_t()> budget, Threads threads = {});
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // The present state of a result. If it is missing, the store makes it, after its sources. Call
  // this in each frame in which the result is wanted. A result that was not asked for in this frame
  // or the last is not begun. It is dropped first when memory is needed. There is one request at a
  // time for each definition: asking for it with other inputs replaces the request.
  template <class T>
  Derived<T> want(const Definition<T>& definition, const Inputs& inputs,
                  Priority priority = Priority::visible) {
    Derived<void> any = want_any(definition, inputs, priority);
    return {any.state, any.wanted,        any.have, std::static_pointer_cast<const T>(any.value),
            any.share, std::move(any.why)};
  }

  // The result for exactly these inputs, if the store holds it; else null. This is no request.
  template <class T>
  std::shared_ptr<const T> have(const Definition<T>& definition, const Inputs& inputs) const {
    return std::static_pointer_cast<const T>(find_held(definition, inputs));
  }

  // Takes a result made elsewhere from the same inputs, as if the store had made it. Drops it where
  // there is no room, or where its sources are missing.
  template <class T>
  void give(const Definition<T>& definition, const Inputs& inputs, std::shared_ptr<const T> value) {
    if (value) take_gift(definition, inputs, std::move(value));
  }

  // Stops the making of one result. It does not begin again before its inputs change.
  void cancel(std::string_view id);
  // Cancels everything and drops all results.
  void clear();
  // Undoes cancel(): the result begins again with the next request.
  void retry(std::string_view id);
  // The same for a result and all results from which it is made.
  void retry_whole(const AnyDefinition& definition);

  // While `held`, nothing begins in the background lane. For use while inputs change many times a
  // second, when results would be outdated before anybody sees them.
  void hold_background(bool held) { background_held_ = held; }

  // Counts large objects of other owners, in bytes, against the budget. 0: there are none any more.
  void set_held_bytes(const std::string& what, std::uint64_t bytes) { others_[what] = bytes; }

  // Takes finished results and begins waiting ones. Returns whether a result has arrived, or a
  // result that had no room may have it now; the window should then draw a frame.
  bool poll();
  void next_frame() { ++frame_; }  // to be called before the frame's requests

  // Results that are being made, wait for their turn, or could not be made.
  std::vector<JobInfo> jobs() const;
  bool busy() const;
  // Something asked for in this lane, or one of its sources, is waiting or running.
  bool busy(Lane lane) const;
  std::uint64_t held_bytes() const;  // by results and by others
  // How many values of this result have arrived, for any inputs.
  std::uint64_t times_made(std::string_view id) const;

 private:
  // All in store_work.hpp.
  struct Value;
  struct Link;
  struct Entry;
  struct Made;
  struct Work;
  class Chain;

  Derived<void> want_any(const AnyDefinition& definition, const Inputs& inputs, Priority priority);
  Entry& ask(const AnyDefinition& definition, const Inputs& inputs, Priority priority);
  // awaited: a visible result of the interactive lane waits for this one.
  Entry& ask(const AnyDefinition& definition, const Inputs& inputs, Priority priority,
             bool awaited);
  void take_gift(const AnyDefinition& definition, const Inputs& inputs,
                 std::shared_ptr<const void> value);
  std::shared_ptr<const void> find_held(const AnyDefinition& definition,
                                        const Inputs& inputs) const;
  Entry& entry(const AnyDefinition& definition);
  void set_wanted(Entry& e, const Key& key);
  bool take_held(Entry& e);
  void prepare(Entry& e, const AnyDefinition& definition, const Inputs& inputs, bool awaited);
  bool is_asked_for(const Entry& e) const;
  Lane lane(const Entry& e) const;
  Work& work(const Entry& e) const;
  bool runs(const Entry& e) const;
  double share(const Entry& e) const;
  bool retry_where_room_is();
  void begin_next(Work& lane);
  enum class Eviction : std::uint8_t { first, own_stale, lower_priority, never };
  Eviction eviction(const Entry& e, const Value& value, const Entry& wanted) const;
  bool could_fit(const Entry& wanted, std::uint64_t budget) const;
  bool make_room(Entry& wanted);
  void begin(Entry& e);
  Chain chain_after(Entry& first);
  void take(Work& lane, std::vector<Made> made);
  void keep(Entry& e, Value value);
  void take_failure(Entry& e, const WorkFailure& failure);

  const std::function<std::uint64_t()> budget_;
  const Threads threads_;
  std::map<std::string, std::uint64_t> others_;  // bytes
  std::list<Entry> entries_;                     // a list, so references stay valid
  std::uint64_t frame_ = 1, begun_ = 0;
  bool arrived_ = false, background_held_ = false;
  // Last, so that their threads end before members that jobs use.
  const std::unique_ptr<Work> background_, interactive_;
};

}  // namespace alphascope
