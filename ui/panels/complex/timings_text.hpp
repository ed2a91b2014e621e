// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the page of timings. No ImGui.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panels/work_info.hpp"

namespace alphascope {

struct MeasuredRun;
struct TriangulationReport;
struct ViewState;

// Says why times are missing from the chart of cold or warm runs, and how to get them. The result
// has a sentence for each engine, or one if there are no times at all. It is empty if nothing is
// missing.
std::vector<std::string> missing_times(const ViewState& state, bool cold);

// Whether an engine has been timed, but not with its set-up.
bool lacks_cold_time(const ViewState& state);

// Returns CGAL's time divided by the engine's, for the cold or the warm run. The result is empty if
// the times cannot be compared.
std::optional<double> speed_up(const ViewState& state, bool cold);

// Returns "5.10 ms", or "not measured".
std::string wall_text(const std::optional<MeasuredRun>& run);

// How a device made the triangulation of all balls, or why it did not. Empty if there is no device.
std::vector<std::string> triangulation_sentences(const TriangulationReport& report);

// The badge's mark: "✓ ", "≠ " or nothing.
const char* badge_mark(BadgeInfo::State state);

// The last move in the words of the status bar, from long to short forms.
struct LastMove {
  std::string time;    // "34.2 ms to picture"; after opening a file "60.5 ms to compute"
  std::string engine;  // "dual-edge engine on CPU, 2 threads"
  std::string cgal;    // "CGAL 60.5 ms", of the same complex; empty if it is not compared
  std::string badge;   // "✓ identical"
  std::string line() const;

  std::string help;  // all of it in sentences
};
// Of the complex on screen, which must exist. The forms have all that fits ever less room: the last
// one is the shortest. `triangulation`: of all its balls; null if it is not there.
std::vector<LastMove> last_move(const ViewState& state, const TriangulationReport* triangulation);

}  // namespace alphascope
