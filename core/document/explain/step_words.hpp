// SPDX-License-Identifier: GPL-3.0-or-later
// Words with numbers for sentences on steps. Internal header of core/document.
#pragma once

#include <cstdint>
#include <string>

#include "core/document/explain/steps_text.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {

inline std::string things(std::uint64_t count, const std::string& one, const std::string& many) {
  return grouped(count) + " " + (count == 1 ? one : many);
}
inline std::string things(std::uint64_t count, const std::string& one) {
  return things(count, one, one + "s");
}
inline std::string is_or_are(std::uint64_t count) {
  return count == 1 ? "is" : "are";
}
inline std::string has_or_have(std::uint64_t count) {
  return count == 1 ? "has" : "have";
}
inline std::string left_of(const Step& step) {
  return grouped(step.count(step_count::kKept).all) + " of " +
         grouped(step.count(step_count::kMade).all) + " left";
}
// The number of these simplices that the engine makes at this ball; empty if none or all are.
inline std::string made_here(const StepCount& count) {
  if (count.all == 0 || count.here == count.all) return "";
  return " (" + grouped(count.here) + " made here)";
}

// The text of a step that only the dual-edge engine has.
StepText dual_edge_step_text(const BallSteps& steps, const Step& step, const BallName& name);

}  // namespace alphascope
