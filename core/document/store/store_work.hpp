// SPDX-License-Identifier: GPL-3.0-or-later
// The private parts of the store: its entries, their values, and the work of its two lanes.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/document/store/store.hpp"
#include "core/run/worker.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {

struct Store::Value {
  Key key;
  std::shared_ptr<const void> result;
  std::uint64_t bytes = 0, used_at = 0;  // used_at: frame
};

// How the same worker makes a result as soon as its sources are made.
struct Store::Link {
  Inputs inputs;                       // with the sources made so far
  std::vector<std::string_view> lack;  // ids of the missing sources
  std::function<MemoryNeed(const Inputs&)> memory;
  std::function<std::shared_ptr<const void>(const Inputs&, const RunContext&)> make;
};

struct Store::Entry {
  std::string id, title;
  Lane lane = Lane::background;
  bool keep_stale = true;
  DerivedState state = DerivedState::none;
  Key wanted;
  Priority priority = Priority::background;  // the highest of this frame's
  std::uint64_t asked_at = 0;                // a frame
  std::uint64_t begun_at = 0;                // value of begun_ when it last began
  MemoryNeed need;                           // of the wanted result
  // Bytes that were free when there was too little room for it; 0: there was enough.
  std::uint64_t refused = 0;
  std::list<Value> values;  // the first is handed out; the others are older
  std::function<std::shared_ptr<const void>(const RunContext&)> make;
  bool lacks = false;  // a source is missing; state and why describe the source
  std::string why;
  std::shared_ptr<const Link> link;  // while a missing source can be made
  std::uint64_t awaited_at = 0;      // a frame
  std::uint64_t times_made = 0;
};

struct Store::Made {
  Entry* entry;
  Value value;
};

struct Store::Work {  // of one lane
  explicit Work(std::function<void()> wake) : worker(std::move(wake)) {}
  Entry* running = nullptr;
  Key key;  // of the running result
  std::uint64_t peak = 0;
  Worker worker;
};

}  // namespace alphascope
