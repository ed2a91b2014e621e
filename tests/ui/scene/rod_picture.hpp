// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the balls of molecule_fixture.hpp as the command line would make them: half of the
// balls red, half blue, without lines, haze and legend.
#pragma once

#include <filesystem>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "tests/ui/molecule_fixture.hpp"
#include "ui/scene/picture/picture_maker.hpp"

namespace alphascope::testing {

// A molecule of carbon atoms with these balls.
inline PicturedMolecule carbons(const std::shared_ptr<const BallSet>& balls) {
  Molecule molecule;
  Atom carbon;
  carbon.element = 6;
  molecule.atoms.assign(balls->size(), carbon);
  PreparedBalls prepared;
  prepared.balls = balls;
  prepared.atom_of_ball.resize(balls->size());
  std::iota(prepared.atom_of_ball.begin(), prepared.atom_of_ball.end(), 0u);
  return {std::make_shared<const Molecule>(std::move(molecule)),
          std::make_shared<const PreparedBalls>(std::move(prepared)), nullptr};
}

// Settings for pictures of so many balls.
inline PictureSettings plain_settings(std::size_t balls, int width, int height) {
  PictureSettings settings;
  settings.options = {.width = width, .height = height, .legend = false};
  DisplaySettings& display = settings.display;
  display.depth_cue = display.outlines = display.face_lines = 0;
  display.samples = 4;
  const auto count = static_cast<std::uint32_t>(balls);
  settings.appearance.colours = {{kRed, AtomSet({{0, 0, count / 2 - 1}})},
                                 {kBlue, AtomSet({{0, count / 2, count - 1}})}};
  return settings;
}

// Writes the picture into a file, and returns sentences on what it lacks.
inline std::string draw_carbons(const std::shared_ptr<const BallSet>& balls,
                                const AlphaComplex& complex, const PictureSettings& settings,
                                const std::filesystem::path& path, const RunContext& context = {}) {
  auto answer = std::make_shared<EngineAnswer>();
  answer->balls = balls;
  answer->complex = complex;
  PictureMaker maker(carbons(balls), settings);
  return render_picture(maker.make(answer, {}, context), path, context);
}

}  // namespace alphascope::testing
