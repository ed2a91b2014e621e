// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a ligand is visible in its cavity with the program's defaults. It is visible in the
// window, in a saved picture and in a recording.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "tests/support/molecules.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/layer_objects.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"

namespace alphascope::testing {
namespace {

class CavityPictureTest : public ViewerTest {
 protected:
  explicit CavityPictureTest(bool draw_shots_only = true) : ViewerTest(draw_shots_only) {}
  // The display at the program's start. Only samples differ, which merely smooth.
  void show_as_at_the_start() {
    DisplaySettings display;
    display.samples = 1;
    viewer_->state().settings.display = display;
  }

  void settle() { run("wait-idle\nframes 3\nwait-idle\nframes 3\n"); }
  void open_cavities(const fs::path& file) {
    run("open " + file.string() + "\nwait-idle\nclick bottom.cavities\nwait-idle\nframes 3\n");
    // If the choices are CASTp's already, there is no button to click.
    if (viewer_->widgets().contains("cavities.preset")) run("click cavities.preset\n");
    settle();
  }
  const CavityPage& page() { return *viewer_->state().cavities.page; }

  // The row of the cavity that holds most ligand atoms.
  std::optional<std::size_t> row_with_ligand(const std::string& name) {
    const BallReferences& references = *page().rows.lines->atoms;
    const Molecule& molecule = references.molecule();
    std::optional<std::size_t> best;
    std::uint32_t most = 0;
    for (std::size_t row = 0; row < page().rows.size(); ++row) {
      for (const std::uint32_t n : page().rows.contents->of[page().rows.table().order[row]]) {
        const ContainedResidue& residue = page().rows.contents->residues[n];
        if (molecule.text(molecule.atoms[residue.atom].residue_name) != name) continue;
        if (residue.inside > std::exchange(most, std::max(most, residue.inside))) best = row;
      }
    }
    return best;
  }
  void choose(std::size_t row) {
    run("click cavities.row." + std::to_string(row + 1) + " 0.2\n");
    settle();
  }
  Layer layer_named(const std::string& id) {
    for (const auto& layer : viewer_->state().layers) {
      if (layer->id == id) return *layer;
    }
    return {};
  }
  Layer held() { return layer_named("cavities.held"); }

  Image saved(const std::string& name) {
    run("file.save_picture \"" + (folder_ / name).string() + "\" 480 320 none\nwait-idle\n");
    return pixels_of(bytes(name));
  }
  Image first_frame(const std::string& name) {
    run("file.record \"" + (folder_ / (name + "-%d.png")).string() +
        "\" 180:2 480 320 none\nwait-idle\n");
    return pixels_of(bytes(name + "-1.png"));
  }
  // With the cavity's contents, without them, and without the cavity.
  struct Pictures {
    Image whole, without_held, without_cavity;
  };
  struct Taken {
    Pictures window, saved;
  };
  Taken taken() {
    Taken pictures;
    const auto take = [&](Image Pictures::*which) {
      pictures.window.*which = picture();
      pictures.saved.*which = saved("saved.png");
    };
    take(&Pictures::whole);
    viewer_->state().settings.display.beside = {false, false, false, false};
    settle();
    take(&Pictures::without_held);
    viewer_->state().cavities.page->parts.surfaces = false;
    settle();
    take(&Pictures::without_cavity);
    return pictures;
  }

  static bool differs(const Image& a, const Image& b, std::size_t pixel) {
    for (std::size_t k = 4 * pixel; k < 4 * pixel + 3; ++k) {
      if (std::abs(a.rgba[k] - b.rgba[k]) > 12) return true;
    }
    return false;
  }
  // Pure colour of an element under any light, unmixed with others.
  static bool has_element_colour(const Image& image, std::size_t pixel) {
    const std::uint8_t* p = &image.rgba[4 * pixel];
    const double r = p[0], g = p[1], b = p[2], length = std::sqrt(r * r + g * g + b * b);
    if (length < 60) return false;
    for (const Element element : {6, 7, 8, 12, 15, 16, 20, 26, 30}) {
      const Rgb8 c = element_colour(element);
      const double size = std::sqrt(double(c.r) * c.r + double(c.g) * c.g + double(c.b) * c.b);
      if ((r * c.r + g * c.g + b * c.b) / (length * size) > 0.995) return true;
    }
    return false;
  }

