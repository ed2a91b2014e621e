// SPDX-License-Identifier: GPL-3.0-or-later
// Converts BallSteps into JSON.
#include "core/document/explain/steps_json.hpp"

#include "core/document/session/alpha_json.hpp"
#include "core/geometry/alpha.hpp"
#include "core/rounds/thesis_rounds.hpp"

namespace alphascope {
namespace {

using Json = nlohmann::ordered_json;

Json counts_json(const Step& step, std::uint64_t StepCount::*which) {
  Json json = Json::object();
  for (const StepCount& count : step.counts) json[std::string(count.id)] = count.*which;
  return json;
}

Json point_json(const RealPoint& p) {
  return {p.x, p.y, p.z};
}

const char* mark_id(StepMark mark) {
  static constexpr const char* kIds[] = {"chosen", "kept", "dropped", "undecided"};
  return kIds[static_cast<std::size_t>(mark)];
}
const char* cut_id(CutKind kind) {
  static constexpr const char* kIds[] = {"too_far", "nothing", "moves_end", "unclear",
                                         "takes_rest"};
  return kIds[static_cast<std::size_t>(kind)];
}

Json dual_edge_json(const StepDualEdge& edge) {
  Json cuts = Json::array();
  for (const StepCut& cut : edge.cuts) {
    cuts.push_back({{"ball", cut.ball},
                    {"does", cut_id(cut.kind)},
                    {"left_angstrom", {cut.low_angstrom, cut.high_angstrom}}});
  }
  return {{"triangle", edge.triangle},
          {"fate", mark_id(edge.mark)},
          {"foot_angstrom", point_json(edge.foot_angstrom)},
          {"direction", point_json(edge.direction)},
          {"within_alpha_angstrom", {edge.low_angstrom, edge.high_angstrom}},
          {"settled_after", edge.settled_after()},
          {"cuts", std::move(cuts)}};
}

Json step_json(const BallSteps& steps, const Step& step, const BallName& name) {
  const StepText text = step_text(steps, step, name);
  Json json{{"step", step_id(step.kind)},
            {"title", text.title},
            {"text", text.text},
            {"counts", counts_json(step, &StepCount::all)},
            {"counts_here", counts_json(step, &StepCount::here)}};
  if (step.off) json["switched_off"] = true;
  for (const StepBox& box : step.boxes) {
    json["boxes_angstrom"].push_back(
        {{"low", point_json(box.low_angstrom)}, {"high", point_json(box.high_angstrom)}});
  }
  for (const StepSphere& sphere : step.spheres) {
    json["spheres"].push_back({{"centre_angstrom", point_json(sphere.centre_angstrom)},
                               {"radius_angstrom", sphere.radius_angstrom}});
  }
  for (const StepSegment& segment : step.segments) {
    json["segments"].push_back({{"triangle", segment.triangle},
                                {"from_angstrom", point_json(segment.from_angstrom)},
                                {"to_angstrom", point_json(segment.to_angstrom)}});
  }
  for (const StepDualEdge& edge : step.dual_edges) {
    json["dual_edges"].push_back(dual_edge_json(edge));
  }
  for (const StepConflict& remover : step.removers) {
    json["in_conflict"].push_back({{"ball", remover.ball},
                                   {"atom", name(remover.ball)},
                                   {"simplices", remover.simplices},
                                   {"first", remover.first}});
  }
  for (const StepPlace& place : step.places) {
    json["places"].push_back(
        {{"triple", place.triple}, {"tuples", place.tuples}, {"place", place.place}});
  }
  return json;
}

const char* state_id(BallSaturation::State state) {
  static constexpr const char* kIds[] = {"saturates", "on_hull", "hidden", "flat"};
  return kIds[static_cast<std::size_t>(state)];
}

}  // namespace

Json steps_json(const BallSteps& steps, const BallName& name) {
  Json json{{"engine", steps_engine_id(steps.engine)},
            {"ball", steps.ball},
            {"atom", name(steps.ball)},
            {"alpha_angstrom2", steps.lattice.alpha_angstrom2(steps.alpha_on_lattice)}};
  Json list = Json::array();
  for (const Step& step : steps.steps) list.push_back(step_json(steps, step, name));
  json["steps"] = std::move(list);
  json["star"] = {{"vertices", steps.star.vertices.simplices},
                  {"edges", steps.star.edges.simplices},
                  {"triangles", steps.star.triangles.simplices},
                  {"tetrahedra", steps.star.tetrahedra.simplices}};
  return json;
}

Json saturation_json(const BallSaturation& s) {
  Json json{{"state", state_id(s.state)}, {"tetrahedra", s.tetrahedra}};
  if (s.state != BallSaturation::State::saturates) return json;
  json["from_alpha_angstrom2"] = s.angstrom2;
  json["last_tetrahedron"] = s.last;
  if (s.round == 0) return json;
  json["round"] = s.round;
  json["round_alpha_angstrom2"] = alpha_of_round(s.round).nearest();
  return json;
}

}  // namespace alphascope
