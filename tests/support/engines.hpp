// The engines present, for suites that must hold of every one of them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/complex/engine.hpp"
#include "tests/support/facet_only_engine.hpp"

namespace alphascope::testing {

struct EngineFactory {
  std::string name;  // letters, digits and _ only
  std::function<std::unique_ptr<Engine>(std::shared_ptr<const BallSet>)> make;
  friend void PrintTo(const EngineFactory& factory, std::ostream* out) { *out << factory.name; }
};

// Host engines, on one thread and on as many as switch their parallel code on. Suites of other
// targets may append to the list.
inline std::vector<EngineFactory> host_engines() {
  std::vector<EngineFactory> engines;
  for (const int threads : {1, 4}) {
    engines.push_back({"cgal_" + std::to_string(threads), [threads](auto balls) {
                         return make_cgal_engine(std::move(balls), {threads});
                       }});
  }
  for (const int threads : {1, 2}) {
    engines.push_back({"cpu_" + std::to_string(threads), [threads](auto balls) {
                         return make_cpu_engine(std::move(balls), {threads});
                       }});
    engines.push_back({"facets_" + std::to_string(threads), [threads](auto balls) {
                         return std::make_unique<FacetOnlyEngine>(std::move(balls), threads);
                       }});
  }
  return engines;
}

// What GoogleTest appends to the names of parametrised tests.
inline std::string engine_name(const ::testing::TestParamInfo<EngineFactory>& info) {
  return info.param.name;
}

}  // namespace alphascope::testing
