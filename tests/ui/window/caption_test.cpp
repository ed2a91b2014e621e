// SPDX-License-Identifier: GPL-3.0-or-later
// Tests texts of captions, and captions in saved pictures.
#include "ui/caption.hpp"

#include <gtest/gtest.h>

#include "core/document/store/inputs.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/scene/picture/draw_marks.hpp"

namespace alphascope::testing {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
  return text;
}

TEST(Caption, SaysEachPartWithItsUnit) {
  EngineAnswer answer;
  answer.request.alpha_angstrom2 = -0.25;
  answer.complex.vertices.simplices.resize(1203);
  answer.complex.edges.simplices.resize(2);
  answer.complex.tetrahedra.simplices.resize(1);
  answer.complex.engine = {"dual-edge engine", "CPU, 2 threads", "dual edge clipping"};
  answer.complex.hash = 0xabc;
  Molecule molecule;
  molecule.source = "/data/1crn.pdb";
  const auto words = [&](const char* parts) {
    return joined(caption_words(answer, molecule, "bondi", read_caption_parts(parts)));
  };
  EXPECT_EQ(words("usual"),
            "1crn.pdb|α = −0.25 Å²|1,203 vertices, 2 edges, 0 triangles, 1 tetrahedron");
  answer.request.solvent_radius_angstrom = 1.4;
  EXPECT_EQ(words("solvent,radii,engine,hash"),
            "solvent 1.4 Å|radii: bondi|dual-edge engine on CPU, 2 threads|hash 0000000000000abc");
  answer.complex.tetrahedra_only = true;
  EXPECT_EQ(words("counts"), "1 tetrahedron");
  EXPECT_EQ(words("none"), "");
  Alpha fine;
  ASSERT_EQ(Alpha::read("-1.000002652010249999", fine), Alpha::Reading::ok);
  answer.request.alpha_angstrom2 = fine;
  EXPECT_EQ(words("alpha"), "α = −1.000002652010249999 Å²");
  answer.request.alpha_angstrom2 = 1e24;
  EXPECT_EQ(words("alpha"), "α = 10²⁴ Å²");
}

class CaptionInWindow : public ViewerTest {
 protected:
  // Counts pixels with the text's colour in the upper eighth of the picture.
  int marked(const fs::path& file) const {
    const Image image = pixels_of(file);
    const Colour ink = mark_colours(viewer_->state().window.theme).mark;
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size() / 8; i += 4) {
      count += std::abs(image.rgba[i] - ink.r * 255) < 2 &&
               std::abs(image.rgba[i + 1] - ink.g * 255) < 2 &&
               std::abs(image.rgba[i + 2] - ink.b * 255) < 2;
    }
    return count;
  }
};

TEST_F(CaptionInWindow, IsInTheSavedPictureAndAsTheCommandLineDrawsIt) {
  open_crambin();
  run("alpha.set 1.4\nwait-idle\nfile.save_picture " + (folder_ / "with.png").string() +
      " 960 600 all\nwait-idle\nfile.save_picture " + (folder_ / "without.png").string() +
      " 960 600 none\nwait-idle\n");
  EXPECT_GT(marked(folder_ / "with.png"), 100);
  EXPECT_EQ(marked(folder_ / "without.png"), 0);
  const auto drawn = [&](const char* parts) {
    const std::string command = std::string(ALPHASCOPE_CLI) + " screenshot " + crambin().string() +
                                " --alpha 1.4 --caption " + parts + " --size 960x600 -o " +
                                (folder_ / "cli.png").string() + " > /dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return marked(folder_ / "cli.png");
  };
  EXPECT_EQ(drawn("file,alpha,solvent,radii,counts,engine,hash"), marked(folder_ / "with.png"));
  EXPECT_EQ(drawn("none"), 0);
}

TEST_F(CaptionInWindow, IsChosenInTheDialog) {
  open_crambin();
  run("file.save_picture\nframes 2\nclick save.caption\nframes 2\n");
  PictureOptions& picture = viewer_->state().window.picture;
  EXPECT_EQ(picture.caption, usual_caption());
  run("click save.caption_hash\nclick save.caption_file\nframes 2\n");
  EXPECT_EQ(caption_parts_text(picture.caption), "alpha,solvent,counts,hash");
  run("click save.caption\nframes 2\n");
  EXPECT_FALSE(picture.caption.any());
}

TEST_F(CaptionInWindow, AWrongPartIsRefused) {
  open_crambin();
  const Outcome outcome = viewer_->commands().run_line(
      "file.save_picture \"" + (folder_ / "no.png").string() + "\" 64 64 colour");
  EXPECT_EQ(outcome.state, Outcome::State::refused);
  EXPECT_NE(outcome.why.find("\"colour\" is not a part of a caption"), std::string::npos)
      << outcome.why;
}

}  // namespace
}  // namespace alphascope::testing
