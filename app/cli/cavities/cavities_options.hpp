// What `cavities` is asked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cavities/shape_outputs.hpp"
#include "app/cli/input_options.hpp"
#include "core/cavity/cavities.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope::cli {

struct CavitiesOptions {
  InputFiles files;
  InputOptions input;
  BodyOptions body;
  Request request;  // alpha and threads; no engine is asked
  // Each set with each solvent radius (Å); several are compared. Not input.radii.
  std::vector<std::string> radii{"auto"};
  std::vector<double> solvents;
  OutsideRule rule = OutsideRule::castp;
  FlowTies ties = FlowTies::perturbed;
  bool no_clipped = false;                     // without exact volumes
  bool split_networks = false;                 // networks are listed as their parts
  bool no_network_radius = false;              // nobody asks where networks fall apart
  int shown = 20;                              // rows printed
  std::optional<double> min_volume_angstrom3;  // SA; smaller ones are counted, but not listed
  std::string json, csv, lives;
  ShapeOptions shapes;
  bool compares() const { return radii.size() * solvents.size() > 1; }
};

}  // namespace alphascope::cli
