// SPDX-License-Identifier: GPL-3.0-or-later
// The whole window in process, without a display.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "app/viewer/options.hpp"
#include "app/viewer/script/script.hpp"
#include "app/viewer/viewer.hpp"
#include "tests/ui/scene/texture_pixels.hpp"
#include "ui/scene/picture/frame_grab.hpp"

namespace alphascope::testing {

namespace fs = std::filesystem;

inline fs::path crambin() {
  return fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/1crn.pdb";
}

class ViewerTest : public ::testing::Test {
 protected:
  // Panels are drawn for pictures only, or in every frame as for a user.
  explicit ViewerTest(bool draw_shots_only = true, const HostOptions& host = {1100, 700, 1, "test"})
      : folder_(fs::temp_directory_path() / ("alphascope_viewer_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    host_ = make_egl_host(host);
    ViewerOptions options;
    options.compare = false;
    options.draw_shots_only = draw_shots_only;
    // Most tests need no fine pictures; those that do choose another preset.
    options.preset = "fast";
    options.samples = 1;
    options.objects = DrawnObjects();
    viewer_ = std::make_unique<Viewer>(*host_, options);
  }
  ~ViewerTest() override {
    viewer_.reset();
    host_.reset();
    fs::remove_all(folder_);
  }

  std::string run(const std::string& text) {
    std::istringstream script(text);
    std::ostringstream out;
    run_script(*viewer_, script, "test", out);
    return out.str();
  }
  void open_crambin() { run("open " + crambin().string() + "\nwait-idle\n"); }

  void shot(const std::string& name) {
    run("move status.memory\nshot " + (folder_ / name).string() + "\n");
  }
  // The scene at its finest, without the window's overlays.
  Image picture() {
    run("wait-idle\n");
    shot("picture_taken.png");
    return texture_pixels(static_cast<unsigned>(viewer_->state().viewport.texture));
  }
  std::string bytes(const std::string& name) {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  // The engine's answer without any window.
  AlphaComplex expected(double alpha, double solvent = 0) {
    const auto& prepared = *viewer_->session().state().prepared;
    const auto balls = std::make_shared<const BallSet>(with_solvent(*prepared.balls, solvent));
    return make_cgal_engine(balls)->compute({alpha, false}, {});
  }

  fs::path folder_;
  std::unique_ptr<Host> host_;
  std::unique_ptr<Viewer> viewer_;
};

}  // namespace alphascope::testing
