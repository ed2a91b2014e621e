// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the loading of the library with the GPU engines: where it is looked for, that it may be
// absent, damaged or of another build, and that engines and exceptions cross its boundary.
#include "app/session/gpu_engines.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "core/complex/compare.hpp"
#include "core/run/library_build.hpp"
#include "core/triangulation/triangulation_report.hpp"
#include "tests/support/expect_same.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVariable = "ALPHASCOPE_GPU_LIBRARY";

// The environment variable has this value, or none, as long as this object lives.
class Named {
 public:
  explicit Named(const char* value) {
    if (const char* const before = std::getenv(kVariable)) before_ = before;
    set(value);
  }
  ~Named() { set(before_ ? before_->c_str() : nullptr); }

 private:
  static void set(const char* value) {
    if (value != nullptr) {
      ::setenv(kVariable, value, 1);
    } else {
      ::unsetenv(kVariable);
    }
  }
  std::optional<std::string> before_;
};

std::shared_ptr<const BallSet> some_balls() {
  testing::Random random(3);
  return std::make_shared<const BallSet>(testing::random_balls(random, 60, 4000, 500, 900));
}

// The reason why CGAL made the triangulation of many balls; empty if there is no GPU.
std::string why_not_triangulated(const GpuEngines& engines) {
  testing::Random random(4);
  const BallSet many = testing::random_balls(random, 2500, 4000, 100, 200);
  return engines.triangulations()->make(many, 1, {}).report->why_not;
}

// The library at `place` gives no engine, and its reason has all of `parts`.
void expect_unusable(const fs::path& place, const std::vector<std::string>& parts) {
  const GpuEngines engines({place});
  EXPECT_FALSE(engines.device().usable);
  const std::string& reason = engines.device().why_not;
  for (const std::string& part : parts) EXPECT_NE(reason.find(part), std::string::npos) << reason;
  EXPECT_TRUE(reason.ends_with(". The CPU engine gives the same results.")) << reason;
  std::string why_not;
  EXPECT_EQ(engines.make_engine(some_balls(), {}, why_not), nullptr);
  EXPECT_EQ(why_not, reason);
  why_not.clear();
  EXPECT_EQ(engines.make_tuple_engine(some_balls(), {}, why_not), nullptr);
  EXPECT_EQ(why_not, reason);
  EXPECT_EQ(why_not_triangulated(engines), "") << "without a GPU there is no reason to tell";
  EXPECT_FALSE(engines.is_memory_unused());
  engines.free_unused_memory();
}

TEST(GpuEngines, SayThatThereIsNoLibrary) {
  const Named none(nullptr);
  expect_unusable("/nonexistent/alphascope-gpu.so",
                  {"No GPU library was found", "alphascope-cuda", "nvcc"});
  const Named wrong("/nonexistent/gpu.so");
  expect_unusable("/nonexistent/gpu.so",
                  {"ALPHASCOPE_GPU_LIBRARY names /nonexistent/gpu.so", "Correct or unset it"});
}

TEST(GpuEngines, SayThatTheLibraryIsDamaged) {
  const fs::path file = fs::path(::testing::TempDir()) / "damaged-gpu.so";
  std::ofstream(file) << "no library";
  expect_unusable(file,
                  {"The GPU library " + file.string() + " cannot be loaded (", "Reinstall it"});
  fs::remove(file);
}

// A library of which the end is missing would end the program by a bus error.
TEST(GpuEngines, SayThatTheLibraryIsCutOff) {
  const fs::path file = fs::path(::testing::TempDir()) / "cut-off-gpu.so";
  const std::uintmax_t size = fs::file_size(ALPHASCOPE_GOOD_GPU_LIBRARY);
  for (const std::uintmax_t left : {size - 1, size / 2, size / 4, size / 16, std::uintmax_t{64}}) {
    fs::copy_file(ALPHASCOPE_GOOD_GPU_LIBRARY, file, fs::copy_options::overwrite_existing);
    fs::resize_file(file, left);
    expect_unusable(file,
                    {"The GPU library " + file.string() + " is not complete", "Reinstall it"});
  }
  fs::remove(file);
}

TEST(GpuEngines, RefuseAForeignLibrary) {
  expect_unusable(ALPHASCOPE_FOREIGN_LIBRARY, {"is not a GPU library of Alphascope"});
}

TEST(GpuEngines, RefuseTheLibraryOfAnotherBuild) {
  expect_unusable(ALPHASCOPE_OLD_GPU_LIBRARY,
                  {"another build of Alphascope (0.0.1 0123456789abcdef GCC 4.9; this is ",
                   library_build(), "Install the programs and the library from the same build"});
}

