// SPDX-License-Identifier: GPL-3.0-or-later
// Tests drawing with little memory: the plan, the command line's picture and the whole window.
#include "ui/scene/mesh/drawing_memory.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <atomic>
#include <thread>

#include "app/session/system_memory.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/support/png_chunks.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/scene/rod_picture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

constexpr std::uint64_t kMegabyte = 1000000;

MeshOptions everything() {
  MeshOptions mesh;
  mesh.boundary = mesh.triangles = mesh.edges = true;
  mesh.singular_only = false;
  mesh.shrink = 0.3;
  return mesh;
}

// The least free memory for a budget of `bytes`. The budget moves in steps of three bytes.
std::uint64_t free_for(std::uint64_t bytes) {
  std::uint64_t low = 0, high = std::uint64_t{1} << 50;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    drawing_budget(middle) < bytes ? low = middle + 1 : high = middle;
  }
  return low;
}

class DrawingPlans : public ::testing::Test {
 protected:
  std::shared_ptr<const BallSet> balls_ = testing::rod(40);
  AlphaComplex complex_ = testing::complex_of(balls_, 2);
  DrawingTask task_{balls_->size(), &complex_, nullptr, everything()};

  DrawingPlan plan_for(std::uint64_t budget) const { return plan_drawing(task_, free_for(budget)); }
  // Most important first, as in the header.
  static std::array<int, 6> layers(const DrawingPlan& p) {
    const bool inside = p.mesh.shrink > 0;
    return {p.balls,         p.mesh.tetrahedra, p.mesh.tetrahedra && inside,
            p.mesh.boundary, p.mesh.triangles,  p.mesh.edges};
  }
};

TEST_F(DrawingPlans, ExpectNoMorePointsThanAreMade) {
  const BallGeometry geometry(*balls_);
  const auto colours = testing::two_colours(balls_->size());
  for (const bool singular_only : {false, true}) {
    for (const double shrink : {0.0, 0.3}) {
      MeshOptions options = everything();
      options.singular_only = singular_only;
      options.shrink = shrink;
      const ComplexMesh mesh = build_mesh(geometry, colours, complex_, options);
      const std::uint64_t whole = mesh.tetrahedra.size();
      const std::uint64_t faces = mesh.faces_drawn() - 4 * whole;
      EXPECT_EQ(drawing_bytes({0, &complex_, nullptr, options}),
                48 * (faces + mesh.edges.size()) + 56 * whole);
    }
  }
  // Without triangles the outer faces of tetrahedra are unknown, so the greatest possible number
  // counts.
  const AlphaComplex bare = testing::complex_of(balls_, 2, true);
  MeshOptions only_tetrahedra;
  EXPECT_GE(drawing_bytes({0, &bare, nullptr, only_tetrahedra}), 48 * 4 * bare.tetrahedra.size());
}

TEST_F(DrawingPlans, AreCompleteWhenEverythingFitsOrNobodyKnows) {
  const std::uint64_t all = drawing_bytes(task_);
  for (const auto& free : {std::optional<std::uint64_t>(), std::optional(free_for(all))}) {
    const DrawingPlan plan = plan_drawing(task_, free);
    EXPECT_TRUE(plan.complete());
    EXPECT_EQ(plan.mesh, task_.mesh);
    EXPECT_EQ(not_drawn_text(plan), "");
  }
  EXPECT_FALSE(plan_for(all - 4).complete());
}

TEST_F(DrawingPlans, LeaveOutTheLeastImportantFirstAndNeverExceedTheBudget) {
  const std::uint64_t all = drawing_bytes(task_);
  EXPECT_EQ(plan_for(all - 4).left_out, std::vector<std::string>{"edges"});
  std::array<int, 6> before = layers(plan_drawing(task_, 0));
  EXPECT_EQ(before, (std::array<int, 6>{}));
  int steps = 0;
  for (std::uint64_t budget = 0; budget <= all; budget += all / 500) {
    const DrawingPlan plan = plan_for(budget);
    const std::array<int, 6> now = layers(plan);
    EXPECT_GE(now, before) << "less with " << budget << " bytes";  // lexicographically
    steps += now != before;
    before = now;
    if (plan.balls) {
      EXPECT_LE(drawing_bytes({task_.balls, &complex_, nullptr, plan.mesh}), budget);
    }
    EXPECT_EQ(not_drawn_text(plan).empty(), plan.complete());
  }
  EXPECT_GE(steps, 5);
}

