// SPDX-License-Identifier: GPL-3.0-or-later
// Converts programs, inputs, requests and complexes into JSON.
#include "core/document/export/record_json.hpp"

#include "core/document/session/json_fields.hpp"
#include "core/files/fetched_file.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/provenance.hpp"

namespace alphascope {

namespace {

void write_bytes(Json& json) {
  if (json.is_string()) json = text_json(json.get<std::string>());
  if (!json.is_structured()) return;
  for (Json& inner : json) write_bytes(inner);
}

// Null if the file was not fetched.
Json fetched_json(const Molecule& molecule) {
  const auto from = fetched_from(molecule.source);
  return from ? Json{{"address", from->address}, {"time", from->time}} : Json();
}

}  // namespace

Json program_json(const ProgramName& program) {
  return {{"name", program.name}, {"version", program.version}, {"commit", program.commit}};
}

Json input_json(const RecordSource& source) {
  const Molecule& molecule = *source.molecule;
  const SelectionReport& report = source.prepared->report;
  Json guessed = Json::array();
  for (const GuessedRadius& guess : report.guessed) {
    guessed.push_back({{"atoms", guess.atoms},
                       {"count", guess.count},
                       {"radius_angstrom", guess.radius_angstrom},
                       {"source", guess.source}});
  }
  const BallOptions& options = source.options;
  const bool one_model = options.model != kAllModels;
  Json json{
      {"file", molecule.source.string()},
      {"fetched", fetched_json(molecule)},
      {"sha256", molecule.sha256},
      {"format", molecule.format},
      {"title", molecule.title},
      {"models", molecule.models.size()},
      {"model", one_model ? Json(options.model + 1) : Json("joined")},
      {"model_number_in_file", one_model ? Json(molecule.models[options.model].number) : Json()},
      {"assembly", molecule.assembly_id},
      {"options", options_text(options)},
      {"selection_expression", options.selection},
      {"balls", source.prepared->balls->size()},
      {"selection", summary(report)},
      {"atoms_total", report.total},
      {"atoms_used", report.used},
      {"radii",
       {{"set", radii_set_info(report.radii).id},
        {"name", report.radii_name},
        {"citation", report.radii_citation},
        {"guessed", guessed}}},
      {"coincident_centres", report.coincident_centres},
      {"lattice_unit_angstrom", source.lattice().unit_angstrom()},
      {"rounding_angstrom", molecule.rounding_angstrom},
      {"radius_rounding_angstrom", report.radius_rounding_angstrom},
      {"notes", molecule.notes},
      {"open_ms", source.open_milliseconds},
  };
  if (molecule.has_confidences) json["b_factors"] = "pLDDT";
  if (report.radii == RadiiSet::user) json["radii"]["table_sha256"] = options.user_radii->sha256;
  return json;
}

Json request_json(const Request& request, const Lattice& lattice) {
  const LatticeAlpha used = lattice.alpha_on_lattice(request.alpha_angstrom2);
  Json json{{"alpha_angstrom2", request.alpha_angstrom2},
            {"alpha_used_square_lattice_units",
             used.is_shortest_of_double() ? Json(used.nearest()) : Json(used.text())},
            {"solvent_radius_angstrom", request.solvent_radius_angstrom},
            {"solvent_radius_used_angstrom",
             solvent_on_lattice(lattice, request.solvent_radius_angstrom)},
            {"lattice_unit_angstrom", lattice.unit_angstrom()},
            {"tetrahedra_only", request.tetrahedra_only},
            {"engine", engine_id(request.engine)},
            {"threads", request.threads}};
  if (is_tuple_engine(request.engine)) {
    const TupleOptions& t = request.tuples;
    json["tuples"] = {{"grid", t.grid == TupleGridKind::thesis ? "100" : "auto"},
                      {"edge_optimisation", t.edge_optimisation},
                      {"alpha_optimisation", t.alpha_optimisation},
                      {"pinned", t.pinned},
                      {"streams", t.streams},
                      {"texture", t.texture},
                      {"tuples_per_batch", t.tuples_per_batch}};
  }
  return json;
}

Json complex_json(const AlphaComplex& complex, const std::string& engine_note) {
  const bool whole = !complex.tetrahedra_only;
  Json json;
  json["counts"] = {{"vertices", whole ? Json(complex.vertices.size()) : Json()},
                    {"edges", whole ? Json(complex.edges.size()) : Json()},
                    {"triangles", whole ? Json(complex.triangles.size()) : Json()},
                    {"tetrahedra", complex.tetrahedra.size()}};
  json["euler_characteristic"] = whole ? Json(complex.euler_characteristic()) : Json();
  json["hash"] = hash_text(complex.hash);
  json["tetrahedra_hash"] = hash_text(tetrahedra_hash(complex));
  json["engine"] = {{"name", complex.engine.name},
                    {"device", complex.engine.device},
                    {"route", complex.engine.route},
                    {"note", engine_note}};
  if (!complex.engine.counters.empty()) {
    Json counters = Json::object();
    for (const EngineCounter& c : complex.engine.counters) counters[c.name] = c.value;
    json["engine"]["counters"] = counters;
  }
  Json stages = Json::array();
  for (const StageTime& stage : complex.timings.stages) {
    stages.push_back({{"stage", stage.label}, {"ms", stage.milliseconds}, {"setup", stage.setup}});
  }
  json["timings_ms"] = {{"wall", complex.timings.wall_milliseconds},
                        {"setup", complex.timings.setup_milliseconds()},
                        {"stages", stages}};
  return json;
}

void leave_out_run(Json& json) {
  if (json.is_object()) {
    for (const char* key :
         {"timings_ms", "open_ms", "ms", "threads", "device", "route", "counters"}) {
      json.erase(key);
    }
  }
  if (!json.is_structured()) return;
  for (Json& inner : json) leave_out_run(inner);
}

std::string json_text(const Json& json) {
  try {
    return json_file_text(json);
  } catch (const Json::type_error&) {  // names of files, chains and atoms may be any bytes
    Json exact = json;
    write_bytes(exact);
    return json_file_text(exact);
  }
}

}  // namespace alphascope
