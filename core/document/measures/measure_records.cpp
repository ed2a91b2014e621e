// SPDX-License-Identifier: GPL-3.0-or-later
// Writes areas and volumes as CSV and JSON; also the function of measure_json.hpp.
#include "core/document/measures/measure_records.hpp"

#include "core/document/measures/measure_columns.hpp"
#include "core/document/measures/measure_json.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/tables/column_json.hpp"
#include "core/selection/provenance.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

Json rows_json(const MeasureRows& table) {
  Json groups = Json::array();
  for (const MeasureRow& row : table.rows) {
    Json group;
    add_keys_up_to(group, measure_columns(), {table, row});
    groups.push_back(std::move(group));
  }
  return groups;
}

const char* list_name(MeasureGrouping per) {
  return per == MeasureGrouping::atom      ? "atoms"
         : per == MeasureGrouping::residue ? "residues"
         : per == MeasureGrouping::chain   ? "chains"
                                           : nullptr;
}

}  // namespace

MeasureRows rows_of_measures(const MeasureFacts& facts, const MeasureQuery& query,
                             std::shared_ptr<const UnionDerivatives> derivatives,
                             const RunContext& context) {
  return make_measure_rows(query, *facts.source.molecule, facts.source.prepared->atom_of_ball,
                           *facts.measured, std::move(derivatives), context);
}

Provenance provenance_of(const MeasureFacts& facts) {
  return facts.source.on(facts.answer->balls->lattice).provenance();
}

CsvRow measure_csv_row(const MeasureFacts& facts, const MeasureRows& rows, const MeasureRow& row,
                       const Provenance& provenance) {
  CsvRow cells = csv_row_of(measure_columns(), {rows, row, &facts});
  for (const auto& [key, value] : provenance) {
    if (key != "model") cells.emplace_back(key, value);
  }
  cells.emplace_back("program", facts.source.program.text());
  return cells;
}

Json measures_json(const MeasureFacts& facts, const MeasureRows& rows) {
  const MeasuredUnion& by = *facts.measured->by;
  const EngineAnswer& answer = *facts.answer;
  Json json{{"surface", surface_name(answer.request)}};
  each_quantity(
      [&](MeasuredQuantity q) { json[quantity_name(q).key] = facts.measures().total[q]; });
  json["components"] = rows_json(rows_of_measures(facts, {.per = MeasureGrouping::component}));
  if (const char* list = list_name(rows.query.per)) json[list] = rows_json(rows);
  json["measured"] = {
      {"device", by.device}, {"route", by.route}, {"note", by.note}, {"ms", by.milliseconds}};
  json.update(complex_json(answer.complex, answer.note));
  json["request"] = request_json(answer.request, answer.balls->lattice);
  json["input"] = input_json(facts.source.on(answer.balls->lattice));
  return json;
}

}  // namespace alphascope
