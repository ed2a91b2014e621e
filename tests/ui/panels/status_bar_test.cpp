// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the last move in the status bar: its time, its forms at each size, and its button.
#include "app/viewer/frames/move_clock.hpp"
#include "core/document/store/answer.hpp"
#include "core/triangulation/triangulation_report.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/complex/timings_text.hpp"

namespace alphascope {
namespace {

using testing::loaded_state;
using testing::Panels;
using namespace std::chrono_literals;

std::shared_ptr<const Answer> answer_at(double alpha) {
  auto answer = std::make_shared<Answer>();
  answer->request.alpha_angstrom2 = alpha;
  return answer;
}

TEST(MoveClock, RunsFromTheChangeToThePicture) {
  MoveClock clock;
  const MoveClock::Clock::time_point start{};
  Request moved;
  moved.alpha_angstrom2 = 3;
  const auto first = answer_at(0), third = answer_at(3);
  clock.follow(first, start);
  EXPECT_FALSE(clock.milliseconds()) << "no move asked for the first picture";
  clock.note_wanted(moved, start + 1s);
  clock.note_wanted(moved, start + 2s);  // the sender waits
  clock.follow(first, start);
  EXPECT_FALSE(clock.milliseconds());
  clock.follow(third, std::nullopt);  // not drawn yet
  EXPECT_FALSE(clock.milliseconds());
  clock.follow(third, start + 1250ms);
  ASSERT_TRUE(clock.milliseconds());
  EXPECT_DOUBLE_EQ(*clock.milliseconds(), 250);
  clock.follow(third, start + 9s);  // drawn again, with more samples
  EXPECT_DOUBLE_EQ(*clock.milliseconds(), 250);
  clock.follow(answer_at(0), start + 10s);  // another file
  EXPECT_FALSE(clock.milliseconds());
}

// A moving slider asks for more alphas than an engine answers.
TEST(MoveClock, TakesTheLatestMoveToAnAlpha) {
  MoveClock clock;
  const MoveClock::Clock::time_point start{};
  for (int i = 0; i < 1000; ++i) {
    Request moved;
    moved.alpha_angstrom2 = i % 500;
    clock.note_wanted(moved, start + std::chrono::milliseconds(i));
  }
  clock.follow(answer_at(499), start + 1100ms);
  ASSERT_TRUE(clock.milliseconds());
  EXPECT_DOUBLE_EQ(*clock.milliseconds(), 101);
}

WholeState moved_state() {
  WholeState s = loaded_state();
  Answer answer = *s.result;
  answer.complex.engine = s.ours.engine;
  answer.complex.timings = s.ours.cold->times;
  answer.cold = true;
  s.result = std::make_shared<const Answer>(std::move(answer));
  s.move_milliseconds = 34.2;
  return s;
}

TEST(LastMove, SaysTimeEngineCgalAndBadge) {
  WholeState s = moved_state();
  EXPECT_EQ(last_move(s, nullptr).front().line(),
            "34.2 ms to picture  ·  dual-edge engine on CPU, 2 threads  ·  CGAL 60.5 ms  ·  "
            "✓ identical");
  EXPECT_EQ(last_move(s, nullptr).back().line(), "34.2 ms  ·  CPU  ·  CGAL 60.5 ms  ·  ✓");
  s.badge = {BadgeInfo::State::not_compared, "not compared with CGAL"};
  EXPECT_EQ(last_move(s, nullptr).front().line(),
            "34.2 ms to picture  ·  dual-edge engine on CPU, 2 threads  ·  not compared")
      << "CGAL's time is of another complex";
  s.badge.state = BadgeInfo::State::identical;
  s.cgal.cold->alpha_angstrom2 = 7;
  EXPECT_EQ(last_move(s, nullptr).front().cgal, "") << "another alpha";
  s.move_milliseconds.reset();
  EXPECT_EQ(last_move(s, nullptr).front().time, "20.2 ms to compute");
}

// A triangulation by the CPU beside a GPU is never quiet.
TEST(LastMove, SaysThatTheGpuDidNotMakeTheTriangulation) {
  const WholeState s = moved_state();
  TriangulationReport report;
  EXPECT_EQ(last_move(s, &report).front().line(), last_move(s, nullptr).front().line())
      << "there is no GPU";
  report.why_not = "the centres lie in a plane";
  report.maker = "CGAL";
  const LastMove move = last_move(s, &report).front();
  EXPECT_EQ(move.engine, "dual-edge engine on CPU, 2 threads, triangulation by CGAL");
  EXPECT_NE(move.help.find("The GPU did not make the triangulation of all balls: the centres lie "
                           "in a plane.\n"),
            std::string::npos)
      << move.help;
  report.by = TriangulationReport::By::insertion;
  report.maker = "CPU, 2 threads";
  EXPECT_EQ(last_move(s, &report).front().engine,
            "dual-edge engine on CPU, 2 threads, triangulation by the CPU");
}

TEST(LastMove, SaysHowTheCpuSharedTheTriangulation) {
  TriangulationReport report;
  report.by = TriangulationReport::By::insertion;
  report.inserters = 1;
  EXPECT_TRUE(triangulation_sentences(report).empty());
  report.inserters = 2;
  report.put_off = 6022;
  EXPECT_EQ(triangulation_sentences(report),
            std::vector<std::string>{"Balls were inserted in up to 2 places at the same time, "
                                     "and 6,022 balls were put off to a later turn."});
}

TEST(LastMove, SaysHowTheGpuWrapped) {
  TriangulationReport report;
  report.by = TriangulationReport::By::device;
  report.known = 32'581;
  report.open_faces = 40'000;
  report.needed = 16'052;
  report.waves = 9;
  const std::vector<std::string> said = triangulation_sentences(report);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[0],
            "Wrapping began with 32,581 tetrahedra, 40,000 open faces and 16,052 balls, and took "
            "9 waves.");
}

struct Bar {
  testing::Size size;
  std::vector<const char*> there, missing;
};

class StatusBarAtEverySize : public ::testing::TestWithParam<Bar> {};

// Counts make way first. The last move stays in any window, whole and within it.
TEST_P(StatusBarAtEverySize, ShowsTheLastMove) {
  const Bar bar = GetParam();
  Panels p(bar.size);
  p.state = moved_state();
  p.state.window.page = "cavities";
  p.frame(3);
  ASSERT_TRUE(p.rects.contains("status.move"));
  const WidgetRect move = p.rects["status.move"];
  EXPECT_TRUE(move.visible);
  EXPECT_LE(move.x1, bar.size.width * bar.size.scale);
  EXPECT_GE(move.x0, 0);
  for (const char* name : bar.there) EXPECT_TRUE(p.rects.contains(name)) << name;
  for (const char* name : bar.missing) EXPECT_FALSE(p.rects.contains(name)) << name;
  p.click("status.move");
  EXPECT_EQ(p.state.window.page, "timings");
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, StatusBarAtEverySize,
    ::testing::Values(
        Bar{{1920, 1080, 1}, {"status.vertices", "status.hash", "status.memory"}, {}},
        Bar{{1280, 800, 2}, {"status.hash", "status.memory"}, {}},
        Bar{{900, 600, 2}, {"status.tetrahedra", "status.memory"}, {"status.vertices"}},
        Bar{{450, 600, 2}, {}, {"status.tetrahedra", "status.hash"}},
        Bar{{300, 600, 1}, {}, {"status.tetrahedra"}}));

// Counts make way for a notice as well, so that it is not cut.
TEST(StatusBar, ANoticeHasTheRoomItNeeds) {
  const auto width_of_notice = [](const char* notice, float window) {
    Panels p({window, 720, 1});
    p.state = moved_state();
    p.state.selected_count_text = "3 atoms";
    p.state.notice = notice;
    p.frame(3);
    EXPECT_TRUE(p.rects.contains("status.move")) << window;
    EXPECT_TRUE(p.rects.contains("status.notice")) << window;
    const WidgetRect shown = p.rects["status.notice"];
    EXPECT_LE(shown.x1, p.rects["status.memory"].x0) << window;
    p.state.notice.clear();
    p.frame(3);
    EXPECT_TRUE(p.rects.contains("status.hash")) << "it has its room again";
    return shown.x1 - shown.x0;
  };
  for (const char* notice :
       {"Undone: selection", "Saved /home/somebody/pictures/haemoglobin-with-water.png"}) {
    const float whole = width_of_notice(notice, 3000);
    EXPECT_GT(whole, 60);
    EXPECT_EQ(width_of_notice(notice, 1280), whole) << notice;
    EXPECT_EQ(width_of_notice(notice, 1100), whole) << notice;
  }
}

// A new notice is read although the mouse names something. Later that thing has its place.
TEST(StatusBar, ANewNoticeStaysBesideTheThingUnderTheMouse) {
  Panels p({1280, 720, 1});
  p.state = moved_state();
  p.state.viewport.under_mouse_line = "A:HIS 87:NE2  ·  (1.000, 2.000, 3.000) Å  ·  radius 1.64 Å";
  p.frame(3);
  const auto shown = [&](const char* name) {
    return p.rects.contains(name) ? p.rects[name] : WidgetRect{};
  };
  EXPECT_GT(shown("status.under_mouse").x1, 0);
  const auto width = [&](const char* name) { return shown(name).x1 - shown(name).x0; };
  p.state.notice = "Saved /home/somebody/pictures/haemoglobin-with-water.png";
  p.frame(3);
  const float whole = width("status.notice");
  EXPECT_GT(whole, 200);
  if (shown("status.under_mouse").x1 > 0) {
    EXPECT_LE(shown("status.notice").x1, shown("status.under_mouse").x0);
  }
  p.state.viewport.under_mouse_line.clear();
  p.frame(3);
  EXPECT_EQ(width("status.notice"), whole) << "it is as wide as without a thing";
  p.state.viewport.under_mouse_line = "A:HIS 87:NE2";
  p.frame(600);
  EXPECT_EQ(width("status.notice"), 0) << "it is no news after ten seconds";
  EXPECT_GT(width("status.under_mouse"), 0);
  p.state.notice = "Saved /home/somebody/pictures/haemoglobin-with-water.png";
  p.frame(3);
  EXPECT_EQ(width("status.notice"), whole) << "the same text once more is news";
}

// The share done stays in sight while the mouse names something.
TEST(StatusBar, ARunningJobStaysBesideTheThingUnderTheMouse) {
  Panels p({1280, 720, 1});
  p.state = moved_state();
  p.state.viewport.under_mouse_line = "A:HIS 87:NE2";
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("status.job")) << "nothing runs";
  p.state.jobs.push_back({.title = "Fetching pdb:1CRN", .share = 0.45, .seconds = 2});
  p.frame(3);
  ASSERT_TRUE(p.rects.contains("status.job"));
  ASSERT_TRUE(p.rects.contains("status.under_mouse"));
  EXPECT_LE(p.rects["status.job"].x1, p.rects["status.under_mouse"].x0);
  p.state.jobs[0].seconds = 0.5;
  p.frame(3);
  EXPECT_FALSE(p.rects.contains("status.job")) << "it has just begun";
}

