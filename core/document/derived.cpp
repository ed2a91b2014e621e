// See the header.
#include "core/document/derived.hpp"

#include "core/triangulation/cgal_triangulation.hpp"

namespace alphascope {

const Definition<Triangulation>& whole_triangulation() {
  static const Definition<Triangulation> definition{
      "triangulation",
      "Triangulation of all balls",
      [](const Inputs& in) { return in.balls_key; },
      [](const Inputs& in) { return triangulation_memory(in.balls->size()); },
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const Triangulation>(make_triangulation(*in.balls, 1, context));
      },
      false};
  return definition;
}

const Definition<Filtration>& whole_filtration() {
  static const Definition<Filtration> definition{
      "filtration",
      "Filtration of all simplices",
      [](const Inputs& in) { return in.triangulation ? in.balls_key : Key{0}; },
      [](const Inputs& in) { return filtration_memory(*in.triangulation); },
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const Filtration>(in.balls, *in.triangulation, context);
      },
      false};
  return definition;
}

}  // namespace alphascope
