// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of options that several commands share.
#pragma once

#include <string>
#include <vector>

#include "app/cli/input_options.hpp"
#include "app/options/option_values.hpp"
#include "core/document/settings/request.hpp"
#include "core/geometry/lattice.hpp"

namespace alphascope::cli {

inline const NumberRange kAlphaRange{-kMaxAlphaAngstrom2, kMaxAlphaAngstrom2, "Å²"};
inline const NumberRange kSolventRange{0, 100, "Å"};
inline const NumberRange kThreadRange{0, 1024};

using Options = std::vector<Option>;

void append(Options& options, Options more);

// The input options without those for ligands and ions, for which commands have different defaults.
Options input_but_ligands(InputOptions& input);
// All input options.
Options input(InputOptions& input);
std::string radii_choices();

// The help of an argument that names a molecule.
std::string file_text();

// The options of the body in a search for cavities.
Options body(InputOptions& input, BodyOptions& body);

Option one_file(InputOptions& input, bool must_be = true);
Options many_files(InputFiles& files);
// Throws std::invalid_argument if no file is named.
void require_files(const InputFiles& files);

Option alpha(Request& request);
Option alphas(std::vector<Alpha>& alphas, const char* text);
// An option that sets an alpha exactly as typed, with at most 18 decimals. The default is the
// present value of `target`.
Option alpha_option(const char* text, Alpha& target);
// Reads alpha exactly as typed. Throws std::invalid_argument that says what is wrong.
Alpha alpha_in(const std::string& value);
// The switches of the tuple engine that change its work on the CPU.
Options tuple_work(TupleOptions& tuples);
// Options of solvent radius, engine and its switches. `threads`: also of the number of threads.
Options engine(Request& request, bool threads);
// Throws std::invalid_argument for switches of the tuple engines with another engine.
void require_tuple_engine(const Request& request);

Option output(const char* name, const char* text, std::string& path);

}  // namespace alphascope::cli
