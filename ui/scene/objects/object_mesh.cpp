// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the atoms of an object, colours them, and makes its arrays.
#include "ui/scene/objects/object_mesh.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "core/molecule/altlocs.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/chain_colours.hpp"
#include "core/selection/selection_expression.hpp"

namespace alphascope {
namespace {

// Å
constexpr float kStick = 0.2F, kThinStick = 0.13F;
constexpr float kBall = 0.4F, kHydrogenBall = 0.25F, kLoneBall = 0.45F;

constexpr Rgb8 kNoSecondary{200, 200, 200};  // atoms of neither helices nor strands

class ObjectBuilder {
 public:
  // `atoms`: null for those of the object's expression.
  ObjectBuilder(const PicturedMolecule& m, const ObjectFacts& facts, const DrawnObject& object,
                const std::vector<std::uint32_t>* atoms, const Appearance& appearance,
                const CancelToken& cancel)
      : molecule_(*m.molecule),
        origin_(m.geometry->origin),
        facts_(facts),
        object_(object),
        cancel_(cancel) {
    atoms == nullptr ? choose(appearance) : take(*atoms, appearance);
    cancel.throw_if_cancelled();
    colour(appearance);
    cancel.throw_if_cancelled();
  }

  ObjectMesh build() {
    switch (object_.kind) {
      case ObjectKind::cartoon:
        add_cartoon();
        break;
      case ObjectKind::sticks:
        add_bonds(kStick);
        add_spheres(kStick, kLoneBall);
        break;
      case ObjectKind::balls_and_sticks:
        add_bonds(kThinStick);
        add_spheres(kBall, kBall);
        break;
      case ObjectKind::points:
        add_dots();
        break;
    }
    return std::move(mesh_);
  }

 private:
  void take(const std::vector<std::uint32_t>& atoms, const Appearance& appearance) {
    wanted_.assign(molecule_.atoms.size(), false);
    std::vector<bool> hidden;
    if (!appearance.hidden.empty()) hidden = atoms_of(molecule_, appearance.hidden);
    for (const std::uint32_t i : atoms) wanted_.at(i) = hidden.empty() || !hidden[i];
  }

  void choose(const Appearance& appearance) {
    const auto& atoms = molecule_.atoms;
    wanted_.assign(atoms.size(), false);
    const auto chosen = SelectionExpression::parse(object_.atoms).bind(molecule_);
    const auto begin = atoms.begin() + static_cast<std::ptrdiff_t>(facts_.atoms.begin);
    const auto end = atoms.begin() + static_cast<std::ptrdiff_t>(facts_.atoms.end);
    std::vector<bool> minor;
    if (std::any_of(begin, end, [](const Atom& a) { return a.altloc != ' '; })) {
      minor = minor_altlocs(molecule_, facts_.atoms.begin, facts_.atoms.end);
    }
    std::vector<bool> hidden;
    if (!appearance.hidden.empty()) hidden = atoms_of(molecule_, appearance.hidden);
    for (std::size_t i = facts_.atoms.begin; i < facts_.atoms.end; ++i) {
      const bool gives_way = !minor.empty() && minor[i - facts_.atoms.begin];
      wanted_[i] = !gives_way && (hidden.empty() || !hidden[i]) && chosen(atoms[i]);
    }
  }

  void colour(const Appearance& appearance) {
    const auto& atoms = molecule_.atoms;
    colours_.resize(atoms.size());
    std::optional<ChainColours> of_chain;
    if (object_.colour == ObjectColour::chain) of_chain.emplace(molecule_);
    for (std::size_t i = facts_.atoms.begin; i < facts_.atoms.end; ++i) {
      const Atom& atom = atoms[i];
      const bool polymer = atom.kind == ResidueKind::polymer;
      if (object_.colour == ObjectColour::single) {
        colours_[i] = object_.own;
      } else if (of_chain && polymer) {
        colours_[i] = of_chain->of(atom);
      } else if (object_.colour == ObjectColour::secondary && polymer) {
        colours_[i] = kNoSecondary;
      } else {
        colours_[i] = element_colour(atom.element);
      }
    }
    if (object_.colour == ObjectColour::secondary) colour_residues();
    for (const OwnColour& own : appearance.colours) {
      const std::vector<bool> painted = atoms_of(molecule_, own.atoms);
      for (std::size_t i = 0; i < painted.size(); ++i) {
        if (painted[i]) colours_[i] = own.colour;
      }
    }
  }

