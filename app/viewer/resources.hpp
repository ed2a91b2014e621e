// Files that come with the program.
#pragma once

#include <vector>

#include "ui/panels/view_state.hpp"

namespace alphascope {

// Those that are there; empty when the program was moved without its resources.
std::vector<SampleMolecule> sample_files();

}  // namespace alphascope
