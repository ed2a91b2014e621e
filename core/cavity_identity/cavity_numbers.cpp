// SPDX-License-Identifier: GPL-3.0-or-later
// Gives cavities numbers that stay while alpha or the solvent radius changes.
#include "core/cavity_identity/cavity_numbers.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNone = CavityMatch::kNone;

bool comes_before(const KnownSink& a, const KnownSink& b) {
  return a.sink < b.sink;
}

// The sinks of both lists; for a sink of both, the number in `now`.
std::vector<KnownSink> joined(const std::vector<KnownSink>& before, std::vector<KnownSink> now) {
  std::sort(now.begin(), now.end(), comes_before);
  std::vector<KnownSink> all;
  all.reserve(before.size() + now.size());
  std::set_union(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(all),
                 comes_before);
  return all;
}

// `before`: the numbers that sinks had so far.
void number_the_rest(CavityNumbers& numbers, const CavityNumbers* before) {
  const CavityTable& table = *numbers.table;
  std::vector<bool> taken(numbers.used, false);
  for (const std::uint32_t number : numbers.of) {
    if (number != kNone) taken[number] = true;
  }
  std::vector<KnownSink> now;
  now.reserve(table.size());
  for (std::size_t row = 0; row < table.size(); ++row) {
    std::uint32_t& number = numbers.of[table.order[row]];
    if (number == kNone) {
      const std::uint32_t known = before == nullptr ? kNone : before->number_of(table.sink(row));
      number = known != kNone && !taken[known] ? known : numbers.used++;
      taken.resize(numbers.used, false);
      taken[number] = true;
    }
    now.push_back({table.sink(row), number});
  }
  numbers.known =
      joined(before == nullptr ? std::vector<KnownSink>() : before->known, std::move(now));
}

void note_changes(const CavityNumbers& before, const CavityMatch& match, CavityNumbers& numbers) {
  for (std::uint32_t c = 0; c < match.came_from.size(); ++c) {
    const std::uint32_t from = match.came_from[c];
    if (from != kNone && !match.is_same(c)) numbers.parted_from[c] = before.of[from];
  }
  for (std::uint32_t e = 0; e < match.goes_to.size(); ++e) {
    const std::uint32_t to = match.goes_to[e];
    if (to != kNone && match.came_from[to] != e) ++numbers.merged[to];
  }
}

// Notes which cavities merged into which. A cavity whose number is in use again leaves the list.
void note_heirs(const CavityNumbers& before, const CavityMatch& match, CavityNumbers& numbers) {
  numbers.merged_into = before.merged_into;
  for (std::uint32_t e = 0; e < match.goes_to.size(); ++e) {
    const std::uint32_t to = match.goes_to[e];
    if (to != kNone && match.came_from[to] != e) {
      numbers.merged_into[before.of[e]] = numbers.of[to];
    }
  }
  for (const std::uint32_t number : numbers.of) numbers.merged_into.erase(number);
}

// Numbers of a table in which all entries are still kNone or 0.
CavityNumbers blank_numbers(std::shared_ptr<const CavityTable> table) {
  CavityNumbers numbers;
  const std::size_t size = table->found.cavities.size();
  numbers.of.assign(size, kNone);
  numbers.parted_from.assign(size, kNone);
  numbers.merged.assign(size, 0);
  numbers.table = std::move(table);
  return numbers;
}

}  // namespace

std::uint32_t CavityNumbers::cavity(std::uint32_t number) const {
  const auto at = std::find(of.begin(), of.end(), number);
  return at == of.end() ? kNone : static_cast<std::uint32_t>(at - of.begin());
}

std::uint32_t CavityNumbers::cavity_or_heir(std::uint32_t number) const {
  // Each step leads to the cavity into which the last one merged. A number can occur twice only if
  // its cavity has come back since. The bound on the steps ends such circles.
  for (std::size_t step = 0; step <= merged_into.size(); ++step) {
    const std::uint32_t found = cavity(number);
    const auto heir = merged_into.find(number);
    if (found != kNone || heir == merged_into.end()) return found;
    number = heir->second;
  }
  return kNone;
}

std::uint32_t CavityNumbers::number_of(const std::array<BallIndex, 4>& sink) const {
  const auto at = std::lower_bound(known.begin(), known.end(), KnownSink{sink, 0}, comes_before);
  return at != known.end() && at->sink == sink ? at->number : kNone;
}

CavityNumbers first_numbers(std::shared_ptr<const CavityTable> table) {
  CavityNumbers numbers = blank_numbers(std::move(table));
  number_the_rest(numbers, nullptr);
  return numbers;
}

CavityNumbers next_numbers(const CavityNumbers& before, std::shared_ptr<const CavityTable> table,
                           const CancelToken& cancel) {
  if (before.table->ground->balls->size() != table->ground->balls->size()) {
    return first_numbers(std::move(table));
  }
  const CavityMatch match = match_cavities(*before.table, *table, cancel);
  CavityNumbers numbers = blank_numbers(std::move(table));
  numbers.used = before.used;
  numbers.steps = before.steps + 1;
  for (std::uint32_t c = 0; c < numbers.of.size(); ++c) {
    if (match.is_same(c)) numbers.of[c] = before.of[match.came_from[c]];
  }
  note_changes(before, match, numbers);
  number_the_rest(numbers, &before);
  note_heirs(before, match, numbers);
  return numbers;
}

}  // namespace alphascope
