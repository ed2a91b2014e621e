// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the memory that the window leaves behind when the same actions repeat. It is a separate
// program, because llvmpipe reads its number of threads once, before the first context. With
// threads, llvmpipe keeps the resources of up to 64 frames until it reuses their slots. Counts heap
// in use, not resident memory, which depends on places in the heap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <vector>

#include "app/session/system_memory.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/freed_memory.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;
using testing::crambin;
using testing::ViewerTest;

double megabytes_in_use() {
  return static_cast<double>(allocated_bytes()) / 1e6;
}

bool in_use_is_known() {
  const std::uint64_t before = allocated_bytes();
  const std::vector<char> some(10'000'000, 'x');
  return allocated_bytes() >= before + some.size();
}

template <class Base>
class Measured : public Base {
 protected:
  using Base::Base;
  static void SetUpTestSuite() { setenv("LP_NUM_THREADS", "0", 1); }
  void SetUp() override {
    if (!in_use_is_known()) GTEST_SKIP() << "a sanitizer's allocator does not tell what is in use";
  }
};

class WindowMemoryTest : public Measured<ViewerTest> {
 protected:
  WindowMemoryTest() : Measured(false) {}

  // The actions in tests/ui/memory_round.txt.
  std::string round() const {
    std::ifstream file(fs::path(ALPHASCOPE_SOURCE_DIR) / "tests/ui/memory_round.txt");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find("MOLECULE"), std::string::npos);
    for (const char* molecule : {"CRAMBIN", "MOLECULE"}) {
      text = std::regex_replace(text, std::regex(molecule), crambin().string());
    }
    return std::regex_replace(text, std::regex("FOLDER"), folder_.string());
  }

  double after_a_round() {
    run(round());
    return megabytes_in_use();
  }
};

class SceneMemoryTest : public Measured<::testing::Test> {
 protected:
  SceneMemoryTest() {
    const auto balls = testing::rod();
    const auto geometry = std::make_shared<const BallGeometry>(*balls);
    const auto colours = testing::two_colours(balls->size());
    scene_.set_balls(geometry, colours);
    scene_.set_mesh(make_mesh_data(std::make_shared<const ComplexMesh>(
        build_mesh(*geometry, colours, testing::complex_of(balls, 2), {}))));
  }

  // Draws twice, because the driver keeps resources of the last picture until the next one.
  double after_pictures(RenderQuality quality) {
    for (int i = 0; i < 2; ++i) scene_.render(600, 400, quality);
    return megabytes_in_use();
  }

  EglContext context_;
  Scene scene_;
};

TEST(MemoryTest, FreedMemoryIsGivenBack) {
  if (!in_use_is_known()) GTEST_SKIP() << "a sanitizer's allocator keeps what is freed";
  constexpr std::size_t kPieces = 1000, kBytes = 64 << 10;
  std::vector<std::vector<char>> pieces(kPieces);
  for (auto& piece : pieces) piece.assign(kBytes, 'x');
  for (std::size_t i = 0; i < kPieces; ++i) {
    if (i % 16 != 0) std::vector<char>().swap(pieces[i]);
  }
  const std::uint64_t before = resident_bytes();
  return_freed_memory();
  EXPECT_LT(resident_bytes() + kPieces * kBytes / 2, before);
}

// A leak grows in every round, so one round without growth is enough. The first round fills caches:
// shaders, glyphs, engines of the last settings. In later rounds a driver may keep a texture, or a
// picture that is being saved may still hold memory.
TEST_F(WindowMemoryTest, RoundsLeaveNothingBehind) {
  constexpr double kMostMegabytes = 0.1;
  constexpr int kMostRounds = 6;
  run("size 900 600\n");
  std::string all;
  double before = after_a_round(), least = HUGE_VAL;
  for (int n = 1; n < kMostRounds && least >= kMostMegabytes; ++n) {
    const double now = after_a_round();
    least = std::min(least, now - before);
    all += std::to_string(before) + " -> " + std::to_string(now) + " MB; ";
    before = now;
  }
  EXPECT_LT(least, kMostMegabytes) << all;
}

TEST_F(SceneMemoryTest, APictureForAFileLeavesNoBuffersBehind) {
  scene_.grab(64, 48, false);  // compiles shaders
  const double before = after_pictures(RenderQuality::draft);
  scene_.grab(1000, 750, false);
  EXPECT_LT(after_pictures(RenderQuality::draft), before + 5);
}

TEST_F(SceneMemoryTest, WhatIsSwitchedOffLeavesNoBuffersBehind) {
  const auto with = [this](bool occlusion, double opacity) {
    SceneStyle style;
    style.ambient_occlusion = occlusion;
    style.complex_opacity = opacity;
    scene_.set_style(style);
    return after_pictures(RenderQuality::fine);
  };
  with(true, 0.5);  // compiles shaders
  const double plain = with(false, 1);
  EXPECT_GT(with(true, 1), plain + 0.8);
  EXPECT_LT(with(false, 1), plain + 0.3);
  EXPECT_GT(with(false, 0.5), plain + 0.8);
  EXPECT_LT(with(false, 1), plain + 0.3);
}

}  // namespace
}  // namespace alphascope
