// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions of the results on cavities, with their memory and keys.
#include "core/document/cavities/cavity_results.hpp"

#include "core/cavity/cavity_depth.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/cavity_identity/cavity_trace.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

// Memory of a table with `bytes` for each row, and a constant for small objects.
MemoryNeed row_memory(const CavityTable& table, std::size_t bytes) {
  const std::uint64_t all = table.size() * bytes + 1'000'000;
  return {all, all};
}

// Bytes for each tetrahedron: its triangles (16), two triangles with their tetrahedra and edges
// (64), 1.2 edges (10), marks and value of the flow (5). Collecting incidences takes as much again.
MemoryNeed ground_memory(std::size_t tetrahedra) {
  constexpr std::uint64_t kHeld = 100, kPeak = 200;  // bytes a tetrahedron
  return {kHeld * tetrahedra, kPeak * tetrahedra};
}

// Memory for marks of all simplices and labels of all tetrahedra. Splitting networks needs a
// filtration (120 bytes a tetrahedron), and the cavities at another alpha.
MemoryNeed table_memory(std::size_t tetrahedra, bool splits) {
  constexpr std::uint64_t kHeld = 30, kPeak = 60, kSplitPeak = 300;
  return {kHeld * tetrahedra, (splits ? kSplitPeak : kPeak) * tetrahedra};
}

Key key_of_rule(const Inputs& in) {
  constexpr std::uint64_t kPocket = 0x706f636b65745f72;  // differs from the numbers of other keys
  Key key = key_of_balls(in);
  key.more = in.outside_rule == OutsideRule::pocket ? kPocket : 0;
  return key;
}

// What lines take over from those before them. Both are null where there are none.
struct Followed {
  std::shared_ptr<const CavityNumbers> numbers;
  std::shared_ptr<const CavityTrace> trace;
};

CavityLine make_line(const CavityTable& table, const BallReferences& atoms, std::size_t row) {
  const CavityMeasures& m = table.measure(row);
  CavityLine line;
  line.is_void = table.cavity(row).is_void();
  line.volume_sa_angstrom3 = m.volume_sa_angstrom3;
  line.area_sa_angstrom2 = m.area_sa_angstrom2;
  line.volume_ms_angstrom3 = m.volume_ms_angstrom3;
  line.area_ms_angstrom2 = m.area_ms_angstrom2;
  line.mouth_area_angstrom2 = m.all_mouths().area_angstrom2;
  line.mouths = m.mouths.size();
  line.lining = lining_counts(atoms, table, row);
  line.bodies = table.cavity(row).bodies;
  line.passages = table.cavity(row).passages.size();
  line.is_network = table.cavity(row).is_network();
  line.is_part = table.cavity(row).is_part();
  return line;
}

std::shared_ptr<const CavityLines> make_lines(const Inputs& in, const Followed& before,
                                              const RunContext& context) {
  auto lines = std::make_shared<CavityLines>();
  lines->table = in.share(cavity_table());
  lines->atoms = in.atoms;
  lines->numbers = std::make_shared<const CavityNumbers>(
      before.numbers ? next_numbers(*before.numbers, lines->table, context.cancel)
                     : first_numbers(lines->table));
  lines->trace = next_trace(before.trace.get(), *lines->numbers);
  lines->of.resize(lines->table->size());
  parallel_many(lines->of.size(), context.cancel, [&](std::size_t row) {
    lines->of[row] = make_line(*lines->table, *lines->atoms, row);
  });
  return lines;
}

CavityDepths make_cavity_depths(const CavityTable& table, const RunContext& context) {
  CavityDepths depths;
  for (std::size_t row = 0; row < table.size(); ++row) {
    context.report("depths", static_cast<double>(row) / static_cast<double>(table.size()));
    depths.of_angstrom.push_back(depth_angstrom(*table.ground, table.cavity(row),
                                                table.measure(row).lining, context.cancel));
  }
  return depths;
}

}  // namespace

const Definition<CavityGround>& cavity_ground() {
  static const Definition<CavityGround> definition{
      {.id = "cavities.ground",
       .title = "Flow of the triangulation",
       .made_of = {&whole_triangulation()},
       .key =
           [](const Inputs& in) {
             constexpr std::uint64_t kStrict =
                 0x7374726963745f66;  // differs from the numbers of other keys
             Key key = key_of_balls(in);
             key.more = in.flow_ties == FlowTies::strict ? kStrict : 0;
             return key;
           },
       .memory =
           [](const Inputs& in) {
             return ground_memory(in.of(whole_triangulation()).tetrahedra.size());
           },
       .lane = Lane::interactive,
       .keep_stale = false},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const CavityGround>(
            make_cavity_ground(in.balls, in.share(whole_triangulation()), in.flow_ties, context,
                               in.triangulation_maker.get()));
      }};
  return definition;
}

