#include "app/cli/cavity_answer.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "app/cli/text.hpp"
#include "app/session/rounding_note.hpp"
#include "core/cavity/cavity_depth.hpp"
#include "core/document/cavity_preset.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/cgal_triangulation.hpp"

namespace alphascope::cli {
namespace {

std::vector<std::size_t> ranks_by_clipped(const CavityAnswer& answer) {
  std::vector<std::size_t> order(answer.table.size()), rank(order.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return answer.clipped(a).volume_sa_angstrom3 > answer.clipped(b).volume_sa_angstrom3;
  });
  for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = k + 1;
  return rank;
}

std::vector<double> depths(const CavityTable& table, const CancelToken& cancel) {
  std::vector<double> depths;
  for (std::size_t row = 0; row < table.size(); ++row) {
    depths.push_back(
        depth_angstrom(*table.ground, table.cavity(row), table.measure(row).lining, cancel));
  }
  return depths;
}

void fill(CavityAnswer& answer, const CavitiesOptions& options, int threads,
          const RunContext& context) {
  StageTimer timer(answer.times);
  const Request& request = answer.request;
  const auto balls = std::make_shared<const BallSet>(
      with_solvent(*answer.input.prepared().balls, request.solvent_radius_angstrom));
  const auto triangulation =
      std::make_shared<const Triangulation>(make_triangulation(*balls, threads, context));
  timer.lap(stage::kTriangulation, true);
  const auto ground = std::make_shared<const CavityGround>(
      make_cavity_ground(balls, triangulation, options.ties, context));
  timer.lap(stage::kFlow, true);
  answer.table = make_cavity_table(
      ground, {request.alpha_angstrom2, request.solvent_radius_angstrom, options.rule}, context);
  timer.lap(stage::kCavities);
  answer.exact = clip_all(answer.table, context);
  timer.lap(stage::kExactVolumes);
  answer.clipped_rank = ranks_by_clipped(answer);
  answer.depth_angstrom = depths(answer.table, context.cancel);
  if (answer.table.size() > 0) answer.lives = cavity_lives(*ground, options.rule, context.cancel);
  answer.contents = find_contents(answer.atoms, answer.table, context.cancel);
  timer.lap("depths, lives, contents");
  timer.finish();
}

}  // namespace

bool CavityAnswer::is_doubtful(std::size_t row) const {
  return alphascope::is_doubtful(table.measure(row).volume_sa_angstrom3,
                                 clipped(row).volume_sa_angstrom3);
}

std::string CavityAnswer::contents_text(std::size_t row) const {
  return alphascope::contents_text(input.molecule(), contents, table.order[row]);
}

CavityAnswer::Life CavityAnswer::life(std::size_t row) const {
  const CavityLife& life = lives.of(table.cavity(row).deepest_sink);
  const Lattice& lattice = table.ground->balls->lattice;
  return {lattice.square_angstrom(life.born), lattice.square_angstrom(life.closed),
          lattice.square_angstrom(life.gone), life.closed < life.gone};
}

CavityAnswer find_cavities_of(const Input& input, const CavitiesOptions& options,
                              double solvent_radius_angstrom, const RunContext& context) {
  CavityAnswer answer(input);
  answer.request = options.request;
  answer.request.solvent_radius_angstrom = solvent_radius_angstrom;
  answer.differences =
      differences_from_castp(input.balls, input.prepared().report.radii, answer.request);
  if (options.rule == OutsideRule::pocket)
    answer.differences.push_back("Pocket's rule of what is outside");
  if (options.ties == FlowTies::strict) answer.differences.push_back("ties do not flow");
  WorkThreads threads(answer.request.threads);
  answer.device = threads.text();
  threads.run([&] { fill(answer, options, threads.used(), context); });
  for (std::size_t row = 0; row < answer.table.size(); ++row) {
    const double volume = answer.table.measure(row).volume_sa_angstrom3;
    if (!options.min_volume_angstrom3 || volume >= *options.min_volume_angstrom3)
      answer.rows.push_back(row);
  }
  return answer;
}

std::string comparable_text(const CavityAnswer& answer) {
  if (answer.differences.empty()) return "comparable with CASTp";
  std::string text = "not comparable with CASTp: ";
  for (std::size_t k = 0; k < answer.differences.size(); ++k) {
    text += (k ? "; " : "") + answer.differences[k];
  }
  return text;
}

std::vector<std::string> notes_of(const CavityAnswer& answer, const CavitiesOptions& options) {
  std::vector<std::string> notes;
  const CavityTable& table = answer.table;
  const std::string rounding = rounding_note(answer.request, table.ground->balls->lattice);
  if (!rounding.empty()) notes.push_back(rounding);
  if (table.ground->triangulation->dimension < 3) {
    notes.push_back("the centres lie in one plane, so there are no cavities");
  }
  if (table.found.components > 1) {
    notes.push_back("the body has " + grouped(static_cast<std::uint64_t>(table.found.components)) +
                    " separate parts: spaces between them count as pockets");
  }
  constexpr double kNarrowAngstrom = 0.5;
  if (answer.request.solvent_radius_angstrom < kNarrowAngstrom && table.size() > 0) {
    notes.push_back(
        "with so small a solvent radius the gaps between atoms join into one large pocket; "
        "--solvent 1.4 parts them");
  }
  if (answer.rows.size() < table.size()) {
    notes.push_back(grouped(table.size() - answer.rows.size()) + " cavities below " +
                    number_text(*options.min_volume_angstrom3) + " Å³ are counted, but not listed");
  }
  return notes;
}

}  // namespace alphascope::cli
