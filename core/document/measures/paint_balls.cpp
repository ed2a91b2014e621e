// SPDX-License-Identifier: GPL-3.0-or-later
// One function for each colour scheme of balls, and the colours of their values.
#include "core/document/measures/paint_balls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/chart/chart.hpp"
#include "core/complex/triangulation.hpp"
#include "core/document/measures/measure_results.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/chain_colours.hpp"
#include "core/molecule/residue_class.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/run/work_threads.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kUnseen = 0xffffffff;

// Categories by a key of atoms. `key_of` returns a number below `keys`; `category` makes a category
// from its first atom. Categories are numbered in the order of the molecule, so that they keep
// their colours when others are switched off.
template <class KeyOf, class Category>
BallValues by_key(const PaintedMolecule& of, std::size_t keys, const KeyOf& key_of,
                  const Category& category) {
  BallValues values;
  std::vector<std::uint32_t> index(keys, kUnseen);
  for (const Atom& atom : of.molecule.atoms) {
    std::uint32_t& known = index[key_of(atom)];
    if (known != kUnseen) continue;
    known = static_cast<std::uint32_t>(values.categories.size());
    values.categories.push_back(category(atom, known));
  }
  values.category_of.reserve(of.atom_of_ball.size());
  for (const std::uint32_t atom : of.atom_of_ball) {
    values.category_of.push_back(index[key_of(of.molecule.atoms[atom])]);
  }
  return values;
}

BallValues by_element(const PaintedMolecule& of) {
  return by_key(
      of, std::numeric_limits<Element>::max() + std::size_t{1},
      [](const Atom& atom) { return atom.element; },
      [](const Atom& atom, std::uint32_t) {
        const std::string symbol(element_symbol(atom.element));
        return PaintCategory{atom.element == kUnknownElement ? "not known" : symbol,
                             element_colour(atom.element)};
      });
}

BallValues by_chain(const PaintedMolecule& of) {
  const std::size_t chains = of.molecule.names.size();
  const ChainColours colours(of.molecule);
  const auto class_of = [&](const Atom& atom) { return residue_class(of.molecule, atom); };
  return by_key(
      of, chains + kResidueClasses,
      [&](const Atom& atom) {
        return colours.by_chain(atom) ? std::size_t{atom.chain}
                                      : chains + static_cast<std::size_t>(class_of(atom));
      },
      [&](const Atom& atom, std::uint32_t) {
        if (!colours.by_chain(atom)) {
          return PaintCategory{residue_class_name(class_of(atom)), colours.of(atom)};
        }
        const std::string name(of.molecule.text(atom.chain));
        return PaintCategory{name.empty() ? "without a name" : name, colours.of(atom)};
      });
}

bool names_residues(const Molecule& molecule) {
  return std::any_of(molecule.atoms.begin(), molecule.atoms.end(),
                     [](const Atom& atom) { return atom.residue_name != 0; });
}

BallValues by_residue_class(const PaintedMolecule& of) {
  BallValues values;
  if (!names_residues(of.molecule)) {
    values.lacks = "The file names no residues, so all balls are grey.";
    return values;
  }
  for (std::size_t k = 0; k < kResidueClasses; ++k) {
    const auto kind = static_cast<ResidueClass>(k);
    values.categories.push_back({residue_class_name(kind), residue_class_colour(kind)});
  }
  // The class depends on few names, so it is computed once for each name.
  constexpr std::size_t kAtomKinds = 5;
  std::vector<std::uint32_t> known(of.molecule.names.size() * kAtomKinds, kUnseen);
  for (const std::uint32_t index : of.atom_of_ball) {
    const Atom& atom = of.molecule.atoms[index];
    std::uint32_t& kind =
        known[atom.residue_name * kAtomKinds + static_cast<std::size_t>(atom.kind)];
    if (kind == kUnseen) kind = static_cast<std::uint32_t>(residue_class(of.molecule, atom));
    values.category_of.push_back(kind);
  }
  return values;
}