TEST_F(DrawingPlans, FallBackToTheOutsideOfTheTetrahedra) {
  MeshOptions outside;  // touching and opaque
  const std::uint64_t least = drawing_bytes({task_.balls, &complex_, nullptr, outside});
  task_.mesh = {};
  task_.mesh.translucent = true;
  const DrawingPlan plan = plan_for(least);
  EXPECT_EQ(plan.mesh, outside);
  EXPECT_EQ(not_drawn_text(plan).find("Not drawn for lack of memory: the inside of the tetrahedra"),
            0u);
  EXPECT_EQ(plan_for(least - 4).left_out, std::vector<std::string>{"tetrahedra"});
}

TEST_F(DrawingPlans, CountDifferencesFromCgal) {
  Comparison c;
  c.tetrahedra.missing.resize(1000);
  c.edges.extra.resize(1000);
  task_.differences = &c;
  task_.complex = nullptr;
  task_.mesh = {};
  const std::uint64_t all = drawing_bytes(task_);
  EXPECT_EQ(all - drawing_bytes({task_.balls, nullptr, nullptr, {}}), 1000u * (12 * 150 + 2 * 250));
  EXPECT_TRUE(plan_for(all).differences);
  EXPECT_FALSE(plan_for(all - 4).differences);
}

TEST(AvailableBytes, KnowsControlGroups) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("alphascope_groups_" + std::to_string(getpid()));
  const auto write = [&](const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
  };
  const SystemFiles files{folder / "meminfo", folder / "groups", folder};
  EXPECT_FALSE(available_bytes(files));
  write("meminfo", "MemTotal: 8000 kB\nMemFree:  100 kB\nMemAvailable:   4000 kB\nCached: 1 kB\n");
  EXPECT_EQ(available_bytes(files), 4000u * 1024);
  write("groups", "4:memory:/old\n0::/user/app\n");
  write("user/app/memory.max", "max\n");
  write("user/app/memory.current", "5000\n");
  EXPECT_EQ(available_bytes(files), 4000u * 1024);
  write("user/memory.max", "10000\n");  // the parent group
  write("user/memory.current", "7000\n");
  write("user/memory.stat", "anon 6000\ninactive_file 500\n");
  EXPECT_EQ(available_bytes(files), 3500u);
  std::filesystem::remove_all(folder);
}

TEST(ScreenshotMemory, DrawsWhatFitsAndSaysSo) {
  const auto balls = testing::rod();
  const AlphaComplex complex = testing::complex_of(balls, 0);
  const auto path = std::filesystem::temp_directory_path() / "alphascope_memory_test.png";
  std::filesystem::remove(path);
  PictureSettings settings = testing::plain_settings(balls->size(), 16, 16);
  std::uint64_t free_bytes = 0;
  settings.free_memory = [&free_bytes] { return free_bytes; };
  const auto render = [&] { return testing::draw_carbons(balls, complex, settings, path); };
  EXPECT_THROW(render(), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(path));
  free_bytes =
      picture_bytes(16, 16) + free_for(drawing_bytes({balls->size(), &complex, nullptr, {}}) - 4);
  const std::string not_drawn = render();
  EXPECT_EQ(not_drawn.find("Not drawn for lack of memory: tetrahedra. "), 0u) << not_drawn;
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(testing::texts_of(bytes)["Warning"], not_drawn);
  free_bytes = 2000 * kMegabyte;
  EXPECT_EQ(render(), "");
  std::filesystem::remove(path);
}

TEST(ScreenshotMemory, IsRefusedByTheCommandLineWithAReason) {
  const auto folder = std::filesystem::temp_directory_path();
  const auto picture = folder / "alphascope_refused.png", said = folder / "alphascope_refused.txt";
  std::filesystem::remove(picture);
  const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot " +
                              testing::crambin().string() + " --alpha 0 --drawing-memory 100 -o " +
                              picture.string() + " 2> " + said.string() + " > /dev/null";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status)) << "it crashed";
  EXPECT_EQ(WEXITSTATUS(status), 4);
  std::ifstream file(said);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(text.find("too little memory for a picture of 1280 x 800"), std::string::npos) << text;
  EXPECT_FALSE(std::filesystem::exists(picture));
  std::filesystem::remove(said);
}

