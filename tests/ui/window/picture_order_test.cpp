// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the picture depends only on molecule, answer and controls. These may change in any
// order, and the jobs that follow may finish, be taken or be replaced in any order.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/viewer/scene/scene_controller.hpp"
#include "core/engine/engine.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/texture_pixels.hpp"
#include "ui/colour_legend.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

// Enough free memory for all drawings, but so little that each of them checks it first.
constexpr std::uint64_t kFreeBytes = 160'000'000;

OpenedMolecule two_chains() {
  OpenOptions options;
  options.balls.without_chains = {"C", "D"};
  return open_molecule(
      std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz", options,
      RunContext{});
}

class PictureOrder : public ::testing::Test {
 protected:
  PictureOrder() {
    viewport_.width = 240;
    viewport_.height = 160;
    display_.samples = 1;
    display_.ambient_occlusion = false;
    complex_ = make_cpu_engine(file_.prepared->balls)->compute({0, false}, {});
  }
  ~PictureOrder() override { held_ = false; }

  // The same balls again, as another molecule.
  void new_molecule() {
    auto opened = std::make_shared<OpenedMolecule>(file_);
    opened->molecule = std::make_shared<const Molecule>(*file_.molecule);
    opened->prepared = std::make_shared<const PreparedBalls>(*file_.prepared);
    auto answer = std::make_shared<Answer>();
    answer->balls = opened->prepared->balls;
    answer->complex = complex_;
    answer->molecule = opened->molecule;
    answer->prepared = opened->prepared;
    opened_ = std::move(opened);
    answer_ = std::move(answer);
  }
  void colour_by(ColourBy by) {
    display_.ball_paint.by = display_.complex_paint.by = by;
    scene_.set_display(display_, Theme::dark);
  }
  void show_boundary(bool shown) {
    display_.boundary = shown;
    scene_.set_display(display_, Theme::dark);
    while (!waits_ && scene_.busy()) pause();
  }

  static void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }
  // m: the molecule comes. a: the answer comes. c: the controls set other colours. After each of
  // these, its job begins unless another one is running, and is held before its end. f: all running
  // and waiting jobs finish. p: finished results are taken.
  void play(const std::string& order) {
    for (const char step : order) {
      switch (step) {
        case 'm':
          scene_.set_molecule(opened_);
          break;
        case 'a':
          scene_.set_answer(answer_);
          break;
        case 'c':
          colour_by(ColourBy::element);
          break;
        case 'f':
          held_ = false;
          while (scene_.busy()) pause();
          held_ = true;
          break;
        default:
          scene_.poll();
      }
      while (!waits_ && scene_.busy()) pause();
    }
  }
  Image picture() {
    held_ = false;
    for (int quiet = 0; quiet < 4; quiet = scene_.busy() ? 0 : quiet + 1) {  // may ask again
      pause();
      scene_.poll();
    }
    return drawn_now();
  }
  Image drawn_now() {
    scene_.describe(viewport_);
    scene_.render(viewport_, false, true);
    return testing::upright(testing::texture_pixels(static_cast<unsigned>(viewport_.texture)));
  }

  EglContext context_;
  OpenedMolecule file_ = two_chains();
  AlphaComplex complex_;
  std::shared_ptr<const OpenedMolecule> opened_;
  std::shared_ptr<const Answer> answer_;
  DisplaySettings display_;
  ViewportInfo viewport_;
  // Drawings first ask for the free memory. They are held there, except for as many as may pass.
  std::atomic<bool> held_ = false, waits_ = false;
  std::atomic<int> passes_ = 0;
  std::atomic<std::uint64_t> free_bytes_ = kFreeBytes;
  SceneController scene_{{}, [this]() -> std::optional<std::uint64_t> {
                           waits_ = held_.load();
                           while (held_ && passes_ == 0) pause();
                           waits_ = false;
                           if (held_) --passes_;
                           return free_bytes_.load();
                         }};
};

TEST_F(PictureOrder, MakesNoDifference) {
  colour_by(ColourBy::chain);
  new_molecule();
  play("mfpafp");
  const Image by_chain = picture();
  colour_by(ColourBy::element);
  new_molecule();
  play("mfpafp");
  const Image by_element = picture();
  ASSERT_EQ(viewport_.not_drawn, "");
  ASSERT_GT(testing::differing_pixels(by_chain, by_element), 1000);
  const std::vector<ColourLegend> legends = viewport_.legends;
  for (const char* order : {"mac", "mca", "cma"}) {
    for (const std::string first : {"", "f", "p", "fp", "pf"}) {
      for (const std::string second : {"", "f", "p", "fp", "pf"}) {
        held_ = false;
        colour_by(ColourBy::chain);
        picture();
        new_molecule();
        const std::string played = order[0] + first + order[1] + second + order[2];
        held_ = true;
        play(played);
        EXPECT_EQ(testing::differing_pixels(picture(), by_element), 0) << played;
        EXPECT_EQ(viewport_.legends.size(), legends.size()) << played;
        EXPECT_EQ(viewport_.not_drawn, "") << played;
      }
    }
  }
}

// Memory is short for a moment while another drawing of the same balls is running. Making room
// removes the balls on which that drawing relied.
TEST_F(PictureOrder, BallsThatMadeRoomComeBack) {
  colour_by(ColourBy::element);
  new_molecule();
  play("mfpafp");
  const Image before = picture();
  held_ = true;
  free_bytes_ = 1000;
  show_boundary(true);
  play("f");
  free_bytes_ = kFreeBytes;
  show_boundary(false);
  ASSERT_TRUE(waits_);
  play("p");  // makes room, and asks for another drawing after the running one
  ASSERT_EQ(scene_.drawn().molecule, nullptr);
  passes_ = 1;
  while (passes_ > 0) pause();
  while (!waits_) pause();
  scene_.poll();
  ASSERT_NE(scene_.drawn().molecule, nullptr);
  EXPECT_EQ(testing::differing_pixels(drawn_now(), before), 0);
  EXPECT_EQ(testing::differing_pixels(picture(), before), 0);
}

}  // namespace
}  // namespace alphascope
