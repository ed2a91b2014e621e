// SPDX-License-Identifier: GPL-3.0-or-later
// The engines of the host, on one thread and on as many as their parallel code needs. Under a
// sanitizer an engine whose code is the same on one thread runs on several only.
#include <string>
#include <utility>

#include "core/tuples/tuple_engine.hpp"
#include "tests/support/dual_edge_only_engine.hpp"
#include "tests/support/engines.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope::testing {

std::vector<EngineFactory> engines() {
  std::vector<EngineFactory> engines;
  for (const int threads : {1, 4}) {
    engines.push_back({"cgal_" + std::to_string(threads), [threads](auto balls) {
                         return keeping(make_cgal_engine(std::move(balls), {threads}));
                       }});
  }
  for (int threads = unless_sanitized(1, 2); threads <= 2; ++threads) {
    engines.push_back({"cpu_" + std::to_string(threads), [threads](auto balls) {
                         return keeping(make_cpu_engine(std::move(balls), {threads}));
                       }});
    engines.push_back({"dual_edges_" + std::to_string(threads), [threads](auto balls) {
                         return std::make_unique<DualEdgeOnlyEngine>(std::move(balls), threads);
                       }});
  }
  // Work grows with the cube of the number of neighbours.
  TupleOptions batches;
  batches.tuples_per_batch = 700;  // small sets then need many batches
  for (const auto& [name, options] :
       {std::pair("tuples_1", TupleOptions{}), {"tuples_2", batches}}) {
    const int threads = options == batches ? 2 : 1;
    if (kAddressSanitizer && threads == 1) continue;
    engines.push_back({name,
                       [threads, options = options](auto balls) {
                         return make_tuple_engine(std::move(balls), {threads}, options);
                       },
                       35, 3e6});
  }
  return engines;
}

}  // namespace alphascope::testing
