// See the header.
#include "core/engine/engine_choice.hpp"

#include <algorithm>

namespace alphascope {
namespace {

struct Names {
  EngineChoice choice;
  std::string_view id, title;
};

constexpr Names kNames[] = {
    {EngineChoice::automatic, "auto", "Automatic"},
    {EngineChoice::gpu, "gpu", "Dual-edge engine, GPU"},
    {EngineChoice::cpu, "cpu", "Dual-edge engine, CPU"},
    {EngineChoice::tuples_gpu, "tuples-gpu", "Tuple engine (thesis), GPU"},
    {EngineChoice::tuples_cpu, "tuples-cpu", "Tuple engine (thesis), CPU"},
    {EngineChoice::cgal, "cgal", "CGAL triangulation"},
};

const Names& names(EngineChoice choice) {
  return *std::find_if(std::begin(kNames), std::end(kNames),
                       [&](const Names& n) { return n.choice == choice; });
}

}  // namespace

std::string_view engine_id(EngineChoice choice) {
  return names(choice).id;
}

std::string_view engine_title(EngineChoice choice) {
  return names(choice).title;
}

std::optional<EngineChoice> engine_from_id(std::string_view id) {
  for (const Names& n : kNames) {
    if (n.id == id) return n.choice;
  }
  return std::nullopt;
}

}  // namespace alphascope
