// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the window Tasks: what runs, the time left, cancelling, and the last messages.
#include <chrono>
#include <set>

#include "app/viewer/jobs/time_left.hpp"
#include "app/viewer/parts/message_notes.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/error_kind.hpp"

namespace alphascope::testing {
namespace {

using std::chrono::milliseconds;

TEST(TimeLeftOfJobs, FollowsFromTheSpeedOfTheStep) {
  TimeLeft left;
  const TimeLeft::Clock::time_point start{};
  const auto after = [&](double share, int ms, const std::string& title = "Opening a.pdb") {
    RunningJobs jobs{{JobId::opening, title, "atoms", share}};
    left.follow(jobs, start + milliseconds(ms));
    return jobs[0].seconds_left;
  };
  EXPECT_EQ(after(0, 0), -1);
  EXPECT_EQ(after(0.2, 500), -1) << "too early";
  EXPECT_NEAR(after(0.5, 2000), 2, 1e-9);
  EXPECT_NEAR(after(0.75, 3000), 1, 1e-9);
  EXPECT_EQ(after(0.1, 4000), -1) << "another step has begun";
  EXPECT_NEAR(after(0.4, 6000), 4, 1e-9) << "of this step alone";
  EXPECT_EQ(after(-1, 7000), -1) << "the share is unknown";
  EXPECT_EQ(after(0.5, 8000), -1);
  EXPECT_EQ(after(0.9, 9999, "Opening b.pdb"), -1) << "another file";
  EXPECT_EQ(after(0.901, 12000, "Opening b.pdb"), -1) << "too little is done to tell";
}

TEST(MessagesOfTheWindow, AreKeptWhenTheyHaveGone) {
  WholeState s;
  MessageNotes notes(s);
  notes.follow();
  EXPECT_TRUE(s.tasks.messages.empty());
  s.notice = "Saved a.png";
  notes.follow();
  notes.follow();
  s.notice.clear();
  s.show_error("The file cannot be opened", "b.pdb: it is empty.", ErrorKind::input);
  s.show_error("The file cannot be opened", "c.pdb: it is empty.", ErrorKind::input);
  s.engine_note = "The CPU computes.";
  notes.follow();
  notes.follow();
  ASSERT_EQ(s.tasks.messages.size(), 4u) << "each once";
  using Kind = Message::Kind;
  EXPECT_EQ(s.tasks.messages[3].text, "Saved a.png");
  EXPECT_EQ(s.tasks.messages[3].time.size(), 8u);
  EXPECT_EQ(s.tasks.messages[2].kind, Kind::notice);
  EXPECT_EQ(s.tasks.messages[1].text, "The file cannot be opened: b.pdb: it is empty.");
  EXPECT_EQ(s.tasks.messages[0].kind, Kind::error);
  // The second error moves up when the first is dismissed. It is no news.
  s.error = "c.pdb: it is empty.";
  s.more_errors.clear();
  notes.follow();
  EXPECT_EQ(s.tasks.messages.size(), 4u);
  s.notice = "Copied.";
  notes.follow();
  s.notice = "Copied.";
  notes.follow();
  notes.follow();
  ASSERT_EQ(s.tasks.messages.size(), 6u) << "copied twice";
  EXPECT_EQ(s.tasks.messages[1].text, "Copied.");
  for (int n = 0; n < 200; ++n) {
    s.notice = std::to_string(n);
    notes.follow();
  }
  EXPECT_EQ(s.tasks.messages.size(), TaskState::kMostMessages);
  EXPECT_EQ(s.tasks.messages.front().text, "199");
}

TEST(TasksWindow, ListsWhatRunsAndCancels) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(2);
  p.click("status.memory");
  EXPECT_TRUE(p.state.tasks.shown) << "by a click on the status bar";
  EXPECT_TRUE(p.rects.contains("tasks.none"));
  p.state.jobs = {{JobId::fetching, "Fetching pdb:1CRN", "fetching pdb:1CRN", 0.5, 3, 3},
                  {.id = JobId::deriving, .title = "Filtration", .result = "filtration"},
                  {.id = JobId::deriving, .title = "Curves", .waits = true, .result = "curves"}};
  p.frame(3);
  ASSERT_TRUE(p.rects.contains("tasks.cancel.2"));
  EXPECT_FALSE(p.rects.contains("tasks.cancel.3"));
  EXPECT_FALSE(p.rects.contains("tasks.none"));
  p.click("tasks.cancel.1");
  EXPECT_EQ(p.asked.cancelled_result, "filtration");
  EXPECT_FALSE(p.asked.cancel);
  p.click("tasks.cancel.0");
  EXPECT_TRUE(p.asked.cancel);
  p.tap(key::kEscape);
  EXPECT_FALSE(p.state.tasks.shown);
}

TEST(TasksWindow, CopiesTheMessages) {
  Panels p({900, 600, 1});
  p.state.tasks.shown = true;
  p.state.tasks.messages = {
      {Message::Kind::error, "10:00:02", "b.pdb: it is empty.\n\nThe old one stays."},
      {Message::Kind::notice, "10:00:01", "Saved a.png"}};
  p.state.tasks.noted = 2;
  p.frame(3);
  EXPECT_TRUE(p.rects.contains("tasks.messages"));
  p.click("tasks.copy");
  EXPECT_EQ(p.asked.copied,
            "10:00:01  Saved a.png\n"
            "10:00:02  Error: b.pdb: it is empty. The old one stays.\n");
}

class TasksOfTheProgram : public ViewerTest {};

TEST_F(TasksOfTheProgram, HaveDerivedResultsAndMessages) {
  run("open " + crambin().string() + "\ntasks.show\nview.page cavities\n");
  std::set<std::string> derived;
  const auto start = std::chrono::steady_clock::now();
  const auto before = [&](int ms) {
    return std::chrono::steady_clock::now() - start < milliseconds(ms);
  };
  // The list is that of the last frame. So work may end before the list says so.
  const auto works = [&] { return viewer_->busy() || !viewer_->state().jobs.empty(); };
  while (before(500) || (works() && before(60'000))) {
    viewer_->step(nullptr);
    for (const RunningJob& job : viewer_->state().jobs) {
      if (job.id == JobId::deriving) derived.insert(job.title);
    }
  }
  EXPECT_FALSE(derived.empty());
  EXPECT_TRUE(viewer_->state().jobs.empty()) << viewer_->state().jobs.front().title;
  run("open /nonexistent/a.pdb\nwait-idle\nframes 2\n");
  ASSERT_FALSE(viewer_->state().tasks.messages.empty());
  EXPECT_EQ(viewer_->state().tasks.messages.front().kind, Message::Kind::error);
}

}  // namespace
}  // namespace alphascope::testing
