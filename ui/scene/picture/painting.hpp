// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of all balls of a molecule by one paint. A painting is used again until something changes
// on which its colours depend. No VTK, so any thread may make one.
#pragma once

#include <memory>

#include "core/document/measures/paint_balls.hpp"
#include "core/document/store/answer.hpp"
#include "core/measure/engine_measures.hpp"
#include "core/run/cancel_token.hpp"
#include "core/secondary/secondary_once.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"

namespace alphascope {

// A molecule, its balls, and their geometry for drawing.
struct PicturedMolecule {
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const PreparedBalls> prepared;  // without solvent radius
  std::shared_ptr<const BallGeometry> geometry;   // of `prepared`, or empty: no ball is drawn
  std::shared_ptr<SecondaryOnce> secondary = std::make_shared<SecondaryOnce>();
};

struct PaintTask {
  std::shared_ptr<const PicturedMolecule> molecule;
  std::shared_ptr<const EngineAnswer> answer;  // null: there is no complex
  Paint paint;
};

struct Painting {
  Paint paint;
  std::shared_ptr<const PicturedMolecule> molecule;
  std::shared_ptr<const EngineAnswer> answer;     // null if the paint does not depend on it
  std::shared_ptr<const MeasuredUnion> measures;  // if the paint shows exposed areas; else null
  PaintedBalls balls;
};

// Returns `earlier`, which may be null, if its colours are the same. Throws as
// measure_on_calling_threads() does.
std::shared_ptr<const Painting> make_painting(const PaintTask& task,
                                              std::shared_ptr<const Painting> earlier,
                                              const RunContext& context);

}  // namespace alphascope
