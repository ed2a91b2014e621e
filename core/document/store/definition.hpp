// What a derived result is, for the store: of what it is made, how large it is, how it is made.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/store/inputs.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {

// Where a result is made.
enum class Lane : std::uint8_t {
  background,  // on one thread that goes after all others; another key ends it
  interactive  // what follows a slider: on the slider's threads. One that has begun is finished and
               // shown although alpha has gone on, but not when the balls are others
};

struct AnyDefinition {
  std::string_view id;     // "filtration"
  std::string_view title;  // "Filtration of all simplices": in the list of what goes on
  // Other results that it is made of: the store has them made first, and Inputs::of() gives them to
  // memory and making. Their keys are part of this one's.
  std::vector<const AnyDefinition*> made_of = {};
  // Of what of the inputs it uses itself, and whatever else: key_of_balls() and the like.
  std::function<Key(const Inputs&)> key;
  std::function<MemoryNeed(const Inputs&)> memory;  // bytes, for the budget
  Lane lane = Lane::background;
  // The last one stays until the next is there, to be drawn greyed; some older ones stay as well,
  // as long as there is room, for when their alpha comes back.
  bool keep_stale = true;
  // Definition sets it.
  std::function<std::shared_ptr<const void>(const Inputs&, const RunContext&)> make = {};
};

template <class T>
struct Definition : AnyDefinition {
  // A plain function of what the key is made of. On a thread of the store; throws Cancelled.
  using Make = std::function<std::shared_ptr<const T>(const Inputs&, const RunContext&)>;
  Definition(AnyDefinition about, Make make_it) : AnyDefinition(std::move(about)) {
    make = std::move(make_it);
  }
};

// The definition's own key, joined with those of what it is made of.
Key key_of(const AnyDefinition& definition, const Inputs& inputs);

// "It needs about 3.20 GB of memory, and 1.00 GB is available for it."
std::string no_room_text(std::uint64_t needed_bytes, std::uint64_t available_bytes);

enum class DerivedState : std::uint8_t {
  none,  // the inputs do not suffice
  waiting,
  running,
  ready,
  failed,
  no_room,  // tried again when there is more
  cancelled
};

template <class T>
struct Derived {
  DerivedState state = DerivedState::none;
  Key wanted, have;  // have: of `value`
  std::shared_ptr<const T> value;
  double share = 0;  // of the work that is done, while running
  // failed, no_room: why, a sentence. waiting: for what else, if it waits for that; a title.
  std::string why;

  bool ready() const { return state == DerivedState::ready; }
  bool stale() const { return value && have != wanted; }
};

}  // namespace alphascope