// For each atom of a model: position of its residue along the chain, in percent. Only polymers have
// one; ligands and waters have the chain's name but do not belong to its sequence.
void place_along_chains(const Molecule& molecule, const ModelRange& model,
                        std::vector<float>& place) {
  std::vector<std::uint32_t> residues(molecule.names.size(), 0);  // of each chain, so far
  std::vector<const Atom*> last(molecule.names.size(), nullptr);
  std::vector<std::uint32_t> rank(model.size(), kUnseen);
  for (std::size_t i = model.begin; i < model.end; ++i) {
    const Atom& atom = molecule.atoms[i];
    if (atom.kind != ResidueKind::polymer) continue;
    const bool begins = !last[atom.chain] || !same_residue(*last[atom.chain], atom);
    if (begins) ++residues[atom.chain];
    last[atom.chain] = &atom;
    rank[i - model.begin] = residues[atom.chain] - 1;
  }
  for (std::size_t i = model.begin; i < model.end; ++i) {
    const std::uint32_t r = rank[i - model.begin];
    if (r == kUnseen) continue;
    const auto most = static_cast<float>(residues[molecule.atoms[i].chain] - 1);
    place[i] = most > 0 ? 100 * static_cast<float>(r) / most : 0;
  }
}

BallValues by_residue_index(const PaintedMolecule& of) {
  BallValues values;
  if (!names_residues(of.molecule)) {
    values.lacks = "The file names no residues, so all balls are grey.";
    return values;
  }
  std::vector<float> place(of.molecule.atoms.size(), kNone);
  for (const ModelRange& model : of.molecule.models) place_along_chains(of.molecule, model, place);
  values.numbers.reserve(of.atom_of_ball.size());
  for (const std::uint32_t atom : of.atom_of_ball) values.numbers.push_back(place[atom]);
  values.no_number = "not along a chain";
  return values;
}

BallValues by_b_factor(const PaintedMolecule& of) {
  BallValues values;
  values.numbers.reserve(of.atom_of_ball.size());
  bool some = false;
  for (const std::uint32_t index : of.atom_of_ball) {
    const Atom& atom = of.molecule.atoms[index];
    values.numbers.push_back(atom.has_b_factor ? atom.b_factor : kNone);
    some = some || atom.has_b_factor;
  }
  values.no_number =
      of.molecule.has_confidences ? "no pLDDT in the file" : "no B factor in the file";
  if (!some) {
    values.numbers.clear();
    values.lacks = "The file gives no B factors, so all balls are grey.";
  }
  return values;
}

BallValues by_component(const PaintedMolecule& of) {
  BallValues values;
  if (!of.complex || of.complex->tetrahedra_only) {
    values.lacks = of.complex ? "Balls are grey: components need the edges of the complex. "
                                "Switch “Tetrahedra only” off."
                              : "Balls are grey: components need a complex. Move alpha.";
    return values;
  }
  const std::size_t balls = of.atom_of_ball.size();
  const Components found = components(balls, *of.complex);
  std::vector<std::size_t> size(found.count, 0);
  for (const std::uint32_t c : found.of_ball) {
    if (c != kNoGroup) ++size[c];
  }
  // The largest component comes first. Equal ones keep their order, which is that of their lowest
  // balls.
  std::vector<std::uint32_t> order(found.count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return size[a] > size[b]; });
  std::vector<std::uint32_t> category(found.count);
  std::uint32_t alone = kUnseen;
  for (const std::uint32_t c : order) {
    if (size[c] > 1) {
      const std::size_t n = values.categories.size();
      category[c] = static_cast<std::uint32_t>(n);
      values.categories.push_back(
          {std::to_string(n + 1) + ": " + grouped(size[c]) + " balls", chart_colour(n)});
      continue;
    }
    if (alone == kUnseen) {
      alone = static_cast<std::uint32_t>(values.categories.size());
      values.categories.push_back({"one ball alone", {176, 176, 176}});
    }
    category[c] = alone;
  }
  const auto outside = static_cast<std::uint32_t>(values.categories.size());
  values.categories.push_back({"not in the complex", {96, 96, 96}});
  for (const std::uint32_t c : found.of_ball) {
    values.category_of.push_back(c == kNoGroup ? outside : category[c]);
  }
  return values;
}

BallValues by_exposure(const PaintedMolecule& of, ColourBy by) {
  BallValues values;
  if (of.complex && of.complex->tetrahedra_only) {
    values.lacks =
        "Balls are grey: tetrahedra alone have no exposed area. Switch “Tetrahedra only” off.";
    return values;
  }
  if (!of.complex || !of.measures || !of.grown) {
    values.lacks = "Balls are grey: there are no exposed areas without a complex.";
    return values;
  }
  const double alpha = of.complex->alpha_on_lattice.nearest();
  values.numbers = by == ColourBy::exposed
                       ? exposed_shares(*of.measures, *of.grown, alpha)
                       : exposed_shares_of_residues(*of.measures, *of.grown, alpha, of.molecule,
                                                    of.atom_of_ball);
  for (float& share : values.numbers) share *= 100;
  return values;
}

