// SPDX-License-Identifier: GPL-3.0-or-later
// Collects rows of struct_conf and struct_sheet_range as records of secondary structure.
#include "core/read/mmcif/mmcif_secondary.hpp"

#include <charconv>
#include <optional>
#include <utility>

#include "core/read/mmcif/mmcif_row.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kHelices = "_struct_conf.", kStrands = "_struct_sheet_range.";

// end: "beg" or "end". Takes the author's names where they are given, as for atoms.
EndResidue end_residue(const MmcifRow& row, const std::string& end) {
  EndResidue residue;
  residue.chain = value(row, end + "_auth_asym_id", end + "_label_asym_id");
  const std::string number = value(row, end + "_auth_seq_id", end + "_label_seq_id");
  const auto [stop, error] =
      std::from_chars(number.data(), number.data() + number.size(), residue.number);
  residue.has_number = error == std::errc() && stop == number.data() + number.size();
  const std::string code = value(row, "pdbx_" + end + "_pdb_ins_code");
  if (!code.empty()) residue.insertion_code = code.front();
  return residue;
}

// The kind of a row of struct_conf. Empty for other conformations.
std::optional<SecondaryStructure> conformation(const MmcifRow& row) {
  const std::string type = lower_case(value(row, "conf_type_id"));
  if (type.starts_with("helx_rh_3t")) return SecondaryStructure::three_ten_helix;
  if (type.starts_with("helx_rh_pi")) return SecondaryStructure::pi_helix;
  if (type.starts_with("helx_lh_pp")) return SecondaryStructure::polyproline;
  if (type == "helx_p") return helix_of_class(value(row, "pdbx_pdb_helix_class"));
  if (type.starts_with("helx")) return SecondaryStructure::alpha_helix;
  if (type.starts_with("strn")) return SecondaryStructure::strand;
  if (type.starts_with("turn")) return SecondaryStructure::turn;
  if (type == "bend") return SecondaryStructure::bend;
  return std::nullopt;
}

}  // namespace

bool MmcifSecondaryTables::wants(std::string_view tag) {
  return tag.starts_with(kHelices) || tag.starts_with(kStrands);
}

void MmcifSecondaryTables::add(int block, std::string_view tag, std::string_view value,
                               std::size_t line) {
  if (!wants(tag)) return;  // the loop mixes tables
  Block& here = blocks_[block];
  const bool helix = tag.starts_with(kHelices);
  Row& row = helix ? here.helix : here.strand;
  const std::string column(tag.substr(helix ? kHelices.size() : kStrands.size()));
  if (row.values.contains(column)) helix ? take_helix(here) : take_strand(here);
  if (row.values.empty()) row.line = line;
  row.values.emplace(column, value);
}

void MmcifSecondaryTables::take_helix(Block& block) {
  const Row row = std::exchange(block.helix, {});
  const std::optional<SecondaryStructure> kind = conformation(row.values);
  if (!kind) return;
  block.records.add(
      {*kind, end_residue(row.values, "beg"), end_residue(row.values, "end"), row.line});
}

void MmcifSecondaryTables::take_strand(Block& block) {
  const Row row = std::exchange(block.strand, {});
  if (row.values.empty()) return;
  block.records.add({SecondaryStructure::strand, end_residue(row.values, "beg"),
                     end_residue(row.values, "end"), row.line});
}

void MmcifSecondaryTables::finish(int block, SecondaryRecords& records) {
  const auto found = blocks_.find(block);
  if (found == blocks_.end()) return;
  take_helix(found->second);
  take_strand(found->second);
  records = std::move(found->second.records);
}

}  // namespace alphascope