  void colour_residues() {
    const auto& atoms = molecule_.atoms;
    for (std::size_t r = 0; r < facts_.secondary->residues.size(); ++r) {
      const std::size_t first = facts_.secondary->residues[r].first;
      const Rgb8 colour = secondary_colour(facts_.secondary->kinds[r]).value_or(kNoSecondary);
      for (std::size_t i = first; i < atoms.size() && same_residue_number(atoms[i], atoms[first]);
           ++i) {
        colours_[i] = colour;
      }
    }
  }

  std::array<float, 3> place(std::uint32_t atom) const {
    const RealPoint p = position_angstrom(molecule_, atom);
    return {static_cast<float>(p.x - origin_[0]), static_cast<float>(p.y - origin_[1]),
            static_cast<float>(p.z - origin_[2])};
  }

  void add_cartoon() {
    const CartoonTraces traces =
        make_traces(molecule_, origin_, *facts_.secondary, facts_.nucleotides, wanted_, colours_);
    mesh_.cartoon = build_cartoon(traces.traces, cartoon_detail(traces.points), cancel_);
    add_plates(traces.plates, mesh_.cartoon);
    if (traces.rungs.empty()) return;
    BallGeometry places;
    places.origin = origin_;
    for (const TraceRung& rung : traces.rungs) {
      for (const RealPoint& p : {rung.from, rung.to}) {
        places.centres.push_back(
            {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        mesh_.sticks.atom_of_place.push_back(rung.atom);
      }
    }
    mesh_.sticks.rods.edges.resize(traces.rungs.size());
    for (std::size_t i = 0; i < traces.rungs.size(); ++i) {
      const PackedColour colour = packed(traces.rungs[i].colour);
      const auto first = static_cast<BallIndex>(2 * i);
      mesh_.sticks.rods.edges[i] = {{first, first + 1}, colour, colour};
    }
    finish_sticks(std::move(places), static_cast<float>(kRungRadius));
  }

  void add_bonds(float radius) {
    std::vector<std::uint32_t> number(molecule_.atoms.size(), kNoAtom);
    BallGeometry places;
    places.origin = origin_;
    std::vector<Bond> drawn;
    for (const Bond& bond : facts_.bonds) {
      if (wanted_[bond.a] && wanted_[bond.b]) drawn.push_back(bond);
    }
    for (const Bond& bond : drawn) {
      for (const std::uint32_t atom : {bond.a, bond.b}) {
        if (number[atom] != kNoAtom) continue;
        number[atom] = static_cast<std::uint32_t>(places.centres.size());
        places.centres.push_back(place(atom));
        mesh_.sticks.atom_of_place.push_back(atom);
      }
    }
    cancel_.throw_if_cancelled();
    mesh_.sticks.rods.edges.resize(drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      mesh_.sticks.rods.edges[i] = {{number[drawn[i].a], number[drawn[i].b]},
                                    packed(colours_[drawn[i].a]),
                                    packed(colours_[drawn[i].b])};
    }
    bonded_ = std::move(number);
    if (!drawn.empty()) finish_sticks(std::move(places), radius);
  }

  void finish_sticks(BallGeometry places, float radius) {
    set_bounds(places, radius);
    mesh_.sticks.places = std::make_shared<const BallGeometry>(std::move(places));
    mesh_.sticks.radius = radius;
  }

  static void set_bounds(BallGeometry& places, double radius) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax_element(places.centres.begin(), places.centres.end(),
                              [k](const auto& a, const auto& b) { return a[k] < b[k]; });
      places.bounds[2 * k] = (*low)[k] - radius;
      places.bounds[2 * k + 1] = (*high)[k] + radius;
    }
  }

  // Atoms with bonds have the radius `bonded` unless sticks cover them; others have `lone`.
  void add_spheres(float bonded, float lone) {
    BallGeometry spheres;
    spheres.origin = origin_;
    for (std::size_t i = facts_.atoms.begin; i < facts_.atoms.end; ++i) {
      if (!wanted_[i]) continue;
      const bool in_stick = bonded_[i] != kNoAtom;
      if (in_stick && bonded <= mesh_.sticks.radius) continue;
      const auto atom = static_cast<std::uint32_t>(i);
      const bool small = in_stick && molecule_.atoms[i].element == kHydrogen;
      spheres.centres.push_back(place(atom));
      spheres.radii.push_back(small ? kHydrogenBall : in_stick ? bonded : lone);
      mesh_.sphere_colours.push_back(colours_[i]);
      mesh_.atom_of_sphere.push_back(atom);
    }
    if (spheres.centres.empty()) return;
    set_bounds(spheres, lone);
    mesh_.spheres = std::make_shared<const BallGeometry>(std::move(spheres));
  }

