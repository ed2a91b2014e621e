// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page of contacts in the whole window: its table, selection by a click, and its command.
#include <algorithm>

#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class ContactsPage : public ViewerTest {
 protected:
  bool has(const char* widget) { return viewer_->widgets().contains(widget); }
  // Haemoglobin has four chains, each of which touches others.
  void open_haemoglobin() {
    viewer_->open(ALPHASCOPE_SOURCE_DIR "/resources/molecules/4hhb.pdb.gz");
    run("wait-idle\nview.page contacts\nframes 3\nwait-idle\n");
  }
  std::string chains_of_selection() {
    std::string chains;
    const Molecule& molecule = viewer_->state().references->molecule();
    for (const Ref& ref : viewer_->state().settings.selection.items.items()) {
      const std::string name = name_of(molecule, ref).substr(0, 1);
      if (chains.find(name) == std::string::npos) chains += name;
    }
    std::sort(chains.begin(), chains.end());
    return chains;
  }
};

TEST_F(ContactsPage, ARowSelectsTheAtomsOfItsContact) {
  open_haemoglobin();
  ASSERT_TRUE(has("contacts.row.1"));
  run("click contacts.row.1 0.1\nframes 2\n");
  const std::string chains = chains_of_selection();
  EXPECT_EQ(chains.size(), 2u) << chains;
  run("edit.undo\nwait-idle\n");
  EXPECT_TRUE(viewer_->state().settings.selection.empty());
}

TEST_F(ContactsPage, TheCommandSelectsAContactInEitherOrder) {
  open_haemoglobin();
  run("view.page timings\nwait-idle\ncontacts.select B A\nframes 3\nwait-idle\nframes 2\n");
  EXPECT_EQ(viewer_->state().window.page, "contacts");
  EXPECT_EQ(chains_of_selection(), "AB");
  run("contacts.select A Z\nframes 3\nwait-idle\n");
  EXPECT_NE(viewer_->state().notice.text().find("do not touch"), std::string::npos)
      << viewer_->state().notice.text();
  EXPECT_EQ(chains_of_selection(), "AB") << "stays";
}

TEST_F(ContactsPage, SaysWhyThereIsNoTable) {
  run("view.page contacts\nframes 2\n");
  EXPECT_TRUE(has("contacts.waiting"));
  EXPECT_FALSE(has("contacts.row.1"));
  open_crambin();
  run("view.page contacts\nframes 3\nwait-idle\n");
  EXPECT_TRUE(has("contacts.text")) << "one chain touches no other";
  EXPECT_FALSE(has("contacts.row.1"));
  viewer_->state().settings.request.tetrahedra_only = true;
  run("wait-idle\nframes 3\n");
  EXPECT_TRUE(has("contacts.waiting"));
}

}  // namespace
}  // namespace alphascope::testing