TEST(GpuEngines, LoadNothingFromTheCurrentFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(fs::path(ALPHASCOPE_GOOD_GPU_LIBRARY).parent_path());
  expect_unusable(fs::path(ALPHASCOPE_GOOD_GPU_LIBRARY).filename(), {"is not absolute"});
  fs::current_path(before);
}

// Limits and exceptions of an executor cross the library's boundary, and the CPU then answers.
TEST(GpuEngines, LetTheCpuAnswerWhereTheLibraryDoesNot) {
  const GpuEngines engines({"/nonexistent/gpu.so", ALPHASCOPE_GOOD_GPU_LIBRARY});
  ASSERT_TRUE(engines.device().usable) << engines.device().why_not;
  EXPECT_EQ(engines.device().name, "Fake GPU");
  const auto balls = some_balls();
  std::string why_not;
  const auto engine = engines.make_engine(balls, {}, why_not);
  ASSERT_TRUE(engine) << why_not;
  const auto cpu = make_cpu_engine(balls);
  const auto expect_route = [&](double alpha, const std::string& route) {
    const AlphaComplex found = engine->compute({alpha}, {});
    testing::expect_same(found, cpu->compute({alpha}, {}));
    EXPECT_NE(found.engine.route.find(route), std::string::npos) << found.engine.route;
  };
  expect_route(1, "(on the CPU: beyond the GPU kernels' limits)");
  expect_route(-0.1, "(on the CPU: the fake GPU is lost)");
  EXPECT_EQ(engines.make_tuple_engine(balls, {}, why_not), nullptr);
  EXPECT_EQ(why_not, "The fake GPU has no tuples.");
  EXPECT_EQ(why_not_triangulated(engines), "The fake GPU makes no triangulations");
  EXPECT_TRUE(engines.is_memory_unused());
  engines.free_unused_memory();
  EXPECT_FALSE(engines.is_memory_unused());
}

TEST(GpuLibraryPlaces, AreThoseOfTheInstallation) {
  const Named none(nullptr);
  const fs::path file = fs::path(ALPHASCOPE_LIBRARY_FOLDER) / "alphascope-gpu.so";
  const auto expect_place = [&](const std::string& program) {
    const std::vector<fs::path> places = gpu_library_places(program);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_EQ(places[0], "/opt/some" / file);
  };
  expect_place("/opt/some/" ALPHASCOPE_PROGRAM_FOLDER "/alphascope");
  expect_place("/opt/some/" ALPHASCOPE_DRAWING_PROGRAM_FOLDER "/alphascope-cli-draw");
  EXPECT_TRUE(gpu_library_places("/opt/some/elsewhere/alphascope").empty());
  EXPECT_TRUE(gpu_library_places("").empty());
}

TEST(GpuLibraryPlaces, AreReplacedByTheVariable) {
  const Named file("/opt/my gpu.so");
  EXPECT_EQ(gpu_library_places("/usr/" ALPHASCOPE_PROGRAM_FOLDER "/alphascope"),
            std::vector<fs::path>{"/opt/my gpu.so"});
  const Named nothing("");
  EXPECT_TRUE(gpu_library_places("/usr/" ALPHASCOPE_PROGRAM_FOLDER "/alphascope").empty());
  expect_unusable("/nonexistent/gpu.so", {"ALPHASCOPE_GPU_LIBRARY names"});
}

#ifdef ALPHASCOPE_REAL_GPU_LIBRARY
// Loads the real library. Without a device, the reason comes from the library itself.
TEST(GpuEngines, LoadTheRealLibrary) {
  const GpuEngines engines({ALPHASCOPE_REAL_GPU_LIBRARY});
  const GpuDevice& device = engines.device();
  const auto balls = some_balls();
  std::string why_not;
  const auto engine = engines.make_engine(balls, {}, why_not);
  EXPECT_EQ(engine != nullptr, device.usable);
  EXPECT_FALSE(engines.is_memory_unused());
  if (engine) {
    testing::expect_same(engine->compute({1}, {}), make_cpu_engine(balls)->compute({1}, {}));
    EXPECT_TRUE(engines.make_tuple_engine(balls, {}, why_not)) << why_not;
    EXPECT_EQ(why_not_triangulated(engines), "");
  } else {
    EXPECT_EQ(why_not, device.why_not);
    EXPECT_NE(why_not.find("NVIDIA"), std::string::npos) << why_not;
    EXPECT_EQ(why_not.find("GPU library"), std::string::npos) << why_not;
  }
}
#endif

}  // namespace
}  // namespace alphascope
