// See the header.
#include "core/document/cavity_results.hpp"

namespace alphascope {
namespace {

// Of a tetrahedron: its triangles (16 bytes), two triangles with their tetrahedra and edges (64),
// 1.2 edges (10), marks and value of the flow (5). While incidences are collected, as much again.
MemoryNeed ground_memory(std::size_t tetrahedra) {
  constexpr std::uint64_t kHeld = 100, kPeak = 200;  // bytes a tetrahedron
  return {kHeld * tetrahedra, kPeak * tetrahedra};
}

// Marks of all simplices and labels of all tetrahedra.
MemoryNeed table_memory(std::size_t tetrahedra) {
  constexpr std::uint64_t kHeld = 30, kPeak = 60;
  return {kHeld * tetrahedra, kPeak * tetrahedra};
}

}  // namespace

const Definition<CavityGround>& cavity_ground() {
  static const Definition<CavityGround> definition{
      {.id = "cavities.ground",
       .title = "Flow of the triangulation",
       .made_of = {&whole_triangulation()},
       .key = key_of_balls,
       .memory =
           [](const Inputs& in) {
             return ground_memory(in.of(whole_triangulation()).tetrahedra.size());
           },
       .keep_stale = false},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const CavityGround>(make_cavity_ground(
            in.balls, in.share(whole_triangulation()), FlowTies::perturbed, context));
      }};
  return definition;
}

const Definition<CavityTable>& cavity_table() {
  static const Definition<CavityTable> definition{
      {.id = "cavities.table",
       .title = "Cavities",
       .made_of = {&cavity_ground()},
       .key = key_of_balls_and_alpha,
       .memory =
           [](const Inputs& in) {
             return table_memory(in.of(cavity_ground()).triangulation->tetrahedra.size());
           },
       .lane = Lane::interactive},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const CavityTable>(make_cavity_table(
            in.share(cavity_ground()), {in.alpha_angstrom2, in.solvent_radius_angstrom}, context));
      }};
  return definition;
}

Definition<CavityNumbers> cavity_numbers(std::shared_ptr<const CavityNumbers> before) {
  const auto key = [before](const Inputs& in) {
    Key key = key_of_balls_and_alpha(in);
    if (before) key.more = before->steps + 1;
    return key;
  };
  const auto memory = [before](const Inputs& in) {
    constexpr std::uint64_t kBytesPerCavity = 100;  // a number, and a node of the known sinks
    const std::uint64_t known = before ? before->known.size() : 0;
    const std::uint64_t bytes = kBytesPerCavity * (in.of(cavity_table()).size() + known);
    return MemoryNeed{bytes, bytes};
  };
  const auto make = [before](const Inputs& in, const RunContext& context) {
    auto table = in.share(cavity_table());
    return std::make_shared<const CavityNumbers>(
        before ? next_numbers(*before, std::move(table), context.cancel)
               : first_numbers(std::move(table)));
  };
  return {{.id = "cavities.numbers",
           .title = "Which cavity is which",
           .made_of = {&cavity_table()},
           .key = key,
           .memory = memory,
           .lane = Lane::interactive},
          make};
}

const Definition<ExactVolumes>& cavity_volumes() {
  static const Definition<ExactVolumes> definition{
      {.id = "cavities.exact",
       .title = "Exact volumes of cavities",
       .made_of = {&cavity_table()},
       .key = key_of_balls_and_alpha,
       .memory =
           [](const Inputs& in) {
             const std::uint64_t bytes =
                 in.of(cavity_table()).size() * sizeof(ClippedMeasures) + 1'000'000;
             return MemoryNeed{bytes, bytes};
           }},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const ExactVolumes>(
            ExactVolumes{clip_all(in.of(cavity_table()), context)});
      }};
  return definition;
}

}  // namespace alphascope
