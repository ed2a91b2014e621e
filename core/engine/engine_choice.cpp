// SPDX-License-Identifier: GPL-3.0-or-later
// The table of engines that every program offers, and searches in it by id, choice and suite.
#include "core/engine/engine_choice.hpp"

#include <algorithm>

namespace alphascope {
namespace {

constexpr EngineEntry kEngines[] = {
    {.choice = EngineChoice::automatic,
     .id = "auto",
     .title = "Automatic",
     .help = "The dual-edge engine: on the GPU when it can be used, else on the CPU."},
    {.choice = EngineChoice::gpu,
     .id = "gpu",
     .title = "Dual-edge engine, GPU",
     .help = "Alphascope's own engine, on the graphics processor: for every three neighbours it "
             "clips their dual edge.",
     .needs_gpu = true,
     .suite_place = 2},
    {.choice = EngineChoice::cpu,
     .id = "cpu",
     .title = "Dual-edge engine, CPU",
     .help = "Alphascope's own engine, on all cores: for every three neighbours it clips their "
             "dual edge. It makes the triangulation of all balls where that is faster.",
     .suite_place = 4},
    {.choice = EngineChoice::tuples_gpu,
     .id = "tuples-gpu",
     .title = "Tuple engine (thesis), GPU",
     .help = "The pipeline of N. P. Ranjanikar's thesis on the graphics processor: it makes all "
             "4-tuples of neighbours, then tests them. Slow at large alpha; Esc cancels.",
     .needs_gpu = true,
     .is_tuples = true,
     .suite_place = 1},
    {.choice = EngineChoice::tuples_cpu,
     .id = "tuples-cpu",
     .title = "Tuple engine (thesis), CPU",
     .help = "The pipeline of N. P. Ranjanikar's thesis on all cores: it makes all 4-tuples of "
             "neighbours, then tests them. Slow at large alpha; Esc cancels.",
     .is_tuples = true,
     .suite_place = 3},
    {.choice = EngineChoice::cgal,
     .id = "cgal",
     .title = "CGAL triangulation",
     .help = "CGAL's regular triangulation of all balls, then its simplices up to alpha. The other "
             "engines are compared with this one."},
};

bool is_in(const EngineEntry& entry, EngineGroup group) {
  return group == EngineGroup::all || (group == EngineGroup::tuples && entry.is_tuples) ||
         (group == EngineGroup::suite && entry.suite_place != 0);
}

}  // namespace

std::span<const EngineEntry> engine_table() {
  return kEngines;
}

const EngineEntry& engine_entry(EngineChoice choice) {
  return *std::find_if(std::begin(kEngines), std::end(kEngines),
                       [&](const EngineEntry& entry) { return entry.choice == choice; });
}

std::optional<EngineChoice> engine_from_id(std::string_view id) {
  for (const EngineEntry& entry : kEngines) {
    if (entry.id == id) return entry.choice;
  }
  return std::nullopt;
}

std::vector<EngineChoice> suite_engines() {
  std::vector<EngineChoice> engines;
  for (const EngineEntry& entry : kEngines) {
    if (is_in(entry, EngineGroup::suite)) engines.push_back(entry.choice);
  }
  std::sort(engines.begin(), engines.end(), [](EngineChoice a, EngineChoice b) {
    return engine_entry(a).suite_place < engine_entry(b).suite_place;
  });
  return engines;
}

std::string engine_ids(EngineGroup group, std::string_view separator) {
  std::string ids;
  for (const EngineEntry& entry : kEngines) {
    if (!is_in(entry, group)) continue;
    if (!ids.empty()) ids += separator;
    ids += entry.id;
  }
  return ids;
}

}  // namespace alphascope
