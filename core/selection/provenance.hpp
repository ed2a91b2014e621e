// SPDX-License-Identifier: GPL-3.0-or-later
// The provenance of a set of balls as short texts. They are written with results: in headers of
// files, columns of tables, and pictures.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/selection/prepare_balls.hpp"

namespace alphascope {

// Keys and values, in this order: file, fetched, sha256, format, model, assembly, options,
// selection_expression, selection, radii, lattice_unit_angstrom, rounding_angstrom,
// radius_rounding_angstrom. Every key is always there; its value is empty if it does not apply.
// Values are printable, even if a file's name is not.
using Provenance = std::vector<std::pair<std::string, std::string>>;
Provenance provenance(const Molecule& molecule, const BallOptions& options,
                      const SelectionReport& report);

// The lattice unit in Å with all its digits: "0.001".
std::string lattice_unit_text(const Lattice& lattice);

// The number of a model, counted from 1 as on the command line: "2". "joined" for kAllModels.
std::string model_text(int model);

// The options that differ from the defaults, in the command line's words: "--altlocs all --waters".
// Model, assembly, selection expression and radii set are not included.
std::string options_text(const BallOptions& options);

}  // namespace alphascope
