// The engines present, for suites that must hold of every one of them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/complex/engine.hpp"
#include "core/complex/tuple_engine.hpp"
#include "core/geometry/coincident.hpp"
#include "tests/support/facet_only_engine.hpp"

#if defined(ALPHASCOPE_TEST_GPU_ENGINES) || defined(ALPHASCOPE_TEST_EMULATED_GPU)
#include "gpu/tuple_engine.hpp"
#include "tests/support/device_engine.hpp"
#endif

namespace alphascope::testing {

struct EngineFactory {
  std::string name;  // letters, digits and _ only
  std::function<std::unique_ptr<Engine>(std::shared_ptr<const BallSet>)> make;
  // What is slow beyond use on larger sets, or where balls have more neighbours, says so here.
  int most_balls = 1000;
  double most_tuples = std::numeric_limits<double>::infinity();
  // Why there can be no such engine on this machine; empty when there can.
  std::string why_not = {};

  // Would this engine take no more than seconds?
  bool affords(const BallSet& balls, double alpha_angstrom2) const {
    if (most_tuples == std::numeric_limits<double>::infinity()) return true;
    const double alpha = balls.lattice.alpha_on_lattice(alpha_angstrom2);
    const UniformGrid grid = make_uniform_grid(balls, alpha, coincident_hidden(balls));
    const double later = sample_neighbours(grid, 64).mean / 2;
    return static_cast<double>(grid.size()) * later * later * later / 6 < most_tuples;
  }
  friend void PrintTo(const EngineFactory& factory, std::ostream* out) { *out << factory.name; }
};

// Host engines, on one thread and on as many as switch their parallel code on.
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
  // The work grows with the cube of the neighbours.
  TupleOptions batches;
  batches.tuples_per_batch = 700;  // so that small sets need many
  for (const auto& [name, options] :
       {std::pair("tuples_1", TupleOptions{}), {"tuples_2", batches}}) {
    const int threads = options == batches ? 2 : 1;
    engines.push_back({name,
                       [threads, options](auto balls) {
                         return make_tuple_engine(std::move(balls), {threads}, options);
                       },
                       35, 3e6});
  }
  return engines;
}

#ifdef ALPHASCOPE_TEST_GPU_ENGINES
// The same suites are compiled a second time for the device's engines (tests/gpu).
inline std::vector<EngineFactory> engines() {
  const std::string why_not = gpu_device().usable ? "" : gpu_device().why_not;
  const auto tuples = [](auto balls) {
    return make_gpu_tuple_engine(std::move(balls), {}, nullptr);
  };
  return {{"gpu", [](auto balls) { return make_device_engine(std::move(balls)); }, 1000,
           std::numeric_limits<double>::infinity(), why_not},
          {"gpu_tuples", tuples, 35, 3e6, why_not}};
}
#elif defined(ALPHASCOPE_TEST_EMULATED_GPU)
// And a third time for its kernels on the CPU (tests/gpu/emulated), which is slow.
inline std::vector<EngineFactory> engines() {
  // On several streams, in batches that small sets need, too.
  TupleOptions batches;
  batches.streams = 3;
  batches.tuples_per_batch = 700;
  const auto tuples = [batches](auto balls) {
    return make_gpu_tuple_engine(std::move(balls), batches, nullptr);
  };
  return {
      {"emulated_gpu", [](auto balls) { return make_device_engine(std::move(balls)); }, 150, 1e5},
      {"emulated_gpu_tuples", tuples, 30, 1e6}};
}
#else
inline std::vector<EngineFactory> engines() {
  return host_engines();
}
#endif

// What a suite of every engine derives from: skipped where there is no such engine.
class EngineSuite : public ::testing::TestWithParam<EngineFactory> {
 protected:
  void SetUp() override {
    if (!GetParam().why_not.empty()) GTEST_SKIP() << GetParam().why_not;
  }
};

// What GoogleTest appends to the names of parametrised tests.
inline std::string engine_name(const ::testing::TestParamInfo<EngineFactory>& info) {
  return info.param.name;
}

}  // namespace alphascope::testing