  // Counts pixels of the contents within the cavity's outline, and pixels of the cavity. A good
  // part of the cavity must stay visible.
  struct Seen {
    int held = 0, in_its_colour = 0, in_cavity = 0, cavity = 0;
  };
  static Seen seen_in(const Pictures& pictures) {
    Seen seen;
    const std::size_t pixels = pictures.whole.rgba.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
      const bool cavity = differs(pictures.without_held, pictures.without_cavity, i);
      seen.cavity += cavity;
      if (!differs(pictures.whole, pictures.without_held, i)) continue;
      ++seen.held;
      seen.in_its_colour += has_element_colour(pictures.whole, i);
      seen.in_cavity += cavity;
    }
    return seen;
  }
  static void expect_seen(const Pictures& pictures, double least_share_inside,
                          const std::string& where) {
    const Seen seen = seen_in(pictures);
    const int pixels = pictures.whole.width * pictures.whole.height;
    EXPECT_GT(seen.cavity, pixels / 100) << where;
    EXPECT_GT(seen.held, pixels / 200) << where;
    // The other pixels are rims, lights, and partly other things.
    EXPECT_GT(seen.in_its_colour, 0.55 * seen.held) << where;
    EXPECT_GT(seen.in_cavity, least_share_inside * seen.held) << where;
  }
  void expect_seen_in_pictures(double least_share_inside) {
    const Taken pictures = taken();
    expect_seen(pictures.window, least_share_inside, "window");
    expect_seen(pictures.saved, least_share_inside, "saved picture");
  }
};

fs::path haemoglobin() {
  return fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz";
}

TEST_F(CavityPictureTest, AHaemIsSeenInItsPocket) {
  show_as_at_the_start();
  open_cavities(haemoglobin());
  const auto row = row_with_ligand("HEM");
  ASSERT_TRUE(row);
  choose(*row);
  EXPECT_EQ(held().atoms.size() % 43, 0u) << "whole haems";
  EXPECT_GE(held().atoms.size(), 43u);
  expect_seen_in_pictures(0.5);
}

// ATP in protein kinase A, and inhibitors of HSP90 and of a collagenase.
TEST_F(CavityPictureTest, LigandsOfOtherProteinsAreSeenInTheirPockets) {
  ALPHASCOPE_NEED_TEST_DATA();
  const struct {
    const char *file, *ligand;
  } cases[] = {{"cavities/fpocket/1atp.pdb.gz", "ATP"},
               {"cavities/fpocket/1uyd.pdb.gz", "PU8"},
               {"cavities/p2rank/1fbl.pdb.gz", "HTA"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.file);
    show_as_at_the_start();
    open_cavities(test_data_folder() / c.file);
    viewer_->state().cavities.page->parts.surfaces = true;  // off for the last picture
    const auto row = row_with_ligand(c.ligand);
    ASSERT_TRUE(row);
    choose(*row);
    expect_seen_in_pictures(0.5);
  }
}

// Panels are drawn in every frame, as for a user. They describe what is drawn of a cavity.
class CavityFrameTest : public CavityPictureTest {
 protected:
  CavityFrameTest() : CavityPictureTest(false) {}
};

TEST_F(CavityFrameTest, AFrameOfARecordingIsTheSavedPicture) {
  open_cavities(haemoglobin());
  choose(*row_with_ligand("HEM"));
  EXPECT_FALSE(held().atoms.empty());
  const Image picture = saved("picture.png"), frame = first_frame("frame");
  int others = 0;  // up to rounding
  for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i) others += differs(frame, picture, i);
  EXPECT_LT(others, picture.width * picture.height / 500);
}

// A ligand kept in the body fills its pocket. It is shown where it lines the remaining cavity.
TEST_F(CavityPictureTest, ALigandOfTheBodyIsShownWhereItLinesACavity) {
  run("open " + haemoglobin().string() + "\nwait-idle\nclick bottom.cavities\n");
  settle();
  const Molecule& molecule = page().rows.lines->atoms->molecule();
  for (std::size_t row = 0; row < 12; ++row) {
    choose(row);
    std::size_t lining = 0;
    for (const Ref& ref : viewer_->state().settings.selection.items.items()) {
      lining += molecule.atoms[std::get<AtomRef>(ref).atom].kind == ResidueKind::ligand;
    }
    EXPECT_EQ(lining > 0, !held().atoms.empty()) << row;
    for (const LayerAtom& atom : held().atoms) {
      EXPECT_EQ(molecule.atoms[atom.atom].kind, ResidueKind::ligand);
    }
  }
}

TEST_F(CavityPictureTest, WhatIsNotDrawnBesideTheBodyIsNotDrawnInACavity) {
  open_cavities(haemoglobin());
  choose(*row_with_ligand("HEM"));
  EXPECT_FALSE(held().atoms.empty());
  run("atoms.hide resn HEM\n");
  settle();
  EXPECT_TRUE(held().atoms.empty());
  run("edit.undo\n");
  settle();
  EXPECT_FALSE(held().atoms.empty());
  viewer_->state().settings.display.beside.ligands = false;
  settle();
  EXPECT_TRUE(held().atoms.empty());
}

