// SPDX-License-Identifier: GPL-3.0-or-later
// Converts an Explanation into JSON.
#include "core/document/explain/explanation_json.hpp"

#include "core/document/session/alpha_json.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {
namespace {

using Json = nlohmann::ordered_json;

const char* arithmetic_id(Arithmetic by) {
  switch (by) {
    case Arithmetic::single_filter:
      return "single";
    case Arithmetic::double_filter:
      return "double";
    case Arithmetic::integers:
      return "integers";
    case Arithmetic::perturbation:
      break;
  }
  return "perturbation";
}

Json steps_json(const std::vector<ArithmeticStep>& steps) {
  Json list = Json::array();
  for (const ArithmeticStep& step : steps) {
    Json json{{"by", arithmetic_id(step.by)}, {"sign", step.sign}};
    if (step.has_number) {
      json["value_angstrom2"] = step.value_angstrom2;
      json["error_angstrom2"] = step.error_angstrom2;
    }
    list.push_back(std::move(json));
  }
  return list;
}
Json level_json(const std::optional<AlphaLevel>& level) {
  if (!level) return nullptr;
  return {{"alpha_angstrom2", level->angstrom2}, {"from", level->from}};
}
const char* absence_id(AbsenceReason absence) {
  switch (absence) {
    case AbsenceReason::none:
      break;
    case AbsenceReason::hidden:
      return "hidden";
    case AbsenceReason::dependent:
      return "dependent";
    case AbsenceReason::face:
      return "face";
    case AbsenceReason::cut_away:
      return "cut_away";
  }
  return nullptr;
}

}  // namespace

Json explanation_json(const Explanation& e, const BallName& name) {
  Json atoms = Json::array();
  for (const BallIndex v : e.simplex) atoms.push_back(name(v));
  const bool there = e.absence == AbsenceReason::none;
  Json json{{"simplex", e.simplex},
            {"atoms", atoms},
            {"dimension", e.dimension},
            {"in_triangulation", there}};
  if (!there) {
    json["absence"] = {
        {"reason", absence_id(e.absence)}, {"face", e.absent_face}, {"culprits", e.culprits}};
  }
  json["orthosphere"] = nullptr;
  if (e.orthosphere) {
    const auto& [centre, rho, sign] = *e.orthosphere;
    json["orthosphere"] = {{"centre_angstrom", {centre.x, centre.y, centre.z}},
                           {"rho_angstrom2", rho},
                           {"rho_sign", sign}};
  }
  if (there) {
    json["attached"] = e.attached;
    json["on_hull"] = e.on_hull;
    json["appears"] = level_json(e.appears);
    json["regular"] = level_json(e.regular);
    json["interior"] = level_json(e.interior);
  }
  if (e.at_alpha) {
    json["at_alpha"] = {
        {"alpha_angstrom2", e.lattice.alpha_angstrom2(e.at_alpha->alpha_on_lattice)},
        {"in_complex", e.at_alpha->in_complex},
        {"class",
         e.at_alpha->in_complex ? Json(simplex_class_name(e.at_alpha->simplex_class)) : Json()},
        {"arithmetic", steps_json(e.at_alpha->steps)}};
  }
  Json nearest = Json::array();
  for (const BallMargin& one : e.nearest) {
    nearest.push_back({{"ball", one.ball},
                       {"atom", name(one.ball)},
                       {"power_angstrom2", one.power_angstrom2},
                       {"margin_angstrom2", one.margin_angstrom2},
                       {"sign", one.sign},
                       {"arithmetic", steps_json(one.steps)}});
  }
  json["nearest"] = std::move(nearest);
  return json;
}

}  // namespace alphascope
