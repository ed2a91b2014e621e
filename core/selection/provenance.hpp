// Where a set of balls comes from, as short texts for whatever is written with it: headers of
// files, columns of tables, the text in a picture.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/selection/prepare_balls.hpp"

namespace alphascope {

// Key and value, in this order: file, sha256, format, model, assembly, options,
// selection_expression, selection, radii, lattice_unit_angstrom, rounding_angstrom,
// radius_rounding_angstrom. Every key is always there; what does not apply is empty. Values are
// printable, also the name of a file that is not.
using Provenance = std::vector<std::pair<std::string, std::string>>;
Provenance provenance(const Molecule& molecule, const BallOptions& options,
                      const SelectionReport& report);

// "0.001", the unit in Å with all its digits.
std::string lattice_unit_text(const Lattice& lattice);

// "2", counted from 1 as the command line counts; "joined" for kAllModels.
std::string model_text(int model);

// What was chosen otherwise than by default, in the command line's words: "--altlocs all --waters".
// Model, assembly, selection expression and radii set are not repeated here.
std::string options_text(const BallOptions& options);

}  // namespace alphascope
