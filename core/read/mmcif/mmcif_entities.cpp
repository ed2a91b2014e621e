// SPDX-License-Identifier: GPL-3.0-or-later
// Collects rows of the entity tables and derives the type of each entity.
#include "core/read/mmcif/mmcif_entities.hpp"

#include "core/geometry/lattice_alpha.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kEntity = "_entity", kPolymers = "_entity_poly",
                           kNonPolymers = "_pdbx_entity_nonpoly", kBranched = "_pdbx_entity_branch",
                           kAsym = "_struct_asym";

EntityType type_of(std::string_view text) {
  const std::string type = upper_case(text);
  if (type == "POLYMER") return EntityType::polymer;
  if (type == "NON-POLYMER") return EntityType::non_polymer;
  if (type == "BRANCHED") return EntityType::branched;
  if (type == "WATER") return EntityType::water;
  return EntityType::none;
}

std::string value_of(const std::map<std::string, std::string>& values, const char* column) {
  const auto found = values.find(column);
  return found == values.end() ? std::string() : found->second;
}

}  // namespace

bool MmcifEntityTables::wants(std::string_view tag) {
  const std::string_view table = tag.substr(0, tag.find('.'));
  return table == kEntity || table == kPolymers || table == kNonPolymers || table == kBranched ||
         table == kAsym;
}

void MmcifEntityTables::add(int block, std::string_view tag, std::string_view value) {
  const std::size_t dot = tag.find('.');
  if (dot == std::string_view::npos) return;
  Block& here = blocks_[block];
  const std::string_view table = tag.substr(0, dot);
  const std::string column(tag.substr(dot + 1));
  if (column != "id" && column != "type" && column != "entity_id") return;
  Row& row = here.open[std::string(table)];
  if (row.values.contains(column)) {
    take(here, table, row);
    row.values.clear();
  }
  row.values.emplace(column, value);
}

void MmcifEntityTables::take(Block& block, std::string_view table, const Row& row) {
  const std::string id = value_of(row.values, "id"), entity = value_of(row.values, "entity_id");
  if (table == kAsym) {
    if (!id.empty() && !entity.empty()) block.entity_of_asym[id] = entity;
  } else if (table == kEntity) {
    const EntityType type = type_of(value_of(row.values, "type"));
    if (!id.empty() && type != EntityType::none) block.types[id] = type;
  } else if (!entity.empty()) {
    // The table of all entities takes precedence over those of some entities.
    const EntityType type = table == kPolymers   ? EntityType::polymer
                            : table == kBranched ? EntityType::branched
                                                 : EntityType::non_polymer;
    block.types.try_emplace(entity, type);
  }
}

void MmcifEntityTables::finish(int block, const NameTable& names, ResidueRecords& records) const {
  const auto found = blocks_.find(block);
  if (found == blocks_.end()) return;
  Block tables = found->second;
  for (const auto& [table, row] : found->second.open) take(tables, table, row);
  for (const auto& [id, type] : tables.types) {
    const NameId name = names.find(id);
    if (name != 0) records.entities[name] = type;
  }
  for (const auto& [asym, entity] : tables.entity_of_asym) {
    const NameId name = names.find(asym);
    const auto type = tables.types.find(entity);
    if (name != 0 && type != tables.types.end()) records.entities_of_chains[name] = type->second;
  }
}

}  // namespace alphascope
