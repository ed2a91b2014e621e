// SPDX-License-Identifier: GPL-3.0-or-later
// Tests lessons in the whole window: every chapter from its first to its last step, and the file
// that was open before.
#include <algorithm>
#include <chrono>
#include <thread>

#include "app/viewer/lessons/lesson_files.hpp"
#include "app/viewer/resources.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/baseline.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/panel_list.hpp"

namespace alphascope::testing {
namespace {

std::vector<fs::path> chapters() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(lessons_folder())) {
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class LessonsTest : public ViewerTest {
 protected:
  const LessonState& memory() { return viewer_->state().lessons; }
  const ViewState& state() { return viewer_->state(); }
  fs::path write(const std::string& text) {
    const fs::path file = folder_ / "lesson.md";
    std::ofstream(file) << text;
    fs::copy_file(lessons_folder() / "two_balls.xyzr", folder_ / "two_balls.xyzr",
                  fs::copy_options::overwrite_existing);
    return file;
  }
  void open_lesson(const std::string& name) { run("lesson.open " + name + "\nwait-idle\n"); }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
};

// A lesson whose steps set alpha and the display.
constexpr const char* kShort = R"(# Short
For tests.
```
molecule two_balls.xyzr
view.from z
```
## One
There are {n edges} at {alpha}.
## Two
Text.
```
alpha.set -2
view.balls off
```
## Question
How many?
### Answer
{n edges}.
```
alpha.set 1
```
)";

TEST_F(LessonsTest, AreListedAndOpened) {
  run("lesson.open\nwait-idle\nframes 3\n");
  ASSERT_TRUE(memory().shelf);
  ASSERT_EQ(memory().shelf->size(), chapters().size());
  for (const ListedLesson& one : *memory().shelf) EXPECT_EQ(one.problem, "");
  run("click lessons.union_of_balls\nwait-idle\n");
  ASSERT_TRUE(memory().open);
  EXPECT_EQ(memory().open->title, "A molecule as a union of balls");
  EXPECT_TRUE(memory().ready);
  EXPECT_TRUE(has("lesson.text"));
}

TEST_F(LessonsTest, StepsSetTheWindowAndGoBack) {
  open_lesson(write(kShort).string());
  EXPECT_EQ(state().error, "");
  EXPECT_EQ(state().molecule.name, "two_balls.xyzr");
  EXPECT_TRUE(state().settings.display.balls);
  run("key pagedown\nwait-idle\n");
  EXPECT_EQ(memory().step, 1u);
  EXPECT_EQ(state().result->request.alpha_angstrom2, -2);
  EXPECT_FALSE(state().settings.display.balls);
  EXPECT_EQ(state().undo_text, "") << "what a step sets is no change of the user's";
  run("alpha.set 5\nwait-idle\nkey pageup\nwait-idle\n");
  EXPECT_EQ(memory().step, 0u);
  EXPECT_EQ(state().result->request.alpha_angstrom2, 0);
  EXPECT_TRUE(state().settings.display.balls);
  run("lesson.next\nwait-idle\nlesson.next\nwait-idle\nframes 2\n");
  EXPECT_EQ(memory().step, 2u);
  EXPECT_TRUE(has("lesson.reveal"));
  EXPECT_FALSE(has("lesson.answer"));
  run("key pagedown\nwait-idle\nframes 2\n");
  EXPECT_TRUE(has("lesson.answer"));
  EXPECT_EQ(state().result->request.alpha_angstrom2, 1);
  EXPECT_TRUE(has("lesson.list"));
}

TEST_F(LessonsTest, WhatAStepSetsIsForThatStepAndWhatTheUserSetsStays) {
  std::string text = kShort;
  text.insert(text.find("alpha.set -2"), "engine.set tuples-cpu\n");
  open_lesson(write(text).string());
  const EngineChoice before = state().settings.request.engine;
  ASSERT_NE(before, EngineChoice::tuples_cpu);
  run("key pagedown\nwait-idle\n");
  EXPECT_EQ(state().settings.request.engine, EngineChoice::tuples_cpu);
  run("key pagedown\nwait-idle\n");
  EXPECT_EQ(state().settings.request.engine, before);
  run("engine.set cgal\nwait-idle\nkey pageup\nwait-idle\n");
  EXPECT_EQ(state().settings.request.engine, EngineChoice::tuples_cpu);
  run("key pageup\nwait-idle\n");
  EXPECT_EQ(state().settings.request.engine, EngineChoice::cgal)
      << "the user has chosen it meanwhile";
  run("key pagedown\nwait-idle\n");
  open_lesson("union_of_balls");
  EXPECT_EQ(state().settings.request.engine, EngineChoice::cgal)
      << "nor does it go on in another lesson";
}

TEST_F(LessonsTest, CloseBringsBackMoleculeSettingsAndHistory) {
  open_crambin();
  run("alpha.set 2\nwait-idle\nalpha.set 3\nwait-idle\nview.edges on\nselect.atoms A:15\n");
  const Settings before = state().settings.all;
  const std::string undo = state().undo_text;
  open_lesson("union_of_balls");
  EXPECT_NE(state().molecule.name, "1crn.pdb");
  EXPECT_EQ(state().recent.size(), 1u) << "its molecules are not among the recent files";
  run("lesson.next\nwait-idle\nlesson.close\nwait-idle\n");
  EXPECT_FALSE(memory().open);
  EXPECT_EQ(state().molecule.name, "1crn.pdb");
  const Settings after = state().settings.all;
  EXPECT_EQ(difference_text(before, after), "");
  EXPECT_EQ(state().result->request.alpha_angstrom2, 3);
  EXPECT_EQ(state().undo_text, undo);
  run("edit.undo\nedit.undo\nedit.undo\nwait-idle\n");
  EXPECT_EQ(state().settings.request.alpha_angstrom2, 2);
}

TEST_F(LessonsTest, WithoutAMoleculeBeforeStartPageAndLookComeBack) {
  const DisplaySettings before = state().settings.display;
  run("frames 3\n");
  EXPECT_TRUE(has("start.learn"));
  open_lesson(write(kShort).string());
  EXPECT_NE(state().settings.display, before);
  run("lesson.next\nwait-idle\nlesson.close\nwait-idle\n");
  EXPECT_FALSE(memory().open);
  EXPECT_FALSE(state().molecule.loaded);
  EXPECT_EQ(state().settings.display, before);
  EXPECT_EQ(state().settings.request.alpha_angstrom2, 0);
  run("frames 3\n");
  EXPECT_TRUE(has("start.learn"));
  open_crambin();
  EXPECT_EQ(state().molecule.name, "1crn.pdb");
  EXPECT_TRUE(state().result);
}

TEST_F(LessonsTest, AMoleculeThatIsBeingOpenedComesBack) {
  run("file.open " + crambin().string() + "\nlesson.open union_of_balls\nwait-idle\n");
  EXPECT_EQ(state().molecule.name, "one_ball.xyzr");
  run("lesson.close\nwait-idle\n");
  EXPECT_EQ(state().molecule.name, "1crn.pdb");
}

TEST_F(LessonsTest, ClosedBeforeItsMoleculeIsThere) {
  open_crambin();
  run("alpha.set 3\nwait-idle\nlesson.open union_of_balls\n");
  for (int k = 0; k < 1000 && !memory().open; ++k) run("frames 1\n");
  ASSERT_TRUE(memory().open);
  run("lesson.close\nwait-idle\n");
  EXPECT_EQ(state().molecule.name, "1crn.pdb");
  EXPECT_EQ(state().settings.request.alpha_angstrom2, 3);
  EXPECT_EQ(state().undo_text, "alpha");
}

TEST_F(LessonsTest, AFileOfTheUsersStays) {
  open_lesson(write(kShort).string());
  run("open " + crambin().string() + "\nwait-idle\nframes 2\n");
  EXPECT_EQ(state().molecule.name, "1crn.pdb");
  EXPECT_TRUE(memory().left);
  EXPECT_TRUE(has("lesson.left"));
  run("click lesson.again_left\nwait-idle\n");
  EXPECT_EQ(state().molecule.name, "two_balls.xyzr");
  EXPECT_FALSE(memory().left);
  run("lesson.close\nwait-idle\n");
  EXPECT_EQ(state().molecule.name, "1crn.pdb");
}

TEST_F(LessonsTest, ARefusedCommandIsShownWithItsLine) {
  const fs::path file =
      write("# T\nS\n## One\nText.\n```\nmolecule two_balls.xyzr\nalpha.set x\n```\n");
  open_lesson(file.string());
  EXPECT_NE(memory().refused.find("lesson.md, line 7: "), std::string::npos) << memory().refused;
  run("frames 2\n");
  EXPECT_TRUE(has("lesson.refused"));
}

TEST_F(LessonsTest, WrongOnesAreToldBeforeAnythingHappens) {
  open_crambin();
  const auto expect_fault = [&](const std::string& name, const std::string& fault) {
    run("lesson.open " + name + "\nwait-idle\n");
    EXPECT_EQ(state().error_title, "The lesson cannot be opened");
    EXPECT_NE(state().error.find(fault), std::string::npos) << state().error;
    EXPECT_EQ(state().molecule.name, "1crn.pdb");
    EXPECT_FALSE(memory().open);
    run("frames 3\nclick error.ok\n");
  };
  const auto commands = [&](const std::string& line) {
    return write("# T\nS\n## One\nText.\n```\nmolecule two_balls.xyzr\n" + line + "\n```\n")
        .string();
  };
  expect_fault("union_of_bals", "There is no lesson \"union_of_bals\". Did you mean");
  expect_fault("/no/such.md", "/no/such.md: ");
  expect_fault(write("no title\n").string(), "lesson.md, line 1: the title is missing");
  expect_fault(commands("alpha.sit 1"), "lesson.md, line 7: there is no command \"alpha.sit\"");
  expect_fault(commands("file.export /tmp/x.ply"), "lesson.md, line 7: a lesson cannot run file.");
}

// A step that names no camera gets that of a newly opened molecule. Earlier changes of the view by
// steps or the reader do not matter.
TEST_F(LessonsTest, EachStepBeginsWithItsOwnCamera) {
  const auto second_step_after = [&](const std::string& first, const std::string& by_hand) {
    const std::string none = "# T\nS\n```\nmolecule unequal_balls.xyzr\n```\n";
    fs::copy_file(lessons_folder() / "unequal_balls.xyzr", folder_ / "unequal_balls.xyzr",
                  fs::copy_options::overwrite_existing);
    open_lesson(write(none + "## One\nText.\n```\n" + first + "\n```\n## Two\nText.\n").string());
    run(by_hand + "wait-idle\nlesson.next\nwait-idle\nframes 3\nwait-idle\n");
    EXPECT_EQ(memory().step, 1u);
    const ViewportInfo& v = state().viewport;
    return std::vector<double>{v.into_view.x, v.into_view.y, v.into_view.z, v.angstrom_per_pixel};
  };
  const std::vector<double> usual = second_step_after("alpha.set 0", "");
  const std::vector<double> turned = second_step_after("view.from x", "");
  const std::vector<double> zoomed = second_step_after("view.from -y", "move view\nwheel 5\n");
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(turned[k], usual[k], 1e-9);
    EXPECT_NEAR(zoomed[k], usual[k], 1e-9);
  }
  // The first view may have been fitted to a picture with one more row.
  constexpr double kOneRow = 0.003;
  EXPECT_NEAR(turned[3], usual[3], kOneRow * usual[3]);
  EXPECT_NEAR(zoomed[3], usual[3], kOneRow * usual[3]);
}

