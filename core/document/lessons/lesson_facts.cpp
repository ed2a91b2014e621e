// SPDX-License-Identifier: GPL-3.0-or-later
// Parses names of facts and writes their values.
#include "core/document/lessons/lesson_facts.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/complex/alpha_complex.hpp"
#include "core/document/measures/measure_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/answer.hpp"
#include "core/document/store/inputs.hpp"
#include "core/geometry/grown_radius.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/union_measures.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/selection_expression.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/short_number.hpp"
#include "core/text_files/line_reader.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {
namespace {

constexpr const char *kUnknown = "…", *kMinus = "−";

struct Countable {
  std::string_view many, one;
};
constexpr Countable kSimplices[] = {{"vertices", "vertex"},
                                    {"edges", "edge"},
                                    {"triangles", "triangle"},
                                    {"tetrahedra", "tetrahedron"}};
constexpr std::string_view kNumbers[] = {"alpha",  "solvent",    "balls",   "hidden", "saturated",
                                         "euler",  "components", "tunnels", "voids",  "pockets",
                                         "mouths", "volume",     "area"};

// The parsed name of a fact.
struct Fact {
  std::string_view word;           // "edges", "alpha", "grown", "value"
  bool noun = false;               // "n edges": the number with its noun
  bool all = false;                // "all edges": edges of all alphas
  std::vector<std::size_t> atoms;  // "#1 #2", from 1
};

const Countable* countable(std::string_view word) {
  const auto* at = std::find_if(std::begin(kSimplices), std::end(kSimplices),
                                [&](const Countable& c) { return c.many == word; });
  return at == std::end(kSimplices) ? nullptr : at;
}

std::optional<std::size_t> atom_number(std::string_view word) {
  std::size_t number = 0;
  if (word.size() < 2 || word.front() != '#') return std::nullopt;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data() + 1, end, number);
  if (error != std::errc() || stop != end || number == 0) return std::nullopt;
  return number;
}

// Reads "#1 #2", the rest of a name.
bool take_atoms(std::string_view rest, Fact& fact) {
  for (std::string_view word = next_field(rest); !word.empty(); word = next_field(rest)) {
    const auto number = atom_number(word);
    if (!number) return false;
    fact.atoms.push_back(*number);
  }
  return true;
}

std::optional<Fact> parse(std::string_view name) {
  Fact fact;
  std::string_view rest = name;
  fact.word = next_field(rest);
  fact.noun = fact.word == "n";
  if (fact.noun) fact.word = next_field(rest);
  fact.all = fact.word == "all";
  if (fact.all) fact.word = next_field(rest);
  if (!take_atoms(rest, fact)) return std::nullopt;
  const std::size_t atoms = fact.atoms.size();
  const bool counts = countable(fact.word) != nullptr;
  const bool plain = !fact.noun && !fact.all;
  const bool number =
      std::find(std::begin(kNumbers), std::end(kNumbers), fact.word) != std::end(kNumbers);
  const bool known = (counts && atoms == 0) || (plain && number && atoms == 0) ||
                     (plain && fact.word == "grown" && atoms == 1) ||
                     (plain && fact.word == "value" && atoms >= 1 && atoms <= 4);
  return known ? std::optional(fact) : std::nullopt;
}

// A number with at most three decimals.
std::string number_text(double value) {
  const double rounded = std::round(value * 1000) / 1000;
  const std::string digits = short_number(std::fabs(rounded));
  return (rounded < 0 ? kMinus : "") + digits;
}

std::string count_text(std::size_t count, const Fact& fact) {
  if (!fact.noun) return grouped(count);
  const Countable& what = *countable(fact.word);
  if (count == 0) return "no " + std::string(what.many);
  return grouped(count) + " " + std::string(count == 1 ? what.one : what.many);
}

std::size_t count_in(const AlphaComplex& complex, std::string_view word) {
  if (word == "tetrahedra") return complex.tetrahedra.size();
  if (word == "vertices") return complex.vertices.size();
  if (word == "edges") return complex.edges.size();
  return complex.triangles.size();
}

// A ball is saturated when its vertex is interior (core/rounds/thesis_rounds.hpp).
std::size_t saturated_in(const AlphaComplex& complex) {
  const auto& classes = complex.vertices.classes;
  return static_cast<std::size_t>(
      std::count(classes.begin(), classes.end(), SimplexClass::interior));
}

std::optional<BallIndex> ball_of(const Answer& shown, std::size_t atom) {
  const auto& atoms = shown.prepared->atom_of_ball;
  const auto at = std::find(atoms.begin(), atoms.end(), atom - 1);
  if (at == atoms.end()) return std::nullopt;
  return static_cast<BallIndex>(at - atoms.begin());
}

template <int N>
std::string value_in(const AlphaComplex& all, const SimplexList<N>& list,
                     const std::vector<BallIndex>& balls) {
  std::array<BallIndex, N> wanted;
  std::copy(balls.begin(), balls.end(), wanted.begin());
  const auto begin = list.simplices.begin(), end = list.simplices.end();
  const auto at = std::lower_bound(begin, end, wanted);
  if (at == end || *at != wanted) return "none";
  const float value = list.alpha_values[static_cast<std::size_t>(at - begin)];
  return number_text(all.lattice.square_angstrom(value)) + " Å²";
}

template <class T>
std::shared_ptr<const T> asked(const std::function<std::shared_ptr<const T>()>& function) {
  return function ? function() : nullptr;
}

