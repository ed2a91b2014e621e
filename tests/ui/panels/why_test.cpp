// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page "Why?" in the whole window: questions, sentences, drawings, and where its buttons
// lead.
#include <algorithm>

#include "core/document/explain/explanation_results.hpp"
#include "core/document/explain/explanation_text.hpp"
#include "core/document/explain/simplex_details.hpp"
#include "tests/ui/panel_state.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/explain/why_state.hpp"

namespace alphascope::testing {
namespace {

class WhyTest : public ViewerTest {
 protected:
  void ask(const std::string& atoms) {
    run("select.atoms " + atoms + "\nwhy.show\nframes 3\nwait-idle\nframes 3\n");
  }
  const WhyState& memory() { return memory_of<WhyState>(viewer_->panels(), "why"); }
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
  std::string said() {
    std::string text;
    if (!memory().shown) return text;
    for (const ExplanationLine& line : memory().shown->lines) text += line.text + "\n";
    return text;
  }
  bool drawn() {
    const Layers& layers = viewer_->state().layers;
    return std::any_of(layers.begin(), layers.end(),
                       [](const auto& layer) { return layer->id == "why"; });
  }
  // The line with this heading.
  std::size_t line(const std::string& heading) {
    const auto& lines = memory().shown->lines;
    const auto at = std::find_if(lines.begin(), lines.end(),
                                 [&](const auto& one) { return one.heading == heading; });
    return static_cast<std::size_t>(at - lines.begin());
  }
};

TEST_F(WhyTest, ExplainsWhatIsSelectedAndGoesToWhatDecides) {
  open_crambin();
  run("alpha.set 1.4\nwait-idle\nwhy.show\nframes 2\n");
  EXPECT_TRUE(has("why.nothing"));
  EXPECT_FALSE(drawn());

  ask("A:THR 1:CA,A:THR 1:CB");
  EXPECT_NE(said().find("the edge of balls 1 (A:THR 1:CA) and 4 (A:THR 1:CB)"), std::string::npos);
  EXPECT_NE(said().find("It is in the alpha complex at alpha = 1.4 Å²"), std::string::npos);
  ASSERT_TRUE(drawn());
  EXPECT_TRUE(has("why.line.0"));
  // The same at the alpha on screen.
  run("alpha.set -11\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_NE(said().find("It is not in the alpha complex at alpha = -11 Å²"), std::string::npos);

  run("why.marks off\nframes 2\n");
  EXPECT_FALSE(drawn());
  run("why.marks on\nframes 2\n");
  ASSERT_TRUE(drawn());

  // Goes to the triangle with which the edge becomes regular, and back.
  run("click why.go." + std::to_string(line("With alpha")) +
      "\nframes 3\nwait-idle\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_NE(said().find("This is the triangle of balls 1 (A:THR 1:CA), 4 (A:THR 1:CB) and 6"),
            std::string::npos);
  run("edit.undo\nframes 3\nwait-idle\nframes 3\n");
  EXPECT_NE(said().find("This is the edge of balls 1"), std::string::npos);
}

TEST_F(WhyTest, ExplainsWhatIsNotThere) {
  open_crambin();
  run("alpha.set 1.4\nwait-idle\n");
  ask("A:THR 1:CA,A:ASN 46:CA");
  EXPECT_NE(said().find("It is in no alpha complex"), std::string::npos);
  EXPECT_TRUE(drawn());
  ask("A:THR 1:");  // seven atoms
  EXPECT_TRUE(has("why.nothing"));
  EXPECT_FALSE(drawn());
}

}  // namespace
}  // namespace alphascope::testing