class WindowMemory : public testing::ViewerTest {
 protected:
  void open_with(std::uint64_t megabytes) {
    viewer_.reset();
    ViewerOptions options;
    options.objects = DrawnObjects();
    options.compare = false;
    options.draw_shots_only = true;
    options.drawing_memory_mb = megabytes;
    viewer_ = std::make_unique<Viewer>(*host_, options);
    open_crambin();
  }
  const std::string& not_drawn() { return viewer_->state().viewport.not_drawn; }
};

TEST_F(WindowMemory, ShowsTheNumbersAndTheReasonWhenNothingCanBeDrawn) {
  open_with(100);
  EXPECT_EQ(not_drawn().find(kNothingDrawn), 0u) << not_drawn();
  // Not even an empty picture fits, so a smaller molecule would not help.
  EXPECT_NE(not_drawn().find("Close other programs."), std::string::npos) << not_drawn();
  EXPECT_EQ(not_drawn().find("chains"), std::string::npos) << not_drawn();
  EXPECT_EQ(hash_text(viewer_->state().result->complex.hash), hash_text(expected(0).hash));
  EXPECT_TRUE(viewer_->widgets().contains("view.not_drawn"));
  run("click alpha.preset.1.4\nwait-idle\nmove view\nwheel 2\n");
  EXPECT_EQ(hash_text(viewer_->state().result->complex.hash), hash_text(expected(1.4).hash));
  viewer_->calls().jobs.save_picture(
      ScreenshotRequest{folder_ / "none.png", {.width = 64, .height = 64}});
  run("frames 2\n");
  EXPECT_EQ(viewer_->state().error.find(kNothingDrawn), 0u) << viewer_->state().error;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.png"));
}

TEST_F(WindowMemory, DrawsBallsWhenTheComplexDoesNotFit) {
  open_with(135);
  EXPECT_EQ(not_drawn(), "");
  run("open " ALPHASCOPE_SOURCE_DIR
      "/resources/molecules/4hhb.pdb.gz\nwait-idle\n"
      "view.shrink 0.3\nclick alpha.preset.10\nwait-idle\nframes 3\n");
  EXPECT_EQ(not_drawn().find("Not drawn for lack of memory: "), 0u) << not_drawn();
  ASSERT_NE(viewer_->state().viewport.texture, 0u);
  EXPECT_GT(viewer_->state().viewport.angstrom_per_pixel, 0);
  const std::string texts = testing::texts_of((shot("part.png"), bytes("part.png")))["Warning"];
  EXPECT_EQ(texts, not_drawn());
  run("click display.tetrahedra\nwait-idle\nframes 3\n");
  EXPECT_EQ(not_drawn(), "");
  EXPECT_FALSE(viewer_->widgets().contains("view.not_drawn"));
}

// The scene alone, with free memory that changes.
class SceneMemory : public ::testing::Test {
 protected:
  void finish() {
    // Taking a result may start the next job.
    for (int quiet = 0; quiet < 4; quiet = scene_.busy() ? 0 : quiet + 1) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      scene_.poll();
      scene_.describe(viewport_);
      scene_.render(viewport_, true, false);
    }
  }
  void open() {
    viewport_.width = 300;
    viewport_.height = 200;
    scene_.set_molecule(std::make_shared<const OpenedMolecule>(
        open_molecule(testing::crambin(), {}, RunContext{})));
    finish();
  }

  EglContext context_;
  std::function<std::optional<std::uint64_t>()> free_ = [] { return std::nullopt; };
  ViewportInfo viewport_;
  SceneController scene_{{}, [this] { return free_(); }};
};

TEST_F(SceneMemory, SaysWhenAWorkerRunsOutOfIt) {
  free_ = []() -> std::optional<std::uint64_t> { throw std::bad_alloc(); };
  open();
  EXPECT_EQ(viewport_.not_drawn.find(kNothingDrawn), 0u) << viewport_.not_drawn;
  free_ = [] { return std::nullopt; };
  open();
  EXPECT_EQ(viewport_.not_drawn, "");
  EXPECT_EQ(scene_.drawn().molecule->geometry->centres.size(), 327u);
}

