// SPDX-License-Identifier: GPL-3.0-or-later
// The engines that every program offers. A new engine is an enumerator here and a line of the
// table. make_engine() in the session makes them, because only the session sees the GPU's engines.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// automatic: the dual-edge engine, on the GPU when it can be used, else on the CPU. The tuple
// engines are the pipeline of the thesis.
enum class EngineChoice : std::uint8_t { automatic, gpu, cpu, tuples_gpu, tuples_cpu, cgal };

struct EngineEntry {
  EngineChoice choice;
  std::string_view id;     // "tuples-gpu": in commands and files
  std::string_view title;  // "Tuple engine (thesis), GPU": for people
  const char* help;        // a sentence or two
  bool needs_gpu = false;
  bool is_tuples = false;  // it takes TupleOptions
  int suite_place = 0;     // its place in the thesis' suite; 0: not in it
};

// In the order in which they are offered.
std::span<const EngineEntry> engine_table();
const EngineEntry& engine_entry(EngineChoice choice);

inline std::string_view engine_id(EngineChoice choice) {
  return engine_entry(choice).id;
}
inline std::string_view engine_title(EngineChoice choice) {
  return engine_entry(choice).title;
}
inline bool is_tuple_engine(EngineChoice choice) {
  return engine_entry(choice).is_tuples;
}
inline bool needs_gpu(EngineChoice choice) {
  return engine_entry(choice).needs_gpu;
}
std::optional<EngineChoice> engine_from_id(std::string_view id);

// The engines of the thesis' suite, by suite_place. The suite always has CGAL as well.
std::vector<EngineChoice> suite_engines();

// The ids of a group of engines, joined by the separator: "auto|gpu|cpu".
enum class EngineGroup : std::uint8_t { all, tuples, suite };
std::string engine_ids(EngineGroup group, std::string_view separator);

}  // namespace alphascope
