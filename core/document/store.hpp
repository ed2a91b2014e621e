// One owner of everything that follows from balls and is made in the background: triangulation,
// filtration, charts. Under one budget of memory; what does not fit is not made, and says so.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/inputs.hpp"
#include "core/run/worker.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {

// Of what a result is made of: equal keys, equal results. 0: these inputs do not suffice.
using Key = std::uint64_t;

enum class DerivedState : std::uint8_t {
  none,
  waiting,
  running,
  ready,
  failed,
  no_room,
  cancelled
};

enum class Priority : std::uint8_t { background, visible };  // visible: somebody looks at it

// How a result is made: a plain function of the inputs that its key is made of.
template <class T>
struct Definition {
  std::string_view id;     // "filtration"
  std::string_view title;  // "Filtration of all simplices": in the list of what goes on
  std::function<Key(const Inputs&)> key;
  std::function<MemoryNeed(const Inputs&)> memory;  // bytes, for the budget
  // On a thread of the store, in an arena of one. Throws Cancelled.
  std::function<std::shared_ptr<const T>(const Inputs&, const RunContext&)> make;
  bool keep_stale = true;  // the last one until the next is there, to be drawn greyed
};

template <class T>
struct Derived {
  DerivedState state = DerivedState::none;
  Key wanted = 0, have = 0;  // of `value`
  std::shared_ptr<const T> value;
  double share = 0;  // of the work that is done, while running
  std::string why;   // failed, no_room: a sentence

  bool ready() const { return state == DerivedState::ready; }
  bool stale() const { return value && have != wanted; }
};

struct JobInfo {
  std::string title, stage;
  DerivedState state = DerivedState::waiting;
  double share = 0;
  std::string why;
};

// Belongs to one thread, the main thread; nothing here waits.
class Store {
 public:
  // `wake` as in Worker. `budget` says how many bytes all results together may hold.
  Store(std::function<void()> wake, std::function<std::uint64_t()> budget);

  // What there is now. Has it made when it is not there; to be called again and again, as long as
  // it is wanted: what nobody has asked for since the last poll but one is not begun, and goes
  // first when memory is needed.
  template <class T>
  Derived<T> want(const Definition<T>& definition, const Inputs& inputs,
                  Priority priority = Priority::visible) {
    Entry& e = entry(definition.id, definition.title);
    request(e, definition.key(inputs), priority, definition.keep_stale);
    if (e.state == DerivedState::waiting && !e.make) {
      e.need = definition.memory(inputs);
      e.make = [make = definition.make, inputs](const RunContext& context) {
        return std::shared_ptr<const void>(make(inputs, context));
      };
    }
    return {e.state, e.wanted, e.have, std::static_pointer_cast<const T>(e.value), share(e), e.why};
  }

  // Ends the making of one result; it is not begun again before its inputs change.
  void cancel(std::string_view id);

  // Takes in what is finished and begins what waits; once a frame. True: a result has come.
  bool poll();

  // What goes on, waits, or could not be done.
  std::vector<JobInfo> jobs() const;
  bool busy() const;
  std::uint64_t held_bytes() const;

 private:
  struct Entry {
    std::string id, title;
    DerivedState state = DerivedState::none;
    Key wanted = 0, have = 0;
    Priority priority = Priority::background;
    std::uint64_t asked_at = 0;  // poll
    MemoryNeed need;             // of what is wanted
    std::uint64_t held = 0;      // bytes, of `value`
    std::shared_ptr<const void> value;
    std::function<std::shared_ptr<const void>(const RunContext&)> make;
    std::string why;
  };

  Entry& entry(std::string_view id, std::string_view title);
  void request(Entry& e, Key key, Priority priority, bool keep_stale);
  bool is_asked_for(const Entry& e) const { return e.asked_at + 1 >= polls_; }
  double share(const Entry& e) const;
  void begin_next();
  bool has_room(Entry& e);
  void begin(Entry& e);
  static void drop_value(Entry& e);

  const std::function<std::uint64_t()> budget_;
  std::list<Entry> entries_;  // a reference to one stays good
  Entry* running_ = nullptr;
  std::uint64_t polls_ = 1;
  bool arrived_ = false;
  Worker worker_;  // last: joined before what its jobs use goes
};

}  // namespace alphascope