TEST_F(SceneMemory, IsNotAskedAgainWhileAPictureIsMade) {
  std::atomic<int> asked = 0;
  std::atomic<bool> held = true;
  free_ = [&]() -> std::optional<std::uint64_t> {
    ++asked;
    while (held) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::nullopt;
  };
  viewport_.width = viewport_.height = 100;
  scene_.set_molecule(
      std::make_shared<const OpenedMolecule>(open_molecule(testing::crambin(), {}, RunContext{})));
  while (asked == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  for (int frame = 0; frame < 5; ++frame) scene_.show_without_answer();
  held = false;
  finish();
  EXPECT_EQ(asked, 1);
  EXPECT_NE(scene_.drawn().molecule, nullptr);
}

// Other balls of the same molecule may not fit beside the old ones.
TEST_F(SceneMemory, MakesRoomBeforeItLeavesAnythingOut) {
  open();
  scene_.pointer({PointerEvent::Kind::wheel, 100, 100, 0, 3});
  finish();
  const double zoomed = viewport_.angstrom_per_pixel;
  std::vector<std::uint64_t> answers{2000 * kMegabyte, 0};  // then with an empty picture
  free_ = [&]() -> std::optional<std::uint64_t> {
    const std::uint64_t answer = answers.back();
    answers.pop_back();
    return answer;
  };
  auto opened = std::make_shared<OpenedMolecule>(*scene_.drawn().molecule->opened);
  opened->prepared = std::make_shared<const PreparedBalls>(*opened->prepared);
  scene_.set_molecule(std::move(opened));
  scene_.show_without_answer();  // as after a cancelled computation
  finish();
  EXPECT_TRUE(answers.empty());
  EXPECT_EQ(viewport_.not_drawn, "");
  ASSERT_NE(scene_.drawn().molecule, nullptr);
  EXPECT_EQ(scene_.drawn().molecule->geometry->centres.size(), 327u);
  EXPECT_DOUBLE_EQ(viewport_.angstrom_per_pixel, zoomed);
}

// Waits before it answers, until released.
class HeldEngine : public Engine {
 public:
  HeldEngine(std::shared_ptr<const BallSet> balls, const std::atomic<bool>& held)
      : engine_(make_cpu_engine(std::move(balls))), held_(held) {}
  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    while (held_) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return engine_->compute(request, known, context);
  }

 private:
  std::unique_ptr<Engine> engine_;
  const std::atomic<bool>& held_;
};

TEST_F(WindowMemory, TellsAPictureThatIsOutdated) {
  viewer_.reset();
  std::atomic<bool> held = false;
  Session::Services services = Session::program_services();
  services.make_engine = [&held](EngineChoice, std::shared_ptr<const BallSet> balls,
                                 const EngineSettings&) {
    return MadeEngine{std::make_unique<HeldEngine>(std::move(balls), held), ""};
  };
  ViewerOptions options;
  options.objects = DrawnObjects();
  options.compare = false;
  options.draw_shots_only = true;
  viewer_ = std::make_unique<Viewer>(*host_, options, services);
  open_crambin();
  EXPECT_FALSE(viewer_->state().viewport.outdated);
  held = true;
  viewer_->state().settings.open.balls.selection = "residue 1-20";
  const auto start = std::chrono::steady_clock::now();
  while (!viewer_->state().viewport.outdated &&
         std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) {
    run("frames 1\n");
  }
  run("frames 1\n");
  EXPECT_TRUE(viewer_->widgets().contains("view.outdated"));
  held = false;
  run("wait-idle\n");
  EXPECT_LT(viewer_->state().molecule.balls, 327u);
  EXPECT_FALSE(viewer_->state().viewport.outdated);
  EXPECT_FALSE(viewer_->widgets().contains("view.outdated"));
  viewer_.reset();  // its engines use `held`
}

TEST(BeyondOpenGl, IsToldWithARemedy) {
  ComplexMesh mesh;
  EXPECT_EQ(beyond_opengl_text(mesh, 5, 3), "") << "balls are not indexed where there are no faces";
  mesh.triangles.faces.resize(4);
  EXPECT_EQ(beyond_opengl_text(mesh, 4, 4), "");
  const std::string text = beyond_opengl_text(mesh, 4, 3);
  EXPECT_NE(text.find("at most 3 faces"), std::string::npos);
  EXPECT_NE(text.find("this complex has 4."), std::string::npos);
  EXPECT_NE(beyond_opengl_text(mesh, 5, 4), "");
}

}  // namespace
}  // namespace alphascope
