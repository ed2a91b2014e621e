// SPDX-License-Identifier: GPL-3.0-or-later
// What alphascope-cli info says on secondary structure and bonds.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/cli/command.hpp"
#include "app/cli/report_json.hpp"
#include "core/molecule/secondary_structure.hpp"
#include "core/secondary/secondary.hpp"

namespace alphascope {
struct ListedResidues;
}

namespace alphascope::cli {

// Of each model that is used: one, or all where they are joined.
std::vector<SecondaryModel> secondary_of(const Input& input);

// The kind of each residue by the index of its CA.
using SecondaryKinds = std::map<std::size_t, SecondaryStructure>;
SecondaryKinds kinds_by_atom(const std::vector<SecondaryModel>& models);
// The identifier for a residue that is listed by itself; empty without CA.
std::string secondary_of(const SecondaryKinds& kinds, const ListedResidues& residue);

// Lines "secondary   …" and "bonds       …". Empty where models are joined, since atoms of several
// models are not bonded; then the JSON has no such keys either.
std::string structure_text(const Input& input);
void add_structure_json(const Input& input, const std::vector<SecondaryModel>& secondary,
                        Json& json);

}  // namespace alphascope::cli