const Definition<CavityTable>& cavity_table() {
  static const Definition<CavityTable> definition{
      {.id = "cavities.table",
       .title = "Cavities",
       .made_of = {&cavity_ground()},
       .key =
           [](const Inputs& in) {
             constexpr std::uint64_t kSplit =
                 0x73706c69745f6e65;  // differs from the numbers of other keys
             Key key = joined(key_of_balls_and_alpha(in), key_of_rule(in));
             return in.split_networks ? joined(key, {key.balls, 0, kSplit}) : key;
           },
       .memory =
           [](const Inputs& in) {
             return table_memory(in.of(cavity_ground()).triangulation->tetrahedra.size(),
                                 in.split_networks);
           },
       .lane = Lane::interactive},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const CavityTable>(make_cavity_table(
            in.share(cavity_ground()),
            {in.alpha_angstrom2, in.solvent_radius_angstrom, in.outside_rule, in.split_networks},
            context, in.triangulation_maker.get()));
      }};
  return definition;
}

const Definition<ExactVolumes>& cavity_volumes() {
  static const Definition<ExactVolumes> definition{
      {.id = "cavities.exact",
       .title = "Exact volumes of cavities",
       .made_of = {&cavity_table()},
       .key = key_of_balls_and_alpha,
       .memory =
           [](const Inputs& in) {
             return row_memory(in.of(cavity_table()), sizeof(ExactCavityMeasures));
           }},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const ExactVolumes>(
            ExactVolumes{measure_all_exactly(in.of(cavity_table()), context)});
      }};
  return definition;
}

Key key_of_cavity(const Inputs& in, const std::array<BallIndex, 4>& sink) {
  Key key = key_of_balls_and_alpha(in);
  for (const BallIndex ball : sink) key.more = Key{key.more + 1, ball, 0}.number();
  return key;
}

bool CavityLines::is_of(const Inputs& in) const {
  return table->ground->balls == in.balls &&
         table->question.alpha_angstrom2 == in.alpha_angstrom2 &&
         table->question.split_networks == in.split_networks;
}

bool CavityLines::is_of_but_for_radius(const Inputs& in) const {
  return in.atoms && &atoms->prepared() == &in.atoms->prepared() &&
         table->question == CavityParameters{in.alpha_angstrom2,
                                             table->question.solvent_radius_angstrom,
                                             in.outside_rule, in.split_networks};
}

bool CavityLines::continues(const CavityLines& earlier) const {
  return &atoms->prepared() == &earlier.atoms->prepared() &&
         numbers->steps >= earlier.numbers->steps;
}

Definition<CavityLines> cavity_lines(const std::shared_ptr<const CavityLines>& lines) {
  const Followed before = lines ? Followed{lines->numbers, lines->trace} : Followed{};
  const auto key = [before](const Inputs& in) {
    if (!in.atoms) return Key{};
    Key all = key_of_balls_and_alpha(in);
    if (before.numbers) all.more = before.numbers->steps + 1;
    return all;
  };
  const auto memory = [before](const Inputs& in) {
    constexpr std::size_t kNumber = 60;  // bytes: a number, its known sink, and how it merged
    constexpr std::size_t kRow = sizeof(CavityLine) + kNumber + sizeof(TracedCavity);
    MemoryNeed need = row_memory(in.of(cavity_table()), kRow);
    const std::uint64_t known = before.numbers ? kNumber * before.numbers->known.size() : 0;
    const std::uint64_t traced = before.trace ? bytes_of(*before.trace) : 0;
    return MemoryNeed{need.held + known + traced, need.peak + known + traced};
  };
  return {{.id = "cavities.lines",
           .title = "Rows of the table of cavities",
           .made_of = {&cavity_table()},
           .key = key,
           .memory = memory,
           .lane = Lane::interactive},
          [before](const Inputs& in, const RunContext& context) {
            return make_lines(in, before, context);
          }};
}

const Definition<CavityDepths>& cavity_depths() {
  static const Definition<CavityDepths> definition{
      {.id = "cavities.depths",
       .title = "Depths of pockets",
       .made_of = {&cavity_table()},
       .key = key_of_balls_and_alpha,
       .memory =
           [](const Inputs& in) { return row_memory(in.of(cavity_table()), sizeof(double)); }},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const CavityDepths>(
            make_cavity_depths(in.of(cavity_table()), context));
      }};
  return definition;
}

const Definition<CavityLives>& whole_cavity_lives() {
  static const Definition<CavityLives> definition{
      {.id = "cavities.lives",
       .title = "Births and ends of cavities",
       .made_of = {&cavity_ground()},
       .key = key_of_rule,
       .memory =
           [](const Inputs& in) {
             // Bytes for each tetrahedron while lives are made: its life, that of its sets, and two
             // gates. Fewer than one in twenty is a sink.
             constexpr std::uint64_t kHeld = 2, kPeak = 60;
             const std::uint64_t n = in.of(cavity_ground()).triangulation->tetrahedra.size();
             return MemoryNeed{kHeld * n, kPeak * n};
           }},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const CavityLives>(
            cavity_lives(in.of(cavity_ground()), in.outside_rule, context.cancel));
      }};
  return definition;
}

}  // namespace alphascope
