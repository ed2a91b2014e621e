// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `cavities`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cavities/shape_outputs.hpp"
#include "app/cli/input_options.hpp"
#include "core/cavity/cavities.hpp"
#include "core/document/settings/request.hpp"
#include "core/predicates/flow_predicate.hpp"

namespace alphascope::cli {

struct CavitiesOptions {
  InputFiles files;
  InputOptions input;
  BodyOptions body;
  Request request;  // alpha and threads; the engine is unused
  // Each radii set is combined with each solvent radius (Å). Several combinations are compared.
  // input.radii is unused.
  std::vector<std::string> radii{"auto"};
  std::vector<double> solvents;
  OutsideRule rule = OutsideRule::castp;
  FlowTies ties = FlowTies::perturbed;
  bool no_exact_volumes = false;   // leave out exact volumes
  bool split_networks = false;     // list networks as their parts
  bool no_network_radius = false;  // do not compute where networks come apart
  int shown = 20;                  // number of printed rows
  // Least SA volume of listed cavities. Smaller ones are only counted.
  std::optional<double> min_volume_angstrom3;
  std::string json, csv, lives;
  ShapeOptions shapes;
  bool compares() const { return radii.size() * solvents.size() > 1; }
};

}  // namespace alphascope::cli
