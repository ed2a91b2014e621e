// The number of steps, and the step on show.
#include "ui/panels/explain/steps_memory.hpp"

#include <algorithm>

#include "core/document/explain/steps_results.hpp"

namespace alphascope {

std::size_t StepsMemory::count() const {
  return shown ? shown->steps.steps.size() : 0;
}

std::size_t StepsMemory::last() const {
  return std::max<std::size_t>(count(), 1) - 1;
}

std::size_t StepsMemory::at() const {
  return count() == 0 ? step : std::min(step, last());
}

}  // namespace alphascope
