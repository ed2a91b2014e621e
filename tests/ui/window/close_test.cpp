// SPDX-License-Identifier: GPL-3.0-or-later
// Tests closing the molecule: nothing of it stays, its work ends, and other files open afterwards.
#include "core/document/cavities/cavity_results.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/viewport_info.hpp"

namespace alphascope::testing {
namespace {

class CloseTest : public ViewerTest {
 protected:
  CloseTest() : ViewerTest(false) {}
  const ViewState& state() { return viewer_->state(); }
};

TEST_F(CloseTest, LeadsToTheStartPageAndKeepsNothing) {
  EXPECT_NE(viewer_->commands().find("file.close")->reason_against(), "") << "nothing is open";
  open_crambin();
  run("alpha.set 3\nselect.atoms A:THR 1:CA\nview.page cavities\nwait-idle\nframes 3\n");
  ASSERT_TRUE(state().result);
  run("cavities.choose 1\nwait-idle\nframes 3\n");
  ASSERT_TRUE(state().cavities.page);
  const std::weak_ptr<const CavityLines> lines = state().cavities.page->rows.lines;
  const std::weak_ptr<const CavityTable> table = state().cavities.page->rows.all;
  EXPECT_FALSE(lines.expired() || table.expired());
  run("view.page timings\nwait-idle\nframes 3\n");  // the page of cavities is not drawn again
  run("file.close\nwait-idle\nframes 5\n");
  EXPECT_TRUE(lines.expired() && table.expired()) << "the page of cavities keeps its table";
  EXPECT_TRUE(state().cavities.chosen.empty());
  EXPECT_FALSE(state().molecule.loaded);
  EXPECT_EQ(state().result, nullptr);
  EXPECT_EQ(state().references, nullptr);
  EXPECT_TRUE(state().settings.selection.items.empty());
  EXPECT_EQ(state().undo_text, "");
  EXPECT_EQ(state().viewport.texture, 0u);
  EXPECT_TRUE(viewer_->widgets().contains("start.open")) << "the start page";
  EXPECT_EQ(viewer_->session().state().opened, nullptr);
  EXPECT_TRUE(state().error.empty()) << state().error;
  EXPECT_TRUE(state().jobs.empty());
}

TEST_F(CloseTest, OtherFilesOpenAfterwards) {
  open_crambin();
  run("file.close\nwait-idle\nframes 3\n");
  open_crambin();
  run("frames 3\n");
  ASSERT_TRUE(state().result);
  EXPECT_EQ(state().result->complex.hash, expected(state().settings.request.alpha_angstrom2).hash);
  EXPECT_NE(state().viewport.texture, 0u);
  EXPECT_GT(state().viewport.angstrom_per_pixel, 0);
  run("key ctrl+w\nwait-idle\nframes 3\n");
  EXPECT_FALSE(state().molecule.loaded) << "by the key";
}

// The job may be at any place when the molecule is closed. What it delivers later is dropped.
TEST_F(CloseTest, EndsWorkAtAnyTime) {
  for (int frames = 0; frames < 6; ++frames) {
    run("open " + (fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz").string() +
        "\n");
    while (!state().molecule.loaded) viewer_->step(nullptr);
    for (int i = 0; i < frames; ++i) viewer_->step(nullptr);
    viewer_->calls().files.close_file();
    for (int i = 0; i < 3; ++i) viewer_->step(nullptr);
    run("wait-idle\nframes 3\n");
    EXPECT_FALSE(state().molecule.loaded) << frames;
    EXPECT_EQ(state().result, nullptr) << frames;
    EXPECT_EQ(viewer_->session().state().opened, nullptr) << frames;
    EXPECT_TRUE(state().error.empty()) << state().error;
  }
}

}  // namespace
}  // namespace alphascope::testing