// If a text does not fit, a button says so and scrolls to its end.
TEST(LessonText, ThatGoesOnBelowSaysSo) {
  Panels p({640, 400, 2});
  auto lesson = std::make_shared<Lesson>();
  lesson->title = "T";
  lesson->steps.resize(1);
  lesson->steps[0].title = "One";
  std::string words;
  for (int n = 0; n < 400; ++n) words += "word ";
  lesson->steps[0].shown.text = {{words, false}};
  LessonState& m = p.state.lessons;
  m.open = lesson;
  m.shown = true;
  p.frame(4);
  EXPECT_TRUE(m.overflows);
  EXPECT_TRUE(m.more_below);
  ASSERT_TRUE(p.rects.contains("lesson.more"));
  EXPECT_LE(p.rects["lesson.more"].y1, p.rects["lesson.back"].y0);
  for (int n = 0; n < 20 && m.more_below; ++n) p.click("lesson.more");
  EXPECT_FALSE(m.more_below);
}

// No part of a lesson may lie outside the window, and the view must stay large enough.
TEST_F(LessonsTest, HaveRoomAtPresenterSize) {
  open_lesson("union_of_balls");
  for (const auto& [width, height] : {std::pair(1280, 800), {1920, 1080}}) {
    run("size " + std::to_string(width) + " " + std::to_string(height) +
        "\nview.presenter_size on\nframes 3\n");
    const WidgetRect text = viewer_->widgets().at("lesson.text");
    const WidgetRect next = viewer_->widgets().at("lesson.next");
    EXPECT_LE(text.x1, width);
    EXPECT_LE(next.x1, width);
    EXPECT_LE(next.y1, height);
    EXPECT_LT(text.y1, next.y0) << "the whole text is seen";
    EXPECT_GT(state().viewport.width, 0.45f * width);
    EXPECT_EQ(has("alpha.slider"), width > 1500);
    run("click lesson.presenter\nframes 3\n");
    EXPECT_FALSE(state().window.presenter_size);
    EXPECT_TRUE(has("alpha.slider"));
  }
}

