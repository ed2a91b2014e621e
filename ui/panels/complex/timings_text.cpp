// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the page of timings, and the speed-up against CGAL.
#include "ui/panels/complex/timings_text.hpp"

#include "core/document/store/answer.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "core/text/grouped_number.hpp"
#include "core/triangulation/triangulation_report.hpp"
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
    return "No speed-up: in both runs the complex was selected from the triangulation of all "
           "balls. "
           "Choose “Cold” to compare the engines.";
  }
  return "No speed-up: " + (ours->rebuilt ? state.ours.engine.name : std::string("CGAL")) +
         " prepared its data for later alphas in this run; the other engine reused its own.";
}

constexpr const char* kBetweenParts = "  ·  ";

// CGAL's run for the complex on screen, and whether it made its triangulation anew.
struct CgalRun {
  const std::optional<MeasuredRun>* run = nullptr;
  bool cold = false;
};

// Chooses the run of the kind that made the complex on screen, and otherwise the other one.
CgalRun cgal_run(const ViewState& state) {
  const BadgeInfo::State badge = state.badge.state;
  if (badge != BadgeInfo::State::identical && badge != BadgeInfo::State::different) return {};
  const bool first_cold = state.result->cold;
  for (const bool cold : {first_cold, !first_cold}) {
    const auto& run = cold ? state.cgal.cold : state.cgal.warm;
    if (run && run->alpha_angstrom2 == state.result->request.alpha_angstrom2 &&
        run->tetrahedra_only == state.shows_tetrahedra_only()) {
      return {&run, cold};
    }
  }
  return {};
}

const char* badge_words(BadgeInfo::State state) {
  switch (state) {
    case BadgeInfo::State::identical:
      return "✓ identical";
    case BadgeInfo::State::different:
      return "≠ different";
    case BadgeInfo::State::failed:
      return "comparison failed";
    case BadgeInfo::State::comparing:
      return "comparing…";
    case BadgeInfo::State::not_compared:
      break;
  }
  return "not compared";
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

std::vector<std::string> triangulation_sentences(const TriangulationReport& report) {
  using By = TriangulationReport::By;
  std::vector<std::string> sentences;
  if (!report.why_not.empty())
    sentences.push_back("The GPU did not make the triangulation of all balls: " + report.why_not +
                        ".");
  if (report.by == By::insertion && report.inserters > 1)
    sentences.push_back("Balls were inserted in up to " + std::to_string(report.inserters) +
                        " places at the same time, and " +
                        counted(report.put_off, "ball was", "balls were") +
                        " put off to a later turn.");
  if (report.by != By::device) return sentences;
  return {"Wrapping began with " + counted(report.known, "tetrahedron", "tetrahedra") + ", " +
              counted(report.open_faces, "open face", "open faces") + " and " +
              counted(report.needed, "ball", "balls") + ", and took " +
              counted(report.waves, "wave", "waves") + ".",
          "The certificate proved every tetrahedron, neighbour and hidden ball."};
}

const char* badge_mark(BadgeInfo::State state) {
  switch (state) {
    case BadgeInfo::State::identical:
      return "✓ ";
    case BadgeInfo::State::different:
      return "≠ ";
    case BadgeInfo::State::failed:
    case BadgeInfo::State::comparing:
    case BadgeInfo::State::not_compared:
      break;
  }
  return "";
}

std::string LastMove::line() const {
  std::string text;
  for (const std::string* part : {&time, &engine, &cgal, &badge}) {
    if (part->empty()) continue;
    if (!text.empty()) text += kBetweenParts;
    text += *part;
  }
  return text;
}

std::vector<LastMove> last_move(const ViewState& state, const TriangulationReport* triangulation) {
  const Answer& answer = *state.result;
  const EngineInfo& engine = answer.complex.engine;
  const std::string engine_time = milliseconds_text(answer.complex.timings.wall_milliseconds);
  const bool moved = state.move_milliseconds.has_value();
  const std::string time = moved ? milliseconds_text(*state.move_milliseconds) : engine_time;
  const CgalRun cgal = cgal_run(state);
  const std::string cgal_time = cgal.run ? "CGAL " + wall_text(*cgal.run) : std::string();

  LastMove full{time + (moved ? " to picture" : " to compute"), engine.name, cgal_time,
                badge_words(state.badge.state), ""};
  if (!engine.device.empty()) full.engine += " on " + engine.device;
  const bool refused = triangulation != nullptr && !triangulation->why_not.empty();
  if (refused)
    full.engine += ", triangulation by " + (triangulation->by == TriangulationReport::By::insertion
                                                ? std::string("the CPU")
                                                : triangulation->maker);
  if (moved) full.help = "Last move: " + time + " from the change to the finished picture.\n";
  full.help += full.engine + ": " + engine_time + " for the complex.\n";
  if (cgal.run) {
    full.help += "CGAL: " + wall_text(*cgal.run) + " for the same complex, " +
                 (cgal.cold ? "with its triangulation.\n" : "from its triangulation.\n");
  }
  if (refused) full.help += triangulation_sentences(*triangulation).front() + "\n";
  full.help += badge_mark(state.badge.state) + state.badge.text + "\n\nClick to see each stage.";

  LastMove middle = full, least = full;
  middle.time = least.time = time;
  least.engine = engine.device.substr(0, engine.device.find(','));  // "CPU"
  if (const std::string mark = badge_mark(state.badge.state); !mark.empty()) {
    least.badge = mark.substr(0, mark.size() - 1);
  }
  return {full, middle, least};
}

std::string wall_text(const std::optional<MeasuredRun>& run) {
  return run ? milliseconds_text(run->times.wall_milliseconds) : std::string("not measured");
}

}  // namespace alphascope
