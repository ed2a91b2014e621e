// The open molecule as the panels show it, and the panels' choices as the session takes them. Pure
// functions: no window, no GL.
#pragma once

#include <vector>

#include "app/session/session.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

MoleculeInfo describe_molecule(const OpenedMolecule& opened);

// Elements with their radii, grown by the solvent radius (Å) and alpha (Å²), most frequent first.
std::vector<GrownRadius> grown_radii(const PreparedBalls& prepared, const Request& controls);

// The sets that the window offers, in the order of ViewState::radii_sets.
std::vector<RadiiSet> offered_radii_sets();
std::vector<RadiiSetEntry> radii_set_entries(const std::vector<RadiiSet>& radii_sets);

OpenOptions to_open_options(const SelectionControls& controls,
                            const std::vector<RadiiSet>& radii_sets);
SelectionControls to_controls(const OpenOptions& options, const std::vector<RadiiSet>& radii_sets);

// Why an expression cannot be understood; an empty text when it can.
ExpressionError check_expression(const std::string& expression);

}  // namespace alphascope