// Every field and button of every page is inside its page, beside a lesson at presenter size, too.
TEST_F(LessonsTest, PagesHaveRoomBesideThemAtPresenterSize) {
  open_lesson("union_of_balls");
  run("open " ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz\nwait-idle\n");
  run("size 1280 800\nview.presenter_size on\nframes 3\n");
  for (const PanelSpec& page : panels()) {
    if (page.place != PanelPlace::bottom) continue;
    run("view.page " + std::string(page.id) +
        "\nwait-idle\nframes 3\nwait-idle\nframes 3\nmove status.move\nframes 3\n");
    const WidgetRects& all = viewer_->widgets();
    const WidgetRect below = all.at("layout.splitter");
    std::size_t seen = 0;
    for (const KeyState::Stop& stop : state().keys.stops) {
      const WidgetRect at = all.at(stop.name);
      const bool beside = stop.name.starts_with("lesson") || stop.name.starts_with("status.");
      const bool of_page = at.y0 > below.y0 && !beside;
      if (!of_page) continue;
      ++seen;
      EXPECT_LE(at.x1, below.x1) << page.id << ": " << stop.name;
    }
    EXPECT_GT(seen, 10u) << page.id;
  }
  run("view.page cavities\nwait-idle\nframes 3\nwait-idle\n");
  for (const char* name : {"cavities.all", "cavities.none", "cavities.draw", "cavities.columns",
                           "cavities.save", "cavities.shown"}) {
    const WidgetRect at = viewer_->widgets().at(name);
    EXPECT_LE(at.x1, viewer_->widgets().at("layout.splitter").x1) << name;
  }
  run("move cavities.totals\nwheel -30\nframes 3\n");
  EXPECT_TRUE(viewer_->widgets().at("cavities.row.1").visible);
}

// The list of lessons is read after the lesson, and both arrive in one poll. The lesson must not be
// lost.
TEST(LessonFiles, WhatIsOpenedIsNotLostForTheList) {
  LessonFiles files([] {}, {lessons_folder()});
  const auto finish = [&] {
    while (files.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  files.open("union_of_balls");
  finish();
  files.read_list();
  finish();
  const LessonFiles::News news = files.poll();
  EXPECT_TRUE(news.shelf);
  ASSERT_TRUE(news.opened);
  EXPECT_EQ(news.opened->title, "A molecule as a union of balls");
}

class Chapter : public LessonsTest, public ::testing::WithParamInterface<fs::path> {
 protected:
  Image view() {
    const fs::path path = folder_ / "view.png";
    run("file.save_picture \"" + path.string() + "\" 200 150 none\nwait-idle\n");
    return pixels_of(path);
  }
  void expect_picture(std::size_t step, const char* part) {
    expect_like_baseline(
        "lessons/" + GetParam().stem().string() + "-" + std::to_string(step + 1) + part, view());
  }
};

// The text of a step with its facts, and with the answer once that is revealed.
struct Said {
  std::string where;
  std::vector<LessonParagraph> text;
  bool revealed = false;
};

// In a window of this size no scrolling is needed.
void expect_room(const std::string& lesson, const std::vector<Said>& all, Size size) {
  Panels p(size);
  LessonState& m = p.state.lessons;
  for (const Said& said : all) {
    auto one = std::make_shared<Lesson>();
    one->title = lesson;
    one->steps.resize(1);
    one->steps[0].title = said.where;
    one->steps[0].shown.text = said.text;
    m.open = one;
    m.shown = m.scroll_to_top = true;
    p.frame(3);
    EXPECT_FALSE(m.overflows) << said.where << (said.revealed ? ", the answer" : "") << ", scale "
                              << size.scale << ", letters " << m.letters;
  }
}

// A step that cannot be carried out fails the test. So does a fact that is never known, and a
// picture that differs.
TEST_P(Chapter, PlaysFromTheFirstToTheLastStep) {
  std::vector<Said> all;
  run("size 760 400\n");  // a small picture is drawn quickly
  open_lesson(GetParam().string());
  ASSERT_EQ(state().error, "");
  ASSERT_TRUE(memory().open);
  const std::size_t steps = memory().open->steps.size();
  ASSERT_TRUE(memory().open->steps.back().asks()) << "the last step asks something";
  for (std::size_t step = 0; step < steps; ++step) {
    EXPECT_EQ(memory().step, step);
    const std::string where = memory().open->steps[step].title;
    EXPECT_TRUE(memory().ready) << where;
    EXPECT_EQ(memory().refused, "") << where;
    EXPECT_EQ(state().error, "") << where;
    EXPECT_EQ(state().compute_error, "") << where;
    EXPECT_EQ(memory().said.find("…"), std::string::npos) << where << ": " << memory().said;
    all.push_back({where, memory().paragraphs, false});
    expect_picture(step, "");
    if (memory().open->steps[step].asks()) {
      run("lesson.reveal\nwait-idle\nframes 3\nwait-idle\nframes 2\n");
      EXPECT_EQ(memory().refused, "") << where;
      EXPECT_EQ(memory().said.find("…"), std::string::npos) << where << ": " << memory().said;
      all.push_back({where, memory().paragraphs, true});
      expect_picture(step, "-answer");
    }
    run("lesson.next\nwait-idle\nframes 3\nwait-idle\nframes 2\n");
  }
  const std::string title = memory().open->title;
  viewer_.reset();  // there is one ImGui
  for (const Size size : {Size{1280, 800, 1}, {640, 400, 2}}) expect_room(title, all, size);
}

// Steps at different alphas must have different pictures.
TEST_F(LessonsTest, ThePictureOfAStepTellsItsAlpha) {
  run("size 760 400\n");
  open_lesson("growing_balls");
  const auto view = [&] {
    run("file.save_picture \"" + (folder_ / "view.png").string() + "\" 200 150 none\nwait-idle\n");
    return pixels_of(folder_ / "view.png");
  };
  const Image first = view(), again = view();
  EXPECT_TRUE(compare_pictures(first, again).small());
  run("alpha.set 1.5\nwait-idle\n");
  EXPECT_FALSE(compare_pictures(first, view()).small());
}

std::string name_of(const ::testing::TestParamInfo<fs::path>& of) {
  return of.param.stem().string().substr(3);
}
INSTANTIATE_TEST_SUITE_P(Lessons, Chapter, ::testing::ValuesIn(chapters()), name_of);

}  // namespace
}  // namespace alphascope::testing
