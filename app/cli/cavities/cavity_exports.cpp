// SPDX-License-Identifier: GPL-3.0-or-later
// Writes lives, spheres, surfaces and scripts of cavities.
#include "app/cli/cavities/cavity_exports.hpp"

#include "app/cli/cavities/cavity_records.hpp"
#include "app/cli/failure.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_bars.hpp"
#include "core/document/cavities/cavity_export.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {

namespace {

std::string file_of(const CavitiesOptions& options, bool wants_one) {
  const bool many = options.files.many() || each_model(options.input) || options.compares();
  if (wants_one && many) {
    throw UsageError(
        "--lives, --spheres, --surface and --script need one file, one model, one radii set and "
        "one solvent radius.");
  }
  return options.files.named.empty() ? std::string() : options.files.named.front();
}

}  // namespace

CavityExports::CavityExports(const CavitiesOptions& options, Outputs& outputs)
    : shapes_(options.shapes, file_of(options, options.shapes.any() || !options.lives.empty()),
              outputs),
      lives_(outputs.add("--lives", options.lives, Outputs::kCsv)) {}

void CavityExports::write(const CavityAnswer& answer, const RunContext& context) {
  if (lives_ != nullptr) write_lives(answer);
  if (shapes_.spheres() != nullptr) {
    WorkThreads threads(answer.request.threads);
    threads.run([&] {
      write_cavity_spheres({answer, noted_header(answer)}, *shapes_.spheres(), context.cancel);
    });
  }
  if (shapes_.surface() != nullptr) {
    write_cavity_surfaces({answer, noted_header(answer)}, shapes_.surface_is_glb(),
                          *shapes_.surface());
  }
  if (shapes_.script() != nullptr) write_script(answer);
}

void CavityExports::write_lives(const CavityAnswer& answer) {
  std::vector<std::string> comments;
  for (const auto& [key, value] : noted_header(answer)) {
    if (!value.empty()) comments.push_back(key + ": " + value);
  }
  const CavityGround& ground = *answer.table().ground;
  const CavityBars bars = longest_bars(*answer.lives, ground.balls->lattice, -kMaxAlphaAngstrom2,
                                       answer.lives->sinks.size());
  lives_->write(bars_csv(bars.longest, *ground.triangulation, *answer.atoms, comments));
}

void CavityExports::write_script(const CavityAnswer& answer) {
  try {
    shapes_.script()->write(cavity_script({answer, noted_header(answer)}, shapes_.script_format(),
                                          shapes_.script_files()));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace alphascope::cli
