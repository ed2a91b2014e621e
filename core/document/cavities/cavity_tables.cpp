// SPDX-License-Identifier: GPL-3.0-or-later
// Writes cavities as CSV and JSON.
#include "core/document/cavities/cavity_tables.hpp"

#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_json.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

CavityFacts facts_of(const Inputs& in, const CavityRowsWanted& wanted, const RecordSource& source) {
  CavityFacts facts = facts_without_volumes(in, wanted, source);
  facts.exact = in.share(cavity_volumes());
  facts.depths = in.share(cavity_depths());
  facts.lives = in.share(whole_cavity_lives());
  facts.contents = in.share(cavity_contents());
  facts.exact_rank = ranks_by_exact_volume(facts.table(), *facts.exact);
  return facts;
}

std::uint64_t number_of(const CavityRowsWanted& rows) {
  const double least = rows.least_volume_sa_angstrom3.value_or(-1e300);
  return std::hash<double>()(least) * 4 + (rows.voids ? 2 : 0) + (rows.pockets ? 1 : 0) + 4;
}

using Written = std::string (*)(const CavityFacts& facts, const RunContext& context);
Definition<std::string> written(const CavityRowsWanted& rows, const RecordSource& source,
                                std::string_view id, Written write) {
  return {{.id = id,
           .title = "The table of cavities as text",
           .made_of = {&cavity_table(), &cavity_volumes(), &cavity_depths(), &whole_cavity_lives(),
                       &cavity_contents()},
           .key = [rows, prepared = source.prepared](
                      const Inputs& in) { return key_of_cavity_file(in, rows, *prepared); },
           .memory =
               [](const Inputs& in) {
                 constexpr std::uint64_t kRow = 4000;  // bytes; JSON lists atoms
                 const std::uint64_t bytes = kRow * in.of(cavity_table()).size() + 1'000'000;
                 return MemoryNeed{bytes, 3 * bytes};
               },
           .keep_stale = false},
          [rows, source, write](const Inputs& in, const RunContext& context) {
            return std::make_shared<const std::string>(write(facts_of(in, rows, source), context));
          }};
}

}  // namespace

CavityFacts facts_without_volumes(const Inputs& in, const CavityRowsWanted& rows,
                                  const RecordSource& source) {
  CavityFacts facts;
  facts.source = source;
  facts.request.alpha_angstrom2 = in.alpha_angstrom2;
  facts.request.solvent_radius_angstrom = in.solvent_radius_angstrom;
  facts.atoms = in.atoms;
  facts.all = in.share(cavity_table());
  facts.differences =
      differences_from_castp(source.options, source.prepared->report, facts.request);
  if (facts.table().question.split_networks) facts.differences.push_back(kNetworksAreSplit);
  for (std::size_t row = 0; row < facts.table().size(); ++row) {
    const bool of_kind = facts.table().cavity(row).is_void() ? rows.voids : rows.pockets;
    const double volume = facts.table().measure(row).volume_sa_angstrom3;
    const auto& least = rows.least_volume_sa_angstrom3;
    if (of_kind && (!least || volume >= *least)) facts.rows.push_back(row);
  }
  return facts;
}

Key key_of_cavity_file(const Inputs& in, const CavityRowsWanted& rows,
                       const PreparedBalls& prepared) {
  if (!in.atoms || &in.atoms->prepared() != &prepared) return Key{};
  Key key = key_of_balls_and_alpha(in);
  key.more = number_of(rows);
  return key;
}

Definition<std::string> cavities_as_csv(const CavityRowsWanted& rows, const RecordSource& source) {
  return written(rows, source, "cavities.csv",
                 [](const CavityFacts& facts, const RunContext& context) {
                   std::string text;
                   for (const std::size_t row : facts.rows) {
                     context.cancel.throw_if_cancelled();
                     const CsvRow cells = cavity_csv(facts, row, row + 1);
                     text += (text.empty() ? csv_names(cells) : "") + csv_values(cells);
                   }
                   return text;
                 });
}

Definition<std::string> cavities_as_json(const CavityRowsWanted& rows, const RecordSource& source) {
  return written(rows, source, "cavities.json", [](const CavityFacts& facts, const RunContext&) {
    Json json = cavities_json(facts);
    json["program"] = program_json(facts.source.program);
    return json_text(json);
  });
}

}  // namespace alphascope
