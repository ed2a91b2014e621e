// One owner of everything that follows from balls: triangulation, filtration, tables, charts. It
// has them made, each once a key, under one budget of memory for all large objects of the program;
// what does not fit is not made, and says so.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/store/definition.hpp"
#include "core/run/work_threads.hpp"
#include "core/run/worker.hpp"

namespace alphascope {

enum class Priority : std::uint8_t { background, visible };  // visible: somebody looks at it

struct JobInfo {
  std::string id, title, stage;
  Lane lane = Lane::background;
  DerivedState state = DerivedState::waiting;
  double share = 0;
  std::string why;
};

// Belongs to one thread, the main thread; nothing here waits.
class Store {
 public:
  // Those of the slider, for the interactive lane; asked when a result is begun. Null: its own.
  using Threads = std::function<std::shared_ptr<WorkThreads>()>;
  // `wake` as in Worker. `budget` says how many bytes held_bytes() may come to.
  Store(std::function<void()> wake, std::function<std::uint64_t()> budget, Threads threads = {});

  // What there is now. Has it made when it is not there, and first what it is made of; to be called
  // in each frame in which it is wanted: what was not asked for in this frame or the last is not
  // begun, and goes first when memory is needed. With other inputs in turn, each call undoes the
  // last one's wish.
  template <class T>
  Derived<T> want(const Definition<T>& definition, const Inputs& inputs,
                  Priority priority = Priority::visible) {
    const Entry& e = ask(definition, inputs, priority);
    Derived<T> derived{e.state, e.wanted, {}, nullptr, share(e), e.why};
    if (e.values.empty()) return derived;
    derived.have = e.values.front().key;
    derived.value = std::static_pointer_cast<const T>(e.values.front().result);
    return derived;
  }

  // What there is of exactly these inputs, without a wish for it; null: nothing.
  template <class T>
  std::shared_ptr<const T> have(const Definition<T>& definition, const Inputs& inputs) const {
    return std::static_pointer_cast<const T>(find_held(definition, inputs));
  }

  // Takes what somebody else has made of the same inputs, as if the store had; drops it where there
  // is no room for it, or where what it is made of is not there.
  template <class T>
  void give(const Definition<T>& definition, const Inputs& inputs, std::shared_ptr<const T> value) {
    if (value) take_gift(definition, inputs, std::move(value));
  }

  // Ends the making of one result; it is not begun again before its inputs change.
  void cancel(std::string_view id);
  // After cancel(): it is begun again when it is wanted next.
  void begin_again(std::string_view id);

  // Nothing is begun in the background lane while `held`: what a hand changes many times a second
  // is worth no work that is not seen.
  void hold_background(bool held) { background_held_ = held; }

  // Large objects that others own: so many bytes of the budget are theirs. 0: none any more.
  void note_held(const std::string& what, std::uint64_t bytes) { others_[what] = bytes; }

  // Takes in what is finished and begins what waits. True: a result has come, or there may be room
  // for one that had none, and its panel should be drawn.
  bool poll();
  void next_frame() { ++frame_; }  // before those who draw it ask

  // What goes on, waits for its turn, or could not be done.
  std::vector<JobInfo> jobs() const;
  bool busy() const;
  // Something of this lane has been asked for and is on its way, or what it is made of.
  bool busy(Lane lane) const;
  std::uint64_t held_bytes() const;  // by results and by others
  // How many values of this result have come so far, of whatever inputs.
  std::uint64_t times_made(std::string_view id) const;

 private:
  struct Value {
    Key key;
    std::shared_ptr<const void> result;
    std::uint64_t bytes = 0, used_at = 0;  // used_at: frame
  };
  // How a result is made as soon as what it is made of is there, by the same worker.
  struct Link {
    Inputs inputs;                       // with what is there already
    std::vector<std::string_view> lack;  // ids of what is not
    std::function<MemoryNeed(const Inputs&)> memory;
    std::function<std::shared_ptr<const void>(const Inputs&, const RunContext&)> make;
  };
  struct Entry {
    std::string id, title;
    Lane lane = Lane::background;
    bool keep_stale = true;
    DerivedState state = DerivedState::none;
    Key wanted;
    Priority priority = Priority::background;  // the highest of this frame's
    std::uint64_t asked_at = 0;                // frame
    std::uint64_t begun_at = 0;                // count of all that was begun
    MemoryNeed need;                           // of what is wanted
    std::uint64_t refused = 0;                 // bytes that were free and did not suffice
    std::list<Value> values;                   // the first is handed out, the others are older
    std::function<std::shared_ptr<const void>(const RunContext&)> make;
    bool lacks = false;  // something that it is made of; state and why tell of that
    std::string why;
    std::shared_ptr<const Link> link;  // while it lacks something that can be made
    std::uint64_t awaited_at = 0;      // frame
    std::uint64_t times_made = 0;
  };
  struct Made {
    Entry* entry;
    Value value;
  };
  class Chain;
  struct Work {  // of one lane
    explicit Work(std::function<void()> wake) : worker(std::move(wake)) {}
    Entry* running = nullptr;
    Key key;  // of what runs
    std::uint64_t peak = 0;
    Worker worker;
  };

  Entry& ask(const AnyDefinition& definition, const Inputs& inputs, Priority priority) {
    return ask(definition, inputs, priority,
               priority == Priority::visible && definition.lane == Lane::interactive);
  }
  // awaited: by something visible of the interactive lane.
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
  bool is_asked_for(const Entry& e) const { return e.asked_at + 1 >= frame_; }
  Lane lane(const Entry& e) const;
  Work& work(const Entry& e) { return lane(e) == Lane::background ? background_ : interactive_; }
  const Work& work(const Entry& e) const {
    return lane(e) == Lane::background ? background_ : interactive_;
  }
  bool runs(const Entry& e) const { return work(e).running == &e; }
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
  void take_failure(Entry& e, const Worker::Failure& failure);

  const std::function<std::uint64_t()> budget_;
  const Threads threads_;
  std::map<std::string, std::uint64_t> others_;  // bytes
  std::list<Entry> entries_;                     // a reference to one stays good
  std::uint64_t frame_ = 1, begun_ = 0;
  bool arrived_ = false, background_held_ = false;
  Work background_, interactive_;  // last: joined before what their jobs use goes
};

}  // namespace alphascope
