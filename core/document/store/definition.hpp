// SPDX-License-Identifier: GPL-3.0-or-later
// The definition of a derived result for the store: its inputs, its memory, and how it is made.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/store/key.hpp"

namespace alphascope {

struct Inputs;
struct MemoryNeed;
struct RunContext;

// The thread on which a result is made.
enum class Lane : std::uint8_t {
  background,  // on one low-priority thread; another key ends it
  interactive  // for results that follow a slider, on the slider's threads
};

struct AnyDefinition {
  std::string_view id;     // "filtration"
  std::string_view title;  // "Filtration of all simplices", in the list of jobs
  // Other results from which this one is made. The store makes them first. Inputs::of() gives them
  // to `memory` and `make`. Their keys are part of this one's key.
  std::vector<const AnyDefinition*> made_of = {};
  // The key of the inputs that the definition itself uses: key_of_balls() and similar functions.
  std::function<Key(const Inputs&)> key;
  std::function<MemoryNeed(const Inputs&)> memory;  // bytes, for the budget
  Lane lane = Lane::background;
  // true: the last value stays until the next one is made, and is drawn in grey meanwhile. Some
  // older values stay too while there is room, since a slider often comes back to an alpha.
  bool keep_stale = true;
  // Set by Definition.
  std::function<std::shared_ptr<const void>(const Inputs&, const RunContext&)> make = {};
};

template <class T>
struct Definition : AnyDefinition {
  // A pure function of the inputs in the key. It runs on a thread of the store. Throws Cancelled.
  using Make = std::function<std::shared_ptr<const T>(const Inputs&, const RunContext&)>;
  Definition(AnyDefinition about, Make make_it) : AnyDefinition(std::move(about)) {
    make = std::move(make_it);
  }
};

// The definition's own key, joined with the keys of `made_of`.
Key key_of(const AnyDefinition& definition, const Inputs& inputs);

// "It needs about 3.20 GB of memory, and 1.00 GB is available for it."
std::string no_room_text(std::uint64_t needed_bytes, std::uint64_t available_bytes);

enum class DerivedState : std::uint8_t {
  none,  // the inputs do not suffice
  waiting,
  running,
  ready,
  failed,
  no_room,  // tried again when there is more memory
  cancelled
};

template <class T>
struct Derived {
  DerivedState state = DerivedState::none;
  Key wanted, have;  // have: the key of `value`
  std::shared_ptr<const T> value;
  double share = 0;  // share of the work that is done, 0 to 1, while running
  // failed, no_room: the reason, a sentence. waiting: the title of the result it waits for, if any.
  std::string why;

  bool ready() const { return state == DerivedState::ready; }
  bool stale() const { return value && have != wanted; }
};

}  // namespace alphascope
