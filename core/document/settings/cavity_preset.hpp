// SPDX-License-Identifier: GPL-3.0-or-later
// Options for cavities that are comparable with CASTp's, and differences of the present options
// from them.
#pragma once

#include <string>
#include <vector>

namespace alphascope {

struct BallOptions;
struct OpenOptions;
struct Request;
struct SelectionReport;

// Radius of a water molecule, Å.
inline constexpr double kCavitySolventAngstrom = 1.4;

// Options of the body: all chains of model 1 with modified residues, the best alternative
// locations, and the radii of CASTp's output. It has no hydrogens, waters, ions or ligands. A file
// with radii of its own keeps them. The assembly is not changed.
BallOptions cavity_body(const BallOptions& options, bool file_has_radii);

// Sets the options of that body, this solvent radius and alpha 0.
void use_cavity_preset(OpenOptions& open, Request& request, bool file_has_radii);

// Each choice that differs from CASTp's, as a few words: "ligands are in the body". Empty: the
// numbers are comparable with CASTp's. `report` is that of the balls.
std::vector<std::string> differences_from_castp(const BallOptions& balls,
                                                const SelectionReport& report,
                                                const Request& request);

// A further such difference, for tables.
inline constexpr const char* kNetworksAreSplit = "networks are listed as their parts";

}  // namespace alphascope
