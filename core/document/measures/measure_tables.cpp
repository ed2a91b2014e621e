// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the texts from the rows of measure_rows().
#include "core/document/measures/measure_tables.hpp"

#include <memory>
#include <string>

#include "core/document/export/record_source.hpp"
#include "core/document/measures/measure_json.hpp"
#include "core/document/measures/measure_records.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/tables/column_json.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

// Makes a text from the rows of measure_rows().
using Written = std::string (*)(const MeasureFacts& facts, const MeasureRows& rows);
Definition<std::string> written(const MeasureQuery& query, const RecordSource& source,
                                const std::shared_ptr<const Answer>& answer, Written write) {
  AnyDefinition about = measure_rows(query, answer);
  about.lane = Lane::background;
  about.keep_stale = false;
  about.memory = [](const Inputs& in) {
    const std::uint64_t bytes = 1000 * in.balls->size();
    return MemoryNeed{bytes, bytes};
  };
  return {about,
          [make = about.make, source, answer, write](const Inputs& in, const RunContext& context) {
            const auto table = std::static_pointer_cast<const MeasureRows>(make(in, context));
            return std::make_shared<const std::string>(
                write({source, answer, in.share(union_measures())}, *table));
          }};
}

}  // namespace

Definition<std::string> measure_csv(const MeasureQuery& query, const RecordSource& source,
                                    const std::shared_ptr<const Answer>& answer) {
  Definition<std::string> definition =
      written(query, source, answer, [](const MeasureFacts& facts, const MeasureRows& rows) {
        const Provenance provenance = provenance_of(facts);
        std::string text;
        for (const MeasureRow& row : rows.rows) {
          const CsvRow cells = measure_csv_row(facts, rows, row, provenance);
          if (text.empty()) text = csv_names(cells);
          text += csv_values(cells);
        }
        return text;
      });
  definition.id = "measures.csv";
  definition.title = "Areas and volumes as CSV";
  return definition;
}

Definition<std::string> measure_json(const MeasureQuery& query, const RecordSource& source,
                                     const std::shared_ptr<const Answer>& answer) {
  Definition<std::string> definition =
      written(query, source, answer, [](const MeasureFacts& facts, const MeasureRows& rows) {
        Json json = measures_json(facts, rows);
        json["program"] = program_json(facts.source.program);
        return json_text(json);
      });
  definition.id = "measures.json";
  definition.title = "Areas and volumes as JSON";
  return definition;
}

}  // namespace alphascope
