// SPDX-License-Identifier: GPL-3.0-or-later
// The store's jobs: how a result is made on a worker, and how the store takes it.
#include <algorithm>
#include <utility>

#include "core/document/store/key.hpp"
#include "core/document/store/store.hpp"
#include "core/document/store/store_work.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/internal_error.hpp"
#include "core/run/thread_priority.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope {
namespace {

// Values kept of one result, the latest included. Enough for a slider that is moved to and fro.
constexpr std::size_t kMostValues = 8;
// Bytes that results may take which the same worker makes right after another one.
constexpr std::uint64_t kChainBytes = std::uint64_t{1} << 28;

}  // namespace

// A chain of results, each made from earlier ones, for which a visible result waits. One job makes
// all of them, so no frame has to be drawn in between.
class Store::Chain {
 public:
  struct Step {
    Entry* entry;
    Key key;
    std::shared_ptr<const Link> link;
  };
  std::vector<Step> steps;
  std::uint64_t room = 0;  // bytes

  bool makes(std::string_view id) const {
    return std::any_of(steps.begin(), steps.end(),
                       [&](const Step& step) { return step.entry->id == id; });
  }

  // Adds the following results while there is room and none fails. A result left out here begins by
  // itself later, and then reports why it cannot be made.
  void go_on(std::vector<Made>& made, const RunContext& context) const {
    std::uint64_t left = room;
    for (const Step& step : steps) {
      Inputs inputs = step.link->inputs;
      for (const std::string_view id : step.link->lack) {
        const auto source = std::find_if(made.begin(), made.end(),
                                         [&](const Made& m) { return m.entry->id == id; });
        inputs.made.emplace_back(source->entry->id, source->value.result);
      }
      try {
        const MemoryNeed need = step.link->memory(inputs);
        if (std::max(need.peak, need.held) > left) return;
        left -= need.held;
        context.cancel.throw_if_cancelled();
        made.push_back({step.entry, {step.key, step.link->make(inputs, context), need.held, 0}});
      } catch (const Cancelled&) {
        throw;
      } catch (const std::exception&) {
        return;
      }
    }
  }
};

Store::Chain Store::chain_after(Entry& first) {
  Chain chain;
  const auto is_made = [&](std::string_view id) { return id == first.id || chain.makes(id); };
  for (bool more = lane(first) == Lane::interactive; more;) {
    more = false;
    for (Entry& e : entries_) {
      if (e.state != DerivedState::waiting || !e.lacks || !e.link || !is_asked_for(e)) continue;
      if (lane(e) != Lane::interactive || chain.makes(e.id)) continue;
      if (!std::all_of(e.link->lack.begin(), e.link->lack.end(), is_made)) continue;
      chain.steps.push_back({&e, e.wanted, e.link});
      more = true;
    }
  }
  if (chain.steps.empty()) return chain;
  const std::uint64_t budget = budget_();
  const std::uint64_t taken = background_->peak + interactive_->peak + held_bytes();
  chain.room = std::min(kChainBytes, budget > taken ? (budget - taken) / 2 : 0);
  return chain;
}

void Store::begin(Entry& e) {
  Work& lane = work(e);
  lane.running = &e;
  lane.key = e.wanted;
  lane.peak = e.need.peak;
  Chain chain = chain_after(e);
  lane.peak += chain.room;
  e.begun_at = ++begun_;
  e.state = DerivedState::running;
  std::shared_ptr<WorkThreads> threads;
  if (&lane == background_.get()) {
    threads = std::make_shared<WorkThreads>(1);
  } else {
    threads = threads_ ? threads_() : std::make_shared<WorkThreads>();
  }
  lane.worker.submit(
      [this, &e, &lane, threads, key = e.wanted, make = std::exchange(e.make, nullptr),
       held = e.need.held,
       chain = std::move(chain)](const RunContext& context) -> Worker::Delivery {
        if (&lane == background_.get()) lower_thread_priority(CpuShare::seventieth);
        std::vector<Made> made;
        threads->run([&] {
          context.cancel.throw_if_cancelled();
          made.push_back({&e, {key, make(context), held, 0}});
          if (made.front().value.result) chain.go_on(made, context);
        });
        if (!made.front().value.result) {
          throw InternalError("\"" + e.title + "\" was not made.");
        }
        return [this, &lane, made] { take(lane, made); };
      },
      [this, &e](const WorkFailure& failure) { take_failure(e, failure); });
}

void Store::take(Work& lane, std::vector<Made> made) {
  lane.running = nullptr;
  lane.peak = 0;
  for (Made& m : made) {
    if (m.value.result && m.entry->state != DerivedState::cancelled) {
      keep(*m.entry, std::move(m.value));
    }
  }
}

// A result whose alpha is outdated is still newer than the present one. It is shown until the next
// is made.
void Store::keep(Entry& e, Value value) {
  const bool wanted = value.key == e.wanted;
  const bool newer = e.lane == Lane::interactive && value.key.balls == e.wanted.balls &&
                     e.state == DerivedState::waiting;
  if (!wanted && !newer) return;
  value.used_at = frame_;
  std::erase_if(e.values,
                [&](const Value& v) { return !e.keep_stale || v.key.balls != value.key.balls; });
  e.values.push_front(std::move(value));
  if (e.values.size() > kMostValues) e.values.resize(kMostValues);
  ++e.times_made;
  arrived_ = true;
  if (!wanted) return;
  e.state = DerivedState::ready;
  e.lacks = false;
  e.why.clear();
  e.make = nullptr;
  e.link = nullptr;
}

void Store::take_failure(Entry& e, const WorkFailure& failure) {
  Work& lane = work(e);
  lane.running = nullptr;
  lane.peak = 0;
  if (lane.key != e.wanted || e.state != DerivedState::running) return;
  arrived_ = true;
  if (failure.cancelled) {  // nobody asks for it any more
    e.state = DerivedState::none;
  } else if (failure.out_of_memory) {
    const std::uint64_t budget = budget_(), held = held_bytes();
    e.refused = std::max(e.need.peak, budget > held ? budget - held : 0);
    e.need.peak = e.refused / 4 * 5;
    e.state = DerivedState::no_room;
    e.why =
        "There is not enough memory for this result. Close other programs, or choose a part of the "
        "molecule.";
  } else {
    e.state = DerivedState::failed;
    e.why = failure.message;
  }
}

void Store::take_gift(const AnyDefinition& definition, const Inputs& inputs,
                      std::shared_ptr<const void> value) {
  Entry& e = ask(definition, inputs, Priority::background);
  const bool wanted = e.state == DerivedState::waiting || e.state == DerivedState::running;
  if (!wanted || e.lacks) return;
  if (runs(e)) {
    work(e).worker.cancel();
  } else {
    e.need.peak = e.need.held;
    if (!make_room(e)) return;
  }
  keep(e, {e.wanted, std::move(value), e.need.held, 0});
}

}  // namespace alphascope
