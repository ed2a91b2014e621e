// SPDX-License-Identifier: GPL-3.0-or-later
// Parses REMARK 350 and makes assemblies.
#include "core/read/pdb/pdb_assembly.hpp"

#include <algorithm>

#include "core/geometry/lattice_alpha.hpp"
#include "core/read/decimal.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {

void PdbAssemblyRecords::take(std::string_view line, std::size_t line_number) {
  std::string_view text = trimmed(line.substr(std::min<std::size_t>(10, line.size())));
  const auto after = [&](std::string_view label) {
    const std::size_t at = text.find(label);
    return at == std::string_view::npos ? std::string_view()
                                        : trimmed(text.substr(at + label.size()));
  };
  if (text.starts_with("BIOMOLECULE:")) {
    begin_assemblies(after("BIOMOLECULE:"));
    chains_open_ = false;
  } else if (text.starts_with("BIOMT")) {
    chains_open_ = false;
    take_matrix_row(text, line_number);
  } else if (text.find("BIOLOGICAL UNIT:") != std::string_view::npos && !assemblies_.list.empty() &&
             assemblies_.list.back().details.empty()) {
    assemblies_.list.back().details = std::string(after("BIOLOGICAL UNIT:"));
  } else if (text.find("TO CHAINS:") != std::string_view::npos) {
    current().generators.emplace_back();
    chains_open_ = true;
    take_chains(after("TO CHAINS:"));
  } else if (chains_open_ && text.find("CHAINS:") != std::string_view::npos) {
    take_chains(after("CHAINS:"));
  }
}

// Takes "1, 2": the next lines describe each of these assemblies.
void PdbAssemblyRecords::begin_assemblies(std::string_view ids) {
  share_last();
  while (true) {
    const std::size_t comma = std::min(ids.find(','), ids.size());
    assemblies_.list.push_back({std::string(trimmed(ids.substr(0, comma))), "", {}});
    ids.remove_prefix(std::min(comma + 1, ids.size()));
    if (trimmed(ids).empty()) break;
    ++sharing_;
  }
}

// Copies the last assembly to those that were named together with it.
void PdbAssemblyRecords::share_last() {
  for (std::size_t k = 0; k < sharing_; ++k) {
    Assembly& other = assemblies_.list[assemblies_.list.size() - 2 - k];
    other.details = assemblies_.list.back().details;
    other.generators = assemblies_.list.back().generators;
  }
  sharing_ = 0;
}

// The assembly being read. Old files have one without a heading.
Assembly& PdbAssemblyRecords::current() {
  if (assemblies_.list.empty()) assemblies_.list.push_back({"1", "", {}});
  return assemblies_.list.back();
}

void PdbAssemblyRecords::take_chains(std::string_view list) {
  std::vector<std::string>& chains = current().generators.back().chains;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view chain = trimmed(list.substr(0, comma));
    if (chain == "NULL") {
      chains.emplace_back();  // the chain with an empty name
    } else if (!chain.empty()) {
      chains.emplace_back(chain);
    }
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
}

// Takes "BIOMT2   7  0.5 0.25 -0.1  33.78": row, number of the operator, three factors, translation
// (Å).
void PdbAssemblyRecords::take_matrix_row(std::string_view text, std::size_t line_number) {
  const std::string_view label = next_field(text);
  const std::string_view id = next_field(text);
  const bool in_turn = label.size() == 6 && label[5] == '1' + rows_ &&
                       (rows_ == 0 || operator_.id == id) && !current().generators.empty();
  bool good = in_turn;
  for (std::size_t j = 0; good && j < 4; ++j) {
    Decimal number;
    const std::string_view field = next_field(text);
    good = parse_decimal(field, number) == DecimalStatus::ok;
    if (good) operator_.rows[static_cast<std::size_t>(rows_)][j] = number.to_double();
    if (good && j < 3) operator_.digits = std::max(operator_.digits, printed_decimals(field));
  }
  if (!good) {
    if (bad_line_ == 0) bad_line_ = line_number;
    return;
  }
  operator_.id = std::string(id);
  if (rows_ == 0) operator_.line = line_number;
  if (++rows_ < 3) return;
  rows_ = 0;
  std::vector<std::vector<std::uint32_t>>& factors = current().generators.back().factors;
  if (factors.empty()) factors.emplace_back();
  factors[0].push_back(static_cast<std::uint32_t>(assemblies_.operators.size()));
  assemblies_.operators.push_back(operator_);
  operator_.digits = 0;
}

// Replaces "ALL" by all chains, unless a chain has that name.
void PdbAssemblyRecords::take_all_chains(const Molecule& molecule) {
  std::vector<std::string> chains;
  std::vector<bool> known(molecule.names.size(), false);
  for (const Atom& atom : molecule.atoms) {
    if (!known[atom.chain]) chains.emplace_back(molecule.text(atom.chain));
    known[atom.chain] = true;
  }
  if (std::find(chains.begin(), chains.end(), "ALL") != chains.end()) return;
  for (Assembly& assembly : assemblies_.list) {
    for (auto& generator : assembly.generators) {
      if (generator.chains.size() == 1 && generator.chains[0] == "ALL") generator.chains = chains;
    }
  }
}

void PdbAssemblyRecords::finish(Molecule& molecule) {
  if (bad_line_ != 0 || rows_ != 0) {
    refuse_assembly(molecule, "",
                    "REMARK 350 is damaged" +
                        (bad_line_ ? " in line " + std::to_string(bad_line_) : std::string()) +
                        ". Correct it, or fetch the file again");
    return;
  }
  share_last();
  take_all_chains(molecule);
  std::erase_if(assemblies_.list, [](const Assembly& a) { return a.generators.empty(); });
  molecule.assemblies = std::move(assemblies_);
  check_operators(molecule);
}

}  // namespace alphascope