  void add_dots() {
    for (std::size_t i = facts_.atoms.begin; i < facts_.atoms.end; ++i) {
      if (!wanted_[i]) continue;
      const auto atom = static_cast<std::uint32_t>(i);
      const std::array<float, 3> p = place(atom);
      mesh_.dots.xyz.insert(mesh_.dots.xyz.end(), p.begin(), p.end());
      const Rgb8& c = colours_[i];
      mesh_.dots.rgb.insert(mesh_.dots.rgb.end(), {c.r, c.g, c.b});
      mesh_.dots.source.push_back(atom);
    }
  }

  const Molecule& molecule_;
  const std::array<double, 3> origin_;
  const ObjectFacts& facts_;
  const DrawnObject& object_;
  const CancelToken& cancel_;
  std::vector<bool> wanted_;           // per atom
  std::vector<Rgb8> colours_;          // per atom
  std::vector<std::uint32_t> bonded_;  // per atom; kNoAtom: it has no stick
  ObjectMesh mesh_;
};

}  // namespace

std::shared_ptr<const ObjectFacts> find_object_facts(const PicturedMolecule& molecule,
                                                     const RunContext& context) {
  auto facts = std::make_shared<ObjectFacts>();
  facts->atoms = models_of_balls(*molecule.molecule, *molecule.prepared);
  facts->secondary = molecule.secondary->of(*molecule.molecule, facts->atoms, context);
  for (const ModelRange& model : molecule.molecule->models) {
    if (model.begin < facts->atoms.begin || model.end > facts->atoms.end) continue;
    const auto nucleotides = find_nucleotides(*molecule.molecule, model, context);
    facts->nucleotides.insert(facts->nucleotides.end(), nucleotides.begin(), nucleotides.end());
    const BondList bonds = find_bonds(*molecule.molecule, model, context);
    facts->bonds.insert(facts->bonds.end(), bonds.bonds.begin(), bonds.bonds.end());
  }
  return facts;
}

ObjectMesh build_object(const PicturedMolecule& molecule, const ObjectFacts& facts,
                        const DrawnObject& object, const Appearance& appearance,
                        const CancelToken& cancel) {
  if (molecule.geometry->centres.empty()) return {};
  return ObjectBuilder(molecule, facts, object, nullptr, appearance, cancel).build();
}

ObjectMesh build_object(const PicturedMolecule& molecule, const ObjectFacts& facts,
                        const DrawnObject& object, const std::vector<std::uint32_t>& atoms,
                        const Appearance& appearance, const CancelToken& cancel) {
  if (molecule.geometry->centres.empty()) return {};
  return ObjectBuilder(molecule, facts, object, &atoms, appearance, cancel).build();
}

std::shared_ptr<const ObjectFacts> FactsOnce::of(const PicturedMolecule& molecule,
                                                 const RunContext& context) {
  std::unique_lock lock(finding_, std::defer_lock);
  while (!lock.try_lock_for(std::chrono::milliseconds(20))) context.cancel.throw_if_cancelled();
  if (prepared_ != molecule.prepared) {
    facts_ = find_object_facts(molecule, context);
    prepared_ = molecule.prepared;
  }
  return facts_;
}

PicturedObjects build_objects(const PicturedMolecule& molecule, FactsOnce& facts,
                              const DrawnObjects& objects, const Appearance& appearance,
                              const RunContext& context) {
  PicturedObjects built;
  for (const DrawnObject& object : objects) {
    if (!object.shown) continue;
    built.push_back(
        {std::make_shared<const ObjectMesh>(build_object(molecule, *facts.of(molecule, context),
                                                         object, appearance, context.cancel)),
         object.opacity});
  }
  return built;
}

std::uint64_t object_bytes(const ObjectMesh& mesh) {
  constexpr std::uint64_t kOfPoint = 3 * 4 + 3 * 4 + 3, kOfBall = 64,
                          kOfRod = sizeof(DrawnEdge) + 24;
  const std::uint64_t surface =
      mesh.cartoon.surface.points() * kOfPoint + 4 * mesh.cartoon.surface.corners.size();
  const std::uint64_t balls = mesh.spheres ? mesh.spheres->centres.size() * kOfBall : 0;
  // Each array is there once more for OpenGL.
  return 2 * (surface + balls + mesh.sticks.rods.size() * kOfRod + mesh.dots.points() * kOfPoint);
}

}  // namespace alphascope
