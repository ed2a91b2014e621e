// SPDX-License-Identifier: GPL-3.0-or-later
// Makes assemblies from the rows of three mmCIF tables.
#include "core/read/mmcif/mmcif_assembly.hpp"

#include <set>

#include "core/geometry/lattice_alpha.hpp"
#include "core/read/decimal.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kAssembly = "_pdbx_struct_assembly";
constexpr std::string_view kGenerators = "_pdbx_struct_assembly_gen";
constexpr std::string_view kOperators = "_pdbx_struct_oper_list";

std::string value_of(const MmcifAssemblyRow& row, const std::string& column) {
  const auto found = row.values.find(column);
  return found == row.values.end() ? std::string() : found->second;
}

bool read_operator(const MmcifAssemblyRow& row, SymmetryOperator& result) {
  result.line = row.line;
  result.id = value_of(row, "id");
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      const std::string n = std::to_string(i + 1);
      const std::string column =
          j == 3 ? "vector[" + n + "]" : "matrix[" + n + "][" + std::to_string(j + 1) + "]";
      const std::string text = value_of(row, column);
      Decimal number;
      if (parse_decimal(text, number) != DecimalStatus::ok) return false;
      result.rows[i][j] = number.to_double();
      if (j < 3) result.digits = std::max(result.digits, printed_decimals(text));
    }
  }
  return !result.id.empty();
}

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::string_view part = text.substr(0, comma);
    while (!part.empty() && (is_blank(part.front()) || part.front() == '\n')) part.remove_prefix(1);
    while (!part.empty() && (is_blank(part.back()) || part.back() == '\n')) part.remove_suffix(1);
    parts.emplace_back(part);
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return parts;
}

}  // namespace

bool MmcifAssemblyTables::wants(std::string_view tag) {
  const std::string_view table = tag.substr(0, tag.find('.'));
  return table == kAssembly || table == kGenerators || table == kOperators;
}

void MmcifAssemblyTables::add(std::string_view tag, std::string_view value, std::size_t line) {
  const std::size_t dot = tag.find('.');
  std::vector<MmcifAssemblyRow>& rows = tables_[std::string(tag.substr(0, dot))];
  const std::string column(tag.substr(dot + 1));
  if (rows.empty() || rows.back().values.contains(column)) rows.push_back({{}, line});
  rows.back().values.emplace(column, value);
}

void MmcifAssemblyTables::finish(Molecule& molecule) const {
  const auto rows_of = [this](std::string_view table) {
    const auto found = tables_.find(std::string(table));
    return found == tables_.end() ? std::vector<MmcifAssemblyRow>() : found->second;
  };
  Assemblies& assemblies = molecule.assemblies;
  for (const MmcifAssemblyRow& row : rows_of(kOperators)) {
    SymmetryOperator o;
    if (read_operator(row, o)) assemblies.operators.push_back(std::move(o));
  }
  std::map<std::string, std::string> details;
  std::set<std::string> refused;
  for (const MmcifAssemblyRow& row : rows_of(kAssembly))
    details[value_of(row, "id")] = value_of(row, "details");
  for (const MmcifAssemblyRow& row : rows_of(kGenerators)) {
    const std::string id = value_of(row, "assembly_id");
    AssemblyGenerator generator;
    generator.chains = split_at_commas(value_of(row, "asym_id_list"));
    if (!parse_operator_expression(value_of(row, "oper_expression"), assemblies.operators,
                                   generator.factors)) {
      if (!refused.contains(id)) {
        refuse_assembly(molecule, id,
                        "its operators \"" + value_of(row, "oper_expression") + "\" in line " +
                            std::to_string(row.line) +
                            " are not all described. Correct _pdbx_struct_oper_list, or fetch the "
                            "file again");
      }
      std::erase_if(assemblies.list, [&](const Assembly& a) { return a.id == id; });
      refused.insert(id);
    }
    if (refused.contains(id)) continue;  // all of its generators are refused
    if (assemblies.list.empty() || assemblies.list.back().id != id) {
      assemblies.list.push_back({id, details[id], {}});
    }
    assemblies.list.back().generators.push_back(std::move(generator));
  }
  check_operators(molecule);
}

}  // namespace alphascope