std::string value_text(const LessonFacts& facts, const Fact& fact) {
  const auto filtration = asked(facts.all);
  if (!filtration) return kUnknown;
  std::vector<BallIndex> balls;
  for (const std::size_t atom : fact.atoms) {
    const auto ball = ball_of(*facts.shown, atom);
    if (!ball) return "none";
    balls.push_back(*ball);
  }
  std::sort(balls.begin(), balls.end());
  const AlphaComplex& all = filtration->top();
  switch (balls.size()) {
    case 1:
      return value_in<1>(all, all.vertices, balls);
    case 2:
      return value_in<2>(all, all.edges, balls);
    case 3:
      return value_in<3>(all, all.triangles, balls);
    default:
      return value_in<4>(all, all.tetrahedra, balls);
  }
}

std::string grown_text(const Answer& shown, std::size_t atom) {
  const auto ball = ball_of(shown, atom);
  if (!ball) return kUnknown;
  const double radius = shown.balls->lattice.angstrom(shown.balls->radii[*ball]);
  return number_text(grown_radius(radius, 0, shown.request.alpha_angstrom2)) + " Å";
}

// Components, tunnels and voids are the Betti numbers. The number of tunnels follows from the
// others and the Euler number.
std::string hole_text(std::string_view word, const LessonFacts& facts) {
  const bool of_components = word == "components" || word == "tunnels";
  const auto measured = of_components ? asked(facts.measured) : nullptr;
  const auto cavities = word == "components" ? nullptr : asked(facts.cavities);
  if ((of_components && !measured) || (word != "components" && !cavities)) return kUnknown;
  if (word == "components") return grouped(measured->components.count);
  if (word == "voids") return grouped(cavities->voids);
  if (word == "pockets") return grouped(cavities->pockets);
  if (word == "mouths") return grouped(cavities->mouths);
  return number_text(static_cast<double>(measured->components.count + cavities->voids) -
                     static_cast<double>(facts.shown->complex.euler_characteristic()));
}

std::string measure_text(std::string_view word, const LessonFacts& facts) {
  const auto measured = asked(facts.measured);
  if (!measured) return kUnknown;
  const UnionMeasures& m = measured->measures();
  return word == "volume" ? number_text(m.volume_angstrom3()) + " Å³"
                          : number_text(m.area_angstrom2()) + " Å²";
}

// Facts of the request and the balls, which need no computation.
std::string plain_text(const Fact& fact, const Answer& shown) {
  if (fact.word == "alpha") return number_text(shown.request.alpha_angstrom2) + " Å²";
  if (fact.word == "solvent") return number_text(shown.request.solvent_radius_angstrom) + " Å";
  if (fact.word == "balls") return grouped(shown.balls->size());
  if (fact.word == "grown") return grown_text(shown, fact.atoms.front());
  return {};
}

std::string fact_text(const Fact& fact, const LessonFacts& facts) {
  if (!facts.shown) return kUnknown;
  const Answer& shown = *facts.shown;
  const std::string_view word = fact.word;
  if (std::string plain = plain_text(fact, shown); !plain.empty()) return plain;
  if (word == "value") return value_text(facts, fact);
  const bool complete = !shown.complex.tetrahedra_only;
  if (!complete && word != "tetrahedra") return kUnknown;
  if (word == "saturated") return grouped(saturated_in(shown.complex));
  if (word == "euler") {
    return number_text(static_cast<double>(shown.complex.euler_characteristic()));
  }
  if (word == "volume" || word == "area") return measure_text(word, facts);
  const auto all = fact.all || word == "hidden" ? asked(facts.all) : nullptr;
  if (fact.all || word == "hidden") {
    if (!all) return kUnknown;
    if (word == "hidden") return grouped(shown.balls->size() - all->top().vertices.size());
  }
  if (countable(word) == nullptr) return hole_text(word, facts);
  return count_text(count_in(all ? all->top() : shown.complex, word), fact);
}

// Calls visit(piece, fact) for each piece of text. `fact` is set if the piece is a fact in { and }.
template <class Visit>
void for_pieces(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find('{'), text.size());
    const std::size_t end = text.find('}', begin);
    if (end == std::string_view::npos) return visit(text, std::nullopt);
    visit(text.substr(0, begin), std::nullopt);
    visit(text.substr(begin, end + 1 - begin), parse(text.substr(begin + 1, end - begin - 1)));
    text.remove_prefix(end + 1);
  }
}

}  // namespace

bool is_lesson_fact(std::string_view name) {
  return parse(name).has_value();
}

std::string lesson_fact_names() {
  std::string names;
  for (const std::string_view name : kNumbers) names += std::string(name) + ", ";
  for (const Countable& c : kSimplices) names += std::string(c.many) + ", ";
  return names + "n edges (with the noun), all edges (of every alpha), grown #1, and value #1 #2";
}

std::string with_facts(std::string_view text, const LessonFacts& facts) {
  std::string said;
  for_pieces(text, [&](std::string_view piece, const std::optional<Fact>& fact) {
    said += fact ? fact_text(*fact, facts) : std::string(piece);
  });
  return said;
}

bool has_all_facts(std::string_view text, const LessonFacts& facts) {
  bool all = true;
  for_pieces(text, [&](std::string_view, const std::optional<Fact>& fact) {
    all = all && !(fact && fact_text(*fact, facts) == kUnknown);
  });
  return all;
}

}  // namespace alphascope
