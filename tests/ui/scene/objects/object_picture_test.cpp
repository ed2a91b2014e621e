// SPDX-License-Identifier: GPL-3.0-or-later
// Tests pictures of objects: baselines near and far on both themes, filled cuts, opacity.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "core/engine/engine.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/support/molecules.hpp"
#include "tests/ui/baseline.hpp"
#include "ui/scene/objects/object_mesh.hpp"
#include "ui/scene/scene.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

constexpr int kWidth = 400, kHeight = 320;

class ObjectPicture : public ::testing::Test {
 protected:
  // A bundled molecule, or another one by its whole path.
  void open(const std::filesystem::path& file) {
    pictured_.molecule = std::make_shared<const Molecule>(
        read_molecule(std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules" / file));
    pictured_.prepared = std::make_shared<const PreparedBalls>(prepare_balls(*pictured_.molecule));
    pictured_.geometry = std::make_shared<const BallGeometry>(*pictured_.prepared->balls);
    scene_.set_balls(pictured_.geometry,
                     std::vector<Rgb8>(pictured_.geometry->centres.size(), Rgb8{90, 160, 220}));
    style_.balls = false;
    style_.samples = 4;
    scene_.set_style(style_);
    scene_.reset_view();
  }
  void show(const std::string& objects) {
    std::vector<SceneObject> shown;
    for (const PicturedObject& o :
         build_objects(pictured_, facts_, read_objects(objects).objects, Appearance())) {
      shown.push_back({make_object_data(o.mesh), o.opacity});
    }
    scene_.set_objects(ObjectGroup::settings, std::move(shown));
  }
  // Places the camera `share` of the usual distance away from `target`, an atom of this name.
  void approach(const std::string& expression, double share) {
    scene_.apply_pending_reset(kWidth, kHeight);
    Viewpoint view = scene_.viewpoint();
    const auto atoms = atoms_of(*pictured_.molecule, named_set(*pictured_.molecule, expression));
    RealPoint middle;
    double count = 0;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      if (!atoms[i]) continue;
      middle = middle + position_angstrom(*pictured_.molecule, static_cast<std::uint32_t>(i));
      ++count;
    }
    middle = (1 / count) * middle;
    const auto& o = pictured_.geometry->origin;
    const std::array<double, 3> target{middle.x - o[0], middle.y - o[1], middle.z - o[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      const double away = view.position[k] - view.focal_point[k];
      view.focal_point[k] = target[k];
      view.position[k] = target[k] + share * away;
    }
    scene_.set_viewpoint(view);
  }
  Image drawn() { return scene_.grab(kWidth, kHeight, false); }

  EglContext context_;
  Scene scene_;
  SceneStyle style_;
  PicturedMolecule pictured_;
  FactsOnce facts_;
};

TEST_F(ObjectPicture, CartoonFarAndNear) {
  open("4hhb.pdb.gz");
  show("cartoon; sticks:ligand");
  testing::expect_like_baseline("objects/cartoon_far", drawn());
  approach("resn HEM and chain A", 0.3);
  testing::expect_like_baseline("objects/cartoon_near", drawn());
}

TEST_F(ObjectPicture, StrandsAndSticksOnLight) {
  open("1crn.pdb");
  style_.theme = Theme::light;
  style_.line_scale = 2;
  style_.outlines = 1.5F;
  style_.orthographic = true;
  scene_.set_style(style_);
  show("cartoon,secondary; balls_and_sticks,60%:sidechain");
  testing::expect_like_baseline("objects/strands_light", drawn());
}

TEST_F(ObjectPicture, BasesAreFilledFarAndNear) {
  ALPHASCOPE_NEED_TEST_DATA();
  open(testing::test_data_folder() / "ladder/1bna.pdb");
  show("cartoon");
  testing::expect_like_baseline("objects/bases_far", drawn());
  approach("resi 5-8 and chain A", 0.4);
  testing::expect_like_baseline("objects/bases_near", drawn());
}

TEST_F(ObjectPicture, CutsAreFilled) {
  open("4hhb.pdb.gz");
  show("cartoon,#ff8000; sticks:ligand");
  approach("resn HEM and chain A", 0.35);
  const ViewFrustum sight = scene_.sight();
  const auto& o = pictured_.geometry->origin;
  const RealPoint normal{sight.forward[0], sight.forward[1], sight.forward[2]};
  const Viewpoint view = scene_.viewpoint();
  Clip clip;
  clip.kind = Clip::Kind::plane;
  clip.flipped = true;  // keeps what lies behind the plane
  clip.normal = {normal.x, normal.y, normal.z};
  clip.position = dot(
      normal, {view.focal_point[0] + o[0], view.focal_point[1] + o[1], view.focal_point[2] + o[2]});
  style_.cut = Cut(clip, o);
  style_.ambient_occlusion = false;
  scene_.set_style(style_);
  const Image image = drawn();
  testing::expect_like_baseline("objects/cut", image);
  // Where the cut opens the ribbon, its colour is exact. A hollow ribbon would show shades only.
  std::size_t exact = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    exact += std::abs(image.rgba[i] - 255) <= 3 && std::abs(image.rgba[i + 1] - 128) <= 3 &&
             image.rgba[i + 2] <= 3;
  }
  EXPECT_GT(exact, 100u);
}

TEST_F(ObjectPicture, PointsAndOpacity) {
  open("1crn.pdb");
  show("points; cartoon,30%");
  testing::expect_like_baseline("objects/points", drawn());
  EXPECT_TRUE(scene_.draws_translucent());
  show("none");
  EXPECT_FALSE(scene_.draws_translucent());
}

}  // namespace
}  // namespace alphascope