ColourRange automatic_range(const BallValues& values, const SchemeInfo& scheme) {
  if (std::string_view(scheme.unit) == "%") return {0, 100};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const float value : values.numbers) {
    if (std::isnan(value)) continue;
    low = std::min<double>(low, value);
    high = std::max<double>(high, value);
  }
  return low <= high ? round_range(low, high) : ColourRange{};
}

// The categories that some ball has.
std::vector<PaintCategory> used(const BallValues& values) {
  std::vector<bool> is_used(values.categories.size(), false);
  for (const std::uint32_t c : values.category_of) is_used[c] = true;
  std::vector<PaintCategory> some;
  for (std::size_t c = 0; c < is_used.size(); ++c) {
    if (is_used[c]) some.push_back(values.categories[c]);
  }
  return some;
}

std::string lower_case_title(const SchemeInfo& scheme) {
  std::string title = scheme.title;
  const bool word = title.size() > 1 && title[1] != ' ';  // not in "B factor"
  if (word && title[0] >= 'A' && title[0] <= 'Z') title[0] = static_cast<char>(title[0] + 32);
  return title;
}

}  // namespace

BallValues ball_values(const PaintedMolecule& of, ColourBy by) {
  switch (by) {
    case ColourBy::element:
      return by_element(of);
    case ColourBy::chain:
      return by_chain(of);
    case ColourBy::residue_class:
      return by_residue_class(of);
    case ColourBy::residue_index:
      return by_residue_index(of);
    case ColourBy::b_factor:
      return by_b_factor(of);
    case ColourBy::component:
      return by_component(of);
    case ColourBy::exposed:
    case ColourBy::exposed_residue:
      return by_exposure(of, by);
    case ColourBy::single:
    case ColourBy::alpha:
    case ColourBy::simplex_class:
      break;
  }
  return {};
}

PaintedBalls paint_balls(const PaintedMolecule& of, const Paint& paint) {
  const std::size_t balls = of.atom_of_ball.size();
  const SchemeInfo& scheme = scheme_info(paint.by);
  if (!scheme.balls || paint.by == ColourBy::single) {
    constexpr Element kCarbon = 6;
    return {std::vector<Rgb8>(balls, paint.colour.value_or(element_colour(kCarbon))), {}, {}};
  }
  const BallValues values = ball_values(of, paint.by);
  PaintedBalls painted{std::vector<Rgb8>(balls, kNoValueColour), {}, values.lacks};
  if (values.category_of.size() == balls && balls > 0) {
    for (std::size_t i = 0; i < balls; ++i) {
      painted.colours[i] = values.categories[values.category_of[i]].colour;
    }
    painted.key = {lower_case_title(scheme), {}, used(values)};
  } else if (values.numbers.size() == balls && balls > 0) {
    const ColourScale scale{paint.map_used(), paint.range.value_or(automatic_range(values, scheme)),
                            scheme.root};
    const bool confidence = paint.by == ColourBy::b_factor && of.molecule.has_confidences;
    painted.key = {confidence ? "pLDDT (confidence)" : quantity_title(scheme), scale, {}};
    bool all = true;
    for (std::size_t i = 0; i < balls; ++i) {
      const bool known = !std::isnan(values.numbers[i]);
      if (known) painted.colours[i] = scale.colour(values.numbers[i]);
      all = all && known;
    }
    if (!all) painted.key->categories.push_back({values.no_number, kNoValueColour});
  }
  return painted;
}

std::string quantity_title(const SchemeInfo& scheme) {
  return lower_case_title(scheme) + " (" + scheme.unit + ")" +
         (scheme.root ? ", square-root scale" : "");
}

Rgb8 class_colour(SimplexClass of) {
  static constexpr std::array<Rgb8, 3> kColours{{{230, 159, 0}, {86, 180, 233}, {0, 114, 178}}};
  return kColours[static_cast<std::size_t>(of)];
}

ColourMeaning class_colour_meaning() {
  return {"class",
          {},
          {{"singular", class_colour(SimplexClass::singular)},
           {"regular", class_colour(SimplexClass::regular)},
           {"interior", class_colour(SimplexClass::interior)}}};
}

}  // namespace alphascope