TEST(StatusBar, BackgroundWorkStaysBesideTheThingUnderTheMouse) {
  Panels p({1920, 1080, 1});
  p.state = moved_state();
  p.state.viewport.under_mouse_line = "A:HIS 87:NE2";
  p.state.background.text = "Filtration of all simplices 45 %";
  p.frame(3);
  ASSERT_TRUE(p.rects.contains("status.job"));
  ASSERT_TRUE(p.rects.contains("status.under_mouse"));
  EXPECT_LE(p.rects["status.job"].x1, p.rects["status.under_mouse"].x0);
}

TEST(MoveClock, ForgetsMovesOfAnotherFile) {
  MoveClock clock;
  const MoveClock::Clock::time_point start{};
  Request moved;
  moved.alpha_angstrom2 = 3;
  clock.note_wanted(moved, start);
  clock.forget();
  clock.follow(answer_at(3), start + 1s);
  EXPECT_FALSE(clock.milliseconds());
}

class LastMoveTest : public testing::ViewerTest {
 protected:
  LastMoveTest() : ViewerTest(false) {}
};

// The time in the window is at least that of the engine and of the picture's stages.
TEST_F(LastMoveTest, IsMeasuredInTheWindow) {
  open_crambin();
  const ViewState& s = viewer_->state();
  EXPECT_FALSE(s.move_milliseconds) << "opening is no move";
  run("alpha.set 3\nwait-idle\nframes 3\n");
  ASSERT_TRUE(s.move_milliseconds);
  double least = s.result->complex.timings.wall_milliseconds;
  for (const StageTime& stage : viewer_->picture_stages()) least += stage.milliseconds;
  EXPECT_GE(*s.move_milliseconds, least);
  EXPECT_LT(*s.move_milliseconds, 60000);
  const double before = *s.move_milliseconds;
  run("view.from y\nframes 3\n");
  EXPECT_EQ(s.move_milliseconds, before) << "a turned view is no move";
  run("file.save_session " + (folder_ / "s.json").string() + "\nwait-idle\nalpha.set 1\n" +
      "wait-idle\nframes 3\nfile.open_session " + (folder_ / "s.json").string() +
      "\nwait-idle\nframes 3\n");
  EXPECT_EQ(s.settings.request.alpha_angstrom2, 3);
  EXPECT_FALSE(s.move_milliseconds) << "a session's alpha is no move";
}

}  // namespace
}  // namespace alphascope
