// SPDX-License-Identifier: GPL-3.0-or-later
// The store: requests, the order in which results are made, and room for them.
#include "core/document/store/store.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "core/document/store/key.hpp"
#include "core/document/store/store_work.hpp"

namespace alphascope {
namespace {

bool is_trouble(DerivedState state) {
  return state == DerivedState::failed || state == DerivedState::no_room ||
         state == DerivedState::cancelled;
}

}  // namespace

Store::Store(std::function<void()> wake, std::function<std::uint64_t()> budget, Threads threads)
    : budget_(std::move(budget)),
      threads_(std::move(threads)),
      background_(std::make_unique<Work>(wake)),
      interactive_(std::make_unique<Work>(std::move(wake))) {}

Store::~Store() = default;

Derived<void> Store::want_any(const AnyDefinition& definition, const Inputs& inputs,
                              Priority priority) {
  const Entry& e = ask(definition, inputs, priority);
  Derived<void> derived{e.state, e.wanted, {}, nullptr, share(e), e.why};
  if (e.values.empty()) return derived;
  derived.have = e.values.front().key;
  derived.value = e.values.front().result;
  return derived;
}

bool Store::is_asked_for(const Entry& e) const {
  return e.asked_at + 1 >= frame_;
}

Store::Work& Store::work(const Entry& e) const {
  return lane(e) == Lane::background ? *background_ : *interactive_;
}

bool Store::runs(const Entry& e) const {
  return work(e).running == &e;
}

Store::Entry& Store::entry(const AnyDefinition& definition) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.id == definition.id; });
  if (found != entries_.end()) return *found;
  Entry& e = entries_.emplace_back();
  e.id = definition.id;
  e.title = definition.title;
  e.lane = definition.lane;
  e.keep_stale = definition.keep_stale;
  return e;
}

std::shared_ptr<const void> Store::find_held(const AnyDefinition& definition,
                                             const Inputs& inputs) const {
  const Key key = key_of(definition, inputs);
  for (const Entry& e : entries_) {
    if (e.id != definition.id) continue;
    for (const Value& value : e.values) {
      if (key && value.key == key) return value.result;
    }
  }
  return nullptr;
}

Store::Entry& Store::ask(const AnyDefinition& definition, const Inputs& inputs, Priority priority) {
  return ask(definition, inputs, priority,
             priority == Priority::visible && definition.lane == Lane::interactive);
}

Store::Entry& Store::ask(const AnyDefinition& definition, const Inputs& inputs, Priority priority,
                         bool awaited) {
  Entry& e = entry(definition);
  if (awaited) e.awaited_at = frame_;
  const bool first = std::exchange(e.asked_at, frame_) != frame_;
  e.priority = first ? priority : std::max(e.priority, priority);
  set_wanted(e, key_of(definition, inputs));
  if (!e.wanted || take_held(e)) return e;
  if (is_trouble(e.state) && !e.lacks) return e;
  prepare(e, definition, inputs, awaited);
  return e;
}

void Store::set_wanted(Entry& e, const Key& key) {
  if (key == e.wanted) return;
  const bool other_balls = key.balls != e.wanted.balls;
  if (runs(e) && (other_balls || lane(e) == Lane::background)) work(e).worker.cancel();
  e.wanted = key;
  e.state = DerivedState::none;
  e.make = nullptr;
  e.link = nullptr;
  e.refused = 0;
  e.lacks = false;
  e.why.clear();
  if (runs(e) && work(e).key == key) e.state = DerivedState::running;  // alpha has come back
  if (!e.keep_stale) {
    e.values.clear();
  } else if (other_balls && !e.values.empty()) {
    e.values.resize(1);
  }
}

bool Store::take_held(Entry& e) {
  const auto found = std::find_if(e.values.begin(), e.values.end(),
                                  [&](const Value& value) { return value.key == e.wanted; });
  if (found == e.values.end()) {
    if (e.state == DerivedState::ready) e.state = DerivedState::none;  // evicted
    return false;
  }
  if (runs(e) && work(e).key != e.wanted) work(e).worker.cancel();
  e.values.splice(e.values.begin(), e.values, found);
  found->used_at = frame_;
  e.state = DerivedState::ready;
  e.make = nullptr;
  return true;
}

