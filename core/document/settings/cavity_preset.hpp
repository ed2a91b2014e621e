// How atoms become balls for cavities that compare with CASTp's, and what was chosen instead.
#pragma once

#include <string>
#include <vector>

#include "core/document/settings/open_options.hpp"
#include "core/document/settings/request.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope {

// The radius of a water molecule, Å.
inline constexpr double kCavitySolventAngstrom = 1.4;

// The body: all chains of model 1 with their modified residues, the best alternative locations, the
// radii behind CASTp's output. No hydrogens, waters, ions, ligands. A file that brings radii of its
// own keeps them. The choice of an assembly stays.
BallOptions cavity_body(const BallOptions& options, bool file_has_radii);

// Of that body, with this solvent radius and alpha 0.
void use_cavity_preset(OpenOptions& open, Request& request, bool file_has_radii);

// Each choice that CASTp does not make, as a few words: "ligands are in the body". None: the
// numbers compare with CASTp's. `report`: of the balls.
std::vector<std::string> differences_from_castp(const BallOptions& balls,
                                                const SelectionReport& report,
                                                const Request& request);

// One more of these choices, of a table.
inline constexpr const char* kNetworksAreSplit = "networks are listed as their parts";

}  // namespace alphascope
