// SPDX-License-Identifier: GPL-3.0-or-later
// The definition of the derived result on where a network falls apart, with its memory and key.
#include "core/document/channels/network_results.hpp"

#include <memory>
#include <stdexcept>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

std::shared_ptr<const FoundNetworkEnd> make_end(const Inputs& in,
                                                const std::array<BallIndex, 4>& sink,
                                                const RunContext& context) {
  const CavityTable& table = in.of(cavity_table());
  const BallSet balls = balls_without_solvent(in);
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.sink(row) != sink) continue;
    return std::make_shared<const FoundNetworkEnd>(FoundNetworkEnd{
        sink, find_network_end(balls, table, table.order[row],
                               {in.triangulation_maker, in.triangulation_threads, in.flow_ties},
                               context)});
  }
  throw std::invalid_argument("there is no such cavity");
}

// Memory for a triangulation with its tables, and for a filtration of the present triangulation
// before it.
MemoryNeed end_memory(const Inputs& in) {
  constexpr std::uint64_t kTables = 300, kHeld = 10'000;  // bytes a tetrahedron; bytes in all
  const std::uint64_t tetrahedra = in.of(cavity_table()).ground->triangulation->tetrahedra.size();
  return {kHeld, triangulation_memory(in.balls->size()).peak + kTables * tetrahedra + kHeld};
}

}  // namespace

Definition<FoundNetworkEnd> network_end(const std::array<BallIndex, 4>& sink) {
  return {
      {.id = "cavities.network_end",
       .title = "Where the network falls apart",
       .made_of = {&cavity_table()},
       .key = [sink](const Inputs& in) { return key_of_cavity(in, sink); },
       .memory = end_memory},
      [sink](const Inputs& in, const RunContext& context) { return make_end(in, sink, context); }};
}

}  // namespace alphascope
