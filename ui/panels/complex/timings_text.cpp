// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the page of timings, and the speed-up against CGAL.
#include "ui/panels/complex/timings_text.hpp"

#include "core/document/store/answer.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

bool lacks_cold(const ColdAndWarm& timings) {
  return timings.any() && !timings.cold;
}

// With fewer balls, most of the time goes into starting threads and reading the clock. Which engine
// is faster then changes from run to run.
constexpr std::size_t kLeastBalls = 100;

bool too_few_balls(const ViewState& state) {
  return state.molecule.balls < kLeastBalls;
}

// Says why two measured times cannot be compared; empty if they can, or if one is missing.
std::string incomparable(const ViewState& state, bool cold) {
  if (!state.ours.any() || !state.cgal.any()) return {};
  const auto& ours = cold ? state.ours.cold : state.ours.warm;
  const auto& cgal = cold ? state.cgal.cold : state.cgal.warm;
  if (!ours || !cgal) return {};
  if (too_few_balls(state)) {
    return "No speed-up: times of fewer than " + std::to_string(kLeastBalls) +
           " balls are too short to compare engines.";
  }
  if (ours->comparable(*cgal)) return {};
  if (ours->alpha_angstrom2 != cgal->alpha_angstrom2) {
    return "No speed-up: the times are of alpha " + short_number_text(ours->alpha_angstrom2, 3) +
           " and " + short_number_text(cgal->alpha_angstrom2, 3) + " Å².";
  }
  if (ours->tetrahedra_only != cgal->tetrahedra_only) {
    return "No speed-up: one engine computed tetrahedra only, the other all simplices.";
  }
  if (ours->same_threshold(*cgal)) {
    return "No speed-up: in both runs the complex was selected from CGAL's triangulation. Choose "
           "“Cold” to compare the engines.";
  }
  return "No speed-up: " + (ours->rebuilt ? state.ours.engine.name : std::string("CGAL")) +
         " prepared its data for later alphas in this run; the other engine reused its own.";
}

}  // namespace

std::vector<std::string> missing_times(const ViewState& state, bool cold) {
  if (!state.ours.any()) {
    return {awaited_job(state.jobs) != nullptr
                ? "The time of each stage appears here when the computation is done."
            : state.has_molecule()
                ? "Nothing is computed yet: move alpha."
                : "Open a molecule: the time of each stage appears here, beside CGAL's."};
  }
  std::vector<std::string> lines;
  if (cold && lacks_cold(state.ours)) {
    lines.push_back(state.ours.engine.name +
                    ": no cold time: the engine was reused, so there was no set-up.");
  }
  if (!cold && !state.ours.warm) {
    lines.push_back(state.ours.engine.name +
                    ": no warm time yet. Move alpha once more with the same molecule.");
  }
  if (cold && lacks_cold(state.cgal)) {
    lines.push_back("CGAL: no cold time: its triangulation was reused.");
  }
  if (!cold && state.cgal.any() && !state.cgal.warm) {
    lines.push_back("CGAL: no warm time yet. It is taken when another alpha is compared.");
  }
  if (const std::string why = incomparable(state, cold); !why.empty()) lines.push_back(why);
  return lines;
}

bool lacks_cold_time(const ViewState& state) {
  return lacks_cold(state.ours) || lacks_cold(state.cgal);
}

std::optional<double> speed_up(const ViewState& state, bool cold) {
  const auto& ours = cold ? state.ours.cold : state.ours.warm;
  const auto& cgal = cold ? state.cgal.cold : state.cgal.warm;
  if (!ours || !cgal || too_few_balls(state) || !ours->comparable(*cgal)) return {};
  if (ours->times.wall_milliseconds <= 0) return {};
  return cgal->times.wall_milliseconds / ours->times.wall_milliseconds;
}

std::string wall_text(const std::optional<MeasuredRun>& run) {
  return run ? milliseconds_text(run->times.wall_milliseconds) : std::string("not measured");
}

}  // namespace alphascope