// Asks for the sources of a result in each frame until the result is made. Otherwise the store
// could drop them before.
void Store::prepare(Entry& e, const AnyDefinition& definition, const Inputs& inputs, bool awaited) {
  Inputs all = inputs;
  all.made.clear();
  if (e.wanted.alpha == 0) {  // a complex is large, and this result does not need it
    all.alpha_angstrom2 = std::numeric_limits<double>::quiet_NaN();
    all.complex = nullptr;
    all.measures = nullptr;
  }
  const Entry* lacking = nullptr;
  std::vector<std::string_view> lack;
  for (const AnyDefinition* definition_of_source : definition.made_of) {
    const Entry& source = ask(*definition_of_source, inputs, e.priority, awaited);
    if (source.state == DerivedState::ready) {
      all.made.emplace_back(source.id, source.values.front().result);
      continue;
    }
    lack.push_back(source.id);
    if (lacking == nullptr || (is_trouble(source.state) && !is_trouble(lacking->state))) {
      lacking = &source;
    }
  }
  if (e.state == DerivedState::running) return;
  e.lacks = lacking != nullptr;
  e.state = DerivedState::waiting;
  e.why.clear();
  if (lacking != nullptr) {
    e.make = nullptr;
    const bool trouble = is_trouble(lacking->state);
    if (trouble) e.state = lacking->state;
    e.why = lacking->lacks ? lacking->why
                           : lacking->title + (trouble ? ": " + lacking->why : std::string());
    if (!e.link) {
      e.link = std::make_shared<const Link>(
          Link{std::move(all), std::move(lack), definition.memory, definition.make});
    }
  } else if (!e.make) {
    e.link = nullptr;
    try {
      e.need = definition.memory(all);
    } catch (const std::exception& error) {
      e.state = DerivedState::failed;
      e.why = error.what();
      return;
    }
    // A result for which memory ran out needs more than was estimated.
    e.need.peak = std::max({e.need.peak, e.need.held, e.refused / 4 * 5});
    e.make = [make = definition.make, all = std::move(all)](const RunContext& context) {
      return make(all, context);
    };
  }
}

void Store::cancel(std::string_view id) {
  for (Entry& e : entries_) {
    if (e.id != id || (e.state != DerivedState::waiting && e.state != DerivedState::running)) {
      continue;
    }
    e.state = DerivedState::cancelled;
    e.lacks = false;
    e.make = nullptr;
    e.why.clear();
    if (runs(e)) work(e).worker.cancel();
  }
}

void Store::clear() {
  for (Entry& e : entries_) {
    cancel(e.id);
    e.values.clear();
    e.state = DerivedState::none;
    e.wanted = {};
    e.make = nullptr;
    e.link = nullptr;
  }
}

void Store::retry(std::string_view id) {
  for (Entry& e : entries_) {
    if (e.id == id && e.state == DerivedState::cancelled) e.state = DerivedState::none;
  }
}

void Store::retry_whole(const AnyDefinition& definition) {
  retry(definition.id);
  for (const AnyDefinition* source : definition.made_of) retry_whole(*source);
}

double Store::share(const Entry& e) const {
  return e.state == DerivedState::running ? work(e).worker.activity().share : 0;
}

std::uint64_t Store::held_bytes() const {
  std::uint64_t bytes = 0;
  for (const Entry& e : entries_) {
    for (const Value& value : e.values) bytes += value.bytes;
  }
  for (const auto& [what, held] : others_) bytes += held;
  return bytes;
}

std::uint64_t Store::times_made(std::string_view id) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.id == id; });
  return found == entries_.end() ? 0 : found->times_made;
}

// A running result stays in the lane in which it began. The sources of a visible interactive result
// are made in the interactive lane as well.
Lane Store::lane(const Entry& e) const {
  if (background_->running == &e) return Lane::background;
  const bool awaited = e.awaited_at != 0 && e.awaited_at + 1 >= frame_;
  const bool interactive = e.lane == Lane::interactive || interactive_->running == &e || awaited;
  return interactive ? Lane::interactive : Lane::background;
}

bool Store::busy() const {
  return background_->running != nullptr || interactive_->running != nullptr ||
         std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
           return e.state == DerivedState::waiting && is_asked_for(e);
         });
}

