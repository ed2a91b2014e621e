// SPDX-License-Identifier: GPL-3.0-or-later
// Compares every predicate and its filters with GMP's integers and rationals, on five balls at a
// time. Suites use it, and a program that checks a hundred million sets.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace alphascope::testing {

class PredicateCheck {
 public:
  // Counts for one predicate. Undecided: the filter could not tell.
  struct Count {
    std::uint64_t calls = 0, undecided = 0, ties = 0, wrong = 0;
  };

  explicit PredicateCheck(std::uint64_t seed) : seed_(seed) {}

  // Checks all predicates on five balls, which follow from this number and the seed alone.
  void check(std::uint64_t number);

  std::uint64_t calls() const;
  std::uint64_t wrong() const;
  const std::map<std::string, Count>& counts() const { return counts_; }
  // The first failure: the predicate, the number of its balls, and the balls. Empty if there is
  // none.
  const std::string& failure() const { return failure_; }
  void add(const PredicateCheck& other);

 private:
  class Case;

  std::uint64_t seed_;
  std::map<std::string, Count> counts_;
  std::string failure_;
};

}  // namespace alphascope::testing
