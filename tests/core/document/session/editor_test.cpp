// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the history of settings: one entry per gesture, and undo restores every part.
#include "core/document/session/editor.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

Settings with_alpha(double alpha) {
  Settings s;
  s.request.alpha_angstrom2 = alpha;
  return s;
}

TEST(Editor, OneEntryAGesture) {
  Editor editor;
  for (const double alpha : {1.0, 2.0, 3.0}) editor.set(with_alpha(alpha), 7);
  editor.set(with_alpha(4), 8);
  EXPECT_EQ(editor.undo_text(), "alpha");
  ASSERT_TRUE(editor.undo());
  EXPECT_EQ(editor.now(), with_alpha(3));
  ASSERT_TRUE(editor.undo());
  EXPECT_EQ(editor.now(), with_alpha(0));
  EXPECT_FALSE(editor.undo());
  ASSERT_TRUE(editor.redo());
  EXPECT_EQ(editor.now(), with_alpha(3));
  ASSERT_TRUE(editor.redo());
  EXPECT_EQ(editor.now(), with_alpha(4));
  EXPECT_FALSE(editor.redo());
}

TEST(Editor, ChangesWithoutGestureAreEntriesOfTheirOwn) {
  Editor editor;
  editor.set(with_alpha(1), 0);
  editor.set(with_alpha(2), 0);
  editor.undo();
  EXPECT_EQ(editor.now(), with_alpha(1));
}

TEST(Editor, AGestureThatEndsWhereItBeganIsNone) {
  Editor editor;
  editor.set(with_alpha(1), 1);
  editor.set(with_alpha(5), 2);
  editor.set(with_alpha(1), 2);
  EXPECT_EQ(editor.now(), with_alpha(1));
  editor.set(with_alpha(6), 2);  // a later change of the same gesture
  editor.undo();
  EXPECT_EQ(editor.now(), with_alpha(1));
}

TEST(Editor, AnUndoneGestureIsNotGoneOnWith) {
  Editor editor;
  editor.set(with_alpha(1), 1);
  editor.set(with_alpha(2), 3);
  editor.undo();
  editor.set(with_alpha(3), 3);  // the same gesture, but a separate entry
  editor.undo();
  EXPECT_EQ(editor.now(), with_alpha(1));
  editor.redo();
  editor.set(with_alpha(4), 3);
  editor.undo();
  EXPECT_EQ(editor.now(), with_alpha(3)) << "nor is one that was done again";
}

TEST(Editor, ANewChangeEndsRedo) {
  Editor editor;
  editor.set(with_alpha(1), 1);
  editor.undo();
  editor.set(with_alpha(2), 2);
  EXPECT_FALSE(editor.redo());
  EXPECT_EQ(editor.redo_text(), "");
}

TEST(Editor, PlaybackIsNoEntry) {
  Editor editor;
  editor.set(with_alpha(1), 1);
  for (double alpha = 2; alpha < 9; ++alpha) editor.set_without_entry(with_alpha(alpha));
  EXPECT_EQ(editor.now(), with_alpha(8));
  editor.undo();
  EXPECT_EQ(editor.now(), with_alpha(0));
  editor.redo();
  EXPECT_EQ(editor.now(), with_alpha(8)) << "where playback had come to";
}

TEST(Editor, ARefusedChangeTakesItsEntryAlong) {
  Editor editor;
  editor.set(with_alpha(1), 1);
  editor.set(with_alpha(2), 2);
  editor.set_without_entry(with_alpha(1));  // the change failed
  editor.undo();
  EXPECT_EQ(editor.now(), with_alpha(0));
}

TEST(Editor, AnotherFileStartsAnew) {
  Editor editor;
  editor.set(with_alpha(1), 1);
  editor.restart(with_alpha(1));
  EXPECT_FALSE(editor.undo());
  EXPECT_EQ(editor.undo_text(), "");
}

TEST(Editor, ForgetsTheOldestEntries) {
  Editor editor;
  const int all = static_cast<int>(Editor::kMostEntries) + 3;
  for (int i = 1; i <= all; ++i) editor.set(with_alpha(i), 0);
  int undone = 0;
  while (editor.undo()) ++undone;
  EXPECT_EQ(undone, static_cast<int>(Editor::kMostEntries));
  EXPECT_EQ(editor.now(), with_alpha(3));
}

TEST(Editor, SaysWhatWouldChange) {
  const Settings plain;
  Settings s = plain;
  EXPECT_EQ(difference_text(plain, s), "");
  s.request.solvent_radius_angstrom = 1.4;
  EXPECT_EQ(difference_text(plain, s), "solvent radius");
  s.open.balls.waters = true;
  s.display.balls = false;
  EXPECT_EQ(difference_text(plain, s), "solvent radius, choice of atoms and balls");
  s.display.edges = true;
  EXPECT_EQ(difference_text(plain, s), "solvent radius, choice of atoms and display");
  s = plain;
  s.open.balls.overrides.push_back({"HEM", "FE", 26, 1'000'000});
  EXPECT_EQ(difference_text(plain, s), "radii");
  s = plain;
  s.selection.items = RefSet({AtomRef{3, 0}});
  EXPECT_EQ(difference_text(plain, s), "selection");
  s.selection.cavities = RefSet({SimplexRef{{1, 0}, {2, 0}, {3, 0}, {4, 0}}});
  EXPECT_EQ(difference_text(plain, s), "selection") << "a cavity and what lines it are one choice";
  s.selection.items = {};
  EXPECT_EQ(difference_text(plain, s), "selection");
  s = plain;
  s.request.tuples.streams = 1;
  EXPECT_EQ(difference_text(plain, s), "engine");
}

}  // namespace
}  // namespace alphascope
