// What the timings say in words. No ImGui.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panels/view_state.hpp"

namespace alphascope {

// Why times are missing from the chart of cold or warm runs, and how to get them: a sentence for
// each engine, or one on why there are none at all. Empty when nothing is missing.
std::vector<std::string> missing_times(const ViewState& state, bool cold);

// An engine has been timed, but not with its set-up.
bool lacks_cold_time(const ViewState& state);

// CGAL's time by the engine's, of the cold or of the warm run. Nothing where they cannot be
// compared.
std::optional<double> speed_up(const ViewState& state, bool cold);

// "5.10 ms", or that it was not measured.
std::string wall_text(const std::optional<MeasuredRun>& run);

}  // namespace alphascope
