// Options that several commands have. For the sources of the command table.
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

// What is read, without the two kinds of atoms that commands treat differently.
Options input_but_ligands(InputOptions& input);
// All of what is read.
Options input(InputOptions& input);
std::string radii_choices();

// The help of an argument that is a molecule.
std::string file_text();

// The body whose cavities are looked for.
Options body(InputOptions& input, BodyOptions& body);

Option one_file(InputOptions& input, bool must_be = true);
Options many_files(InputFiles& files);
// Throws std::invalid_argument.
void require_files(const InputFiles& files);

Option alpha(Request& request);
Option alphas(std::vector<Alpha>& alphas, const char* text);
// With `text` and the default that it has; exact, so with at most 18 digits behind the point.
Option alpha_option(const char* text, Alpha& target);
// As it is typed; throws std::invalid_argument that says what is wrong with it.
Alpha alpha_in(const std::string& value);
// The switches of the tuple engine that change its work on the CPU.
Options tuple_work(TupleOptions& tuples);
// Solvent radius, engine and its switches; `threads`: and how many.
Options engine(Request& request, bool threads);
// Switches of the tuple engines want one of them. Throws std::invalid_argument.
void require_tuple_engine(const Request& request);

Option output(const char* name, const char* text, std::string& path);

}  // namespace alphascope::cli
