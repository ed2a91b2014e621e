// See the header.
#include "core/document/steps_json.hpp"

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
  for (const StepRemover& remover : step.removers) {
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

}  // namespace

Json steps_json(const BallSteps& steps, const BallName& name) {
  Json json{{"engine", steps_engine_id(steps.engine)},
            {"ball", steps.ball},
            {"atom", name(steps.ball)},
            {"alpha_angstrom2", steps.lattice.square_angstrom(steps.alpha_on_lattice)}};
  Json list = Json::array();
  for (const Step& step : steps.steps) list.push_back(step_json(steps, step, name));
  json["steps"] = std::move(list);
  json["star"] = {{"vertices", steps.star.vertices.simplices},
                  {"edges", steps.star.edges.simplices},
                  {"triangles", steps.star.triangles.simplices},
                  {"tetrahedra", steps.star.tetrahedra.simplices}};
  return json;
}

}  // namespace alphascope