TEST_F(CavityPictureTest, TheMouseNamesALigandThroughItsCavity) {
  open_cavities(haemoglobin());
  choose(*row_with_ligand("HEM"));
  const WidgetRect view = viewer_->widgets().at("view");
  int named = 0;
  for (float x = 0.3f; x < 0.7f; x += 0.05f) {
    for (float y = 0.3f; y < 0.7f; y += 0.05f) {
      ScriptedInput input;
      input.x = view.x0 + x * (view.x1 - view.x0);
      input.y = view.y0 + y * (view.y1 - view.y0);
      viewer_->step(&input);
      viewer_->step(&input);
      named += viewer_->state().viewport.under_mouse_line.find("HEM") != std::string::npos;
    }
  }
  EXPECT_GE(named, 3);
}

// Pale balls lie before the bodies, and these are found nevertheless.
TEST_F(CavityPictureTest, ACavityHasItsNameUnderTheMouse) {
  open_cavities(haemoglobin());
  std::vector<Ref> sinks;
  for (const std::size_t row : {0, 1}) {
    choose(row);
    sinks.emplace_back(viewer_->state().cavities.chosen.at(0));
  }
  viewer_->state().settings.selection.cavities = RefSet(sinks);
  settle();
  ASSERT_EQ(page().selected_rows, (std::vector<std::size_t>{0, 1}));
  run("click bottom.structure\nframes 3\nclick structure.cavities\n");
  settle();
  std::map<std::string, std::size_t> seen;  // rows of cavities by their place in the view
  const auto look = [&] {
    seen.clear();
    for (int x = 4; x < 17; x += 2) {
      for (int y = 4; y < 17; y += 2) {
        const std::string place = std::to_string(0.05 * x) + " " + std::to_string(0.05 * y);
        run("move view " + place + "\nframes 2\n");
        const auto row = viewer_->state().cavities.under_mouse;
        if (!row) continue;
        seen[place] = *row;
        EXPECT_EQ(viewer_->state().viewport.under_mouse, cavity_title(page(), *row));
      }
    }
  };
  look();
  const auto among_pale_balls = seen;
  viewer_->state().settings.display.balls = viewer_->state().settings.display.tetrahedra = false;
  settle();
  look();
  EXPECT_EQ(among_pale_balls, seen);
  std::string place_of_second;
  for (const auto& [place, row] : seen) {
    if (row == 1) place_of_second = place;
  }
  ASSERT_FALSE(place_of_second.empty());
  EXPECT_TRUE(cavity_title(page(), 1).starts_with("Cavity 2  ·  pocket  ·  "));
  ASSERT_EQ(viewer_->state().window.page, "structure");
  run("move view " + place_of_second + "\nframes 3\nclick view " + place_of_second +
      "\nframes 3\n");
  EXPECT_EQ(viewer_->state().window.page, "cavities");
  EXPECT_EQ(page().selected_rows, (std::vector<std::size_t>{0, 1})) << "a click chooses no other";
}

TEST_F(CavityPictureTest, ARowUnderTheMouseIsMarkedInThePicture) {
  open_cavities(haemoglobin());
  const auto marked = [&]() -> std::string {
    for (const auto& layer : viewer_->state().layers) {
      if (layer->id == "cavities.hovered") return layer->labels.at(0).text;
    }
    return "";
  };
  EXPECT_EQ(marked(), "");
  run("move cavities.row.3 0.2\nframes 3\n");
  EXPECT_EQ(marked(), "3");
  run("move cavities.row.2 0.2\nframes 3\n");
  EXPECT_EQ(marked(), "2");
  run("move status.memory\nframes 3\n");
  EXPECT_EQ(marked(), "");
  run("click bottom.structure\nframes 3\nclick structure.cavities\n");
  settle();
  run("move structure.cavity.2\nframes 3\n");
  EXPECT_EQ(marked(), "2");
}

TEST_F(CavityPictureTest, OpacityIsASettingOfThePage) {
  open_cavities(haemoglobin());
  choose(*row_with_ligand("HEM"));
  const Image usual = picture();
  run("view.cavity_opacity 1\n");
  const Image opaque = picture();
  EXPECT_GT(differing_pixels(usual, opaque), 2000);
  run("edit.undo\n");
  EXPECT_EQ(viewer_->state().settings.display.cavity_opacity, DisplaySettings().cavity_opacity);
  run("click cavities.draw\nframes 3\n");
  EXPECT_TRUE(viewer_->widgets().contains("cavities.draw.opacity"));
  run("key esc\n");
}