bool Store::busy(Lane lane) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) {
    const bool on_its_way = e.state == DerivedState::waiting || e.state == DerivedState::running;
    return this->lane(e) == lane && on_its_way && is_asked_for(e);
  });
}

std::vector<JobInfo> Store::jobs() const {
  std::vector<JobInfo> jobs;
  for (const Entry& e : entries_) {
    const bool over = e.state == DerivedState::none || e.state == DerivedState::ready;
    if (over || e.lacks || !is_asked_for(e)) continue;
    const std::string stage = runs(e) ? work(e).worker.activity().stage : "";
    jobs.push_back({e.id, e.title, stage, lane(e), e.state, share(e), e.why});
  }
  return jobs;
}

bool Store::poll() {
  for (Work* lane : {background_.get(), interactive_.get()}) {
    lane->worker.poll();
    if (lane->running != nullptr && !is_asked_for(*lane->running)) lane->worker.cancel();
  }
  for (Entry& e : entries_) {
    if (!is_asked_for(e)) e.link = nullptr;  // the link holds sources
  }
  const bool retried = retry_where_room_is();
  if (!background_held_) begin_next(*background_);
  begin_next(*interactive_);
  return std::exchange(arrived_, false) || retried;
}

// Resets the state of results that had no room and would have it now, so that the next request
// begins them.
bool Store::retry_where_room_is() {
  bool any = false;
  std::uint64_t budget = 0;
  for (Entry& e : entries_) {
    if (e.state != DerivedState::no_room || e.lacks || !is_asked_for(e)) continue;
    if (budget == 0) budget = budget_();  // costly: it reads files of the system
    if (!could_fit(e, budget)) continue;
    e.state = DerivedState::none;
    e.why.clear();
    any = true;
  }
  return any;
}

// Visible results go first. Among equals the one that began longest ago goes first.
void Store::begin_next(Work& lane) {
  while (lane.running == nullptr) {
    const auto after = [](const Entry& a, const Entry& b) {
      return std::tuple(b.priority, a.begun_at) > std::tuple(a.priority, b.begun_at);
    };
    Entry* next = nullptr;
    for (Entry& e : entries_) {
      if (&work(e) != &lane || e.state != DerivedState::waiting || !e.make) continue;
      if (is_asked_for(e) && (next == nullptr || after(*next, e))) next = &e;
    }
    if (next == nullptr) return;
    if (make_room(*next)) return begin(*next);
    next->state = DerivedState::no_room;
    next->make = nullptr;
  }
}

Store::Eviction Store::eviction(const Entry& e, const Value& value, const Entry& wanted) const {
  const bool handed_out = &value == &e.values.front();
  if (!handed_out || !is_asked_for(e)) return Eviction::first;
  if (&e == &wanted) return Eviction::own_stale;
  return e.priority < wanted.priority ? Eviction::lower_priority : Eviction::never;
}

bool Store::could_fit(const Entry& wanted, std::uint64_t budget) const {
  std::uint64_t stays = background_->peak + interactive_->peak + held_bytes();
  for (const Entry& e : entries_) {
    for (const Value& value : e.values) {
      if (eviction(e, value, wanted) != Eviction::never) stays -= value.bytes;
    }
  }
  return stays + wanted.need.peak <= budget;
}

// Drops the results that are needed least, if that makes enough room.
bool Store::make_room(Entry& wanted) {
  const std::uint64_t budget = budget_();
  const auto taken = [&] { return background_->peak + interactive_->peak + held_bytes(); };
  if (!could_fit(wanted, budget)) {
    const std::uint64_t now = taken();
    wanted.why = no_room_text(wanted.need.peak, budget > now ? budget - now : 0);
    return false;
  }
  while (taken() + wanted.need.peak > budget) {
    Entry* owner = nullptr;
    std::list<Value>::iterator least;
    const auto rank = [&](const Entry& e, const Value& value) {
      return std::tuple(eviction(e, value, wanted), value.used_at);
    };
    for (Entry& e : entries_) {
      for (auto value = e.values.begin(); value != e.values.end(); ++value) {
        if (owner != nullptr && rank(*owner, *least) <= rank(e, *value)) continue;
        owner = &e;
        least = value;
      }
    }
    owner->values.erase(least);
  }
  return true;
}

}  // namespace alphascope