TEST_F(CavityPictureTest, OpacityThatIsNotSeenSaysSo) {
  open_cavities(haemoglobin());
  EXPECT_FALSE(viewer_->widgets().contains("display.ball_opacity.faded"));
  choose(*row_with_ligand("HEM"));
  EXPECT_TRUE(viewer_->widgets().contains("display.ball_opacity.faded"));
  EXPECT_TRUE(viewer_->widgets().contains("display.complex_opacity.faded"));
  EXPECT_TRUE(viewer_->widgets().contains("objects.faded"));
  viewer_->state().settings.display.complex_opacity = 0.1f;
  settle();
  EXPECT_FALSE(viewer_->widgets().contains("display.complex_opacity.faded"))
      << "it is as it is set";
  EXPECT_TRUE(viewer_->widgets().contains("objects.faded")) << "the balls are faded";
  viewer_->state().settings.display.balls = false;
  settle();
  EXPECT_FALSE(viewer_->widgets().contains("objects.faded"));
  run("view.cartoon on\n");
  settle();
  EXPECT_TRUE(viewer_->widgets().contains("objects.faded")) << "the cartoon is faded";
  run("click cavities.draw\nframes 3\nclick cavities.draw.fade\nkey esc\n");
  settle();
  EXPECT_FALSE(viewer_->widgets().contains("display.ball_opacity.faded"));
  EXPECT_FALSE(viewer_->widgets().contains("objects.faded"));
}

// The lining is drawn as sticks whether or not the rest is pale. Beside opaque balls the contents
// stay where they are.
TEST_F(CavityPictureTest, TheLiningIsDrawnWithoutFadingTheRest) {
  open_cavities(haemoglobin());
  choose(*row_with_ligand("HEM"));
  ASSERT_TRUE(layer_named("cavities.lining").objects);
  run("click cavities.draw\nframes 3\nclick cavities.draw.fade\nkey esc\n");
  settle();
  ASSERT_FALSE(page().fades_rest);
  const Layer lining = layer_named("cavities.lining");
  ASSERT_TRUE(lining.objects);
  EXPECT_FALSE(lining.objects->of.at(0).atoms.empty());
  EXPECT_TRUE(held().atoms.empty());
  run("view.balls off\nview.tetrahedra off\n");
  settle();
  EXPECT_FALSE(held().atoms.empty()) << "no body hides them";
}

// The selected lining is marked by rims only. Whole green balls would hide the cavity.
TEST_F(CavityPictureTest, TheLiningIsMarkedByOutlines) {
  open_cavities(haemoglobin());
  choose(*row_with_ligand("HEM"));
  const auto green = [](const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      count += image.rgba[i + 1] > 150 && image.rgba[i + 1] > 2 * image.rgba[i] &&
               image.rgba[i + 1] > 2 * image.rgba[i + 2];
    }
    return count;
  };
  viewer_->state().settings.display.ball_scale = 0.5f;
  const int outlines = green(picture());
  const RefSet lining = viewer_->state().settings.selection.items;
  viewer_->state().settings.selection.clear();
  viewer_->state().settings.selection.items = lining;  // as a user selects atoms
  settle();
  const int balls = green(picture());
  EXPECT_GT(outlines, 200);
  EXPECT_LT(outlines, balls / 2);
}

TEST_F(CavityPictureTest, TheLiningFollowsTheSolventRadius) {
  open_cavities(haemoglobin());
  choose(*row_with_ligand("HEM"));
  const auto lining = [this] {
    std::vector<Ref> refs;
    for (const std::size_t row : page().selected_rows) {
      for (const BallIndex ball : page().rows.table().measure(row).lining) {
        refs.emplace_back(page().rows.lines->atoms->atom(ball));
      }
    }
    return RefSet(refs);
  };
  const RefSet before = viewer_->state().settings.selection.items;
  EXPECT_EQ(before, lining());
  for (const char* page_shown : {"cavities", "timings"}) {
    SCOPED_TRACE(page_shown);
    run(std::string("click bottom.") + page_shown + "\nframes 2\nsolvent.set 1.6\n");
    settle();
    ASSERT_EQ(page().rows.table().question.alpha_angstrom2, 0);
    EXPECT_NE(viewer_->state().settings.selection.items, before);
    EXPECT_EQ(viewer_->state().settings.selection.items, lining());
    EXPECT_EQ(viewer_->state().undo_text, "solvent radius and selection") << "one entry";
    run("edit.undo\n");
    settle();
    EXPECT_EQ(viewer_->state().settings.request.solvent_radius_angstrom, 1.4);
    EXPECT_EQ(viewer_->state().settings.selection.items, before);
    EXPECT_FALSE(viewer_->state().redo_text.empty());
  }
  // The user's own selection stays.
  run("select.add A:VAL 1:N\nsolvent.set 1.6\n");
  settle();
  EXPECT_EQ(viewer_->state().settings.selection.items.size(), before.size() + 1);
}

}  // namespace
}  // namespace alphascope::testing
