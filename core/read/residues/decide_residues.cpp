// SPDX-License-Identifier: GPL-3.0-or-later
// Weighs the evidence for each residue in a fixed order.
#include "core/read/residues/decide_residues.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/read/residues/bond_evidence.hpp"
#include "core/read/residues/chain_bonds.hpp"
#include "core/read/residues/residue_notes.hpp"
#include "core/read/residues/residue_table.hpp"

namespace alphascope {
namespace {

struct Decision {
  ResidueKind kind = ResidueKind::polymer;
  ResidueReason why = ResidueReason::none;
};

// True for components of one oxygen that are no water: hydroxide and oxides.
bool is_oxide(std::string_view name) {
  return name == "OH" || name == "O" || name == "OXO" || name == "OX";
}

// The span of a chain's ATOM records between two TER.
struct ChainPlace {
  std::uint32_t first = kNoIndex, last = 0;  // indices of residues that belong to the chain
};

class ModelJudge {
 public:
  ModelJudge(Molecule& molecule, const ModelRange& model, const ResidueRecords& records,
             AtomRoles& roles, ResidueNotes& notes)
      : molecule_(molecule),
        records_(records),
        notes_(notes),
        roles_(roles),
        table_(make_residue_table(molecule, model, records, roles)),
        bonds_(molecule, table_),
        recorded_(molecule, model, table_, records.bonds) {}

  void judge() {
    find_places();
    std::vector<Decision> decisions(table_.residues.size());
    for (std::uint32_t r = 0; r < decisions.size(); ++r) {
      end_sections_before(r);
      decisions[r] = decide(r);
      if (is_guess(decisions[r].why)) notes_.guessed(decisions[r].why, facts(r).first);
    }
    for (const ResiduePiece& piece : table_.pieces) apply(piece, decisions[piece.residue]);
  }

 private:
  const ResidueFacts& facts(std::uint32_t r) const { return table_.residues[r]; }
  const Atom& first(std::uint32_t r) const { return molecule_.atoms[facts(r).first]; }
  std::string_view name(std::uint32_t r) const { return molecule_.text(first(r).residue_name); }

  using ChainKey = std::pair<NameId, std::uint16_t>;
  ChainKey chain(std::uint32_t r) const { return {first(r).chain, first(r).segment}; }

  void find_places() {
    const auto count = static_cast<std::uint32_t>(table_.residues.size());
    for (std::uint32_t r = 0; r < count; ++r) {
      const std::uint32_t section = facts(r).record.section;
      if (sections_.empty() || sections_.back().number != section) {
        sections_.push_back({section, r, r, {}, kNoIndex});
      }
      Section& here = sections_.back();
      here.last = r;
      if (here.first_water == kNoIndex && facts(r).water_name) here.first_water = r;
      if (facts(r).hetero || !facts(r).chain_like || facts(r).water_name) continue;
      if (facts(r).family != ResidueFamily::biopolymer && !bonds_.is_bound(r)) continue;
      any_chain_ = true;
      ChainPlace& place = here.chains[chain(r)];
      place.first = std::min(place.first, r);
      place.last = r;
    }
  }

  // A TER ends the chain of the residue before it.
  void end_sections_before(std::uint32_t r) {
    while (section_ + 1 < sections_.size() && sections_[section_ + 1].begin <= r) {
      ++section_;
      const ChainKey last = chain(sections_[section_].begin - 1);
      ended_.insert(last);
    }
  }

  const ChainPlace* place_of(std::uint32_t r) const {
    if (sections_.empty()) return nullptr;
    const auto found = sections_[section_].chains.find(chain(r));
    return found == sections_[section_].chains.end() ? nullptr : &found->second;
  }

  EntityType entity(std::uint32_t r) const {
    const auto in = [](const auto& list, NameId id) {
      const auto found = list.find(id);
      return found == list.end() ? EntityType::none : found->second;
    };
    if (facts(r).record.entity != 0) return in(records_.entities, facts(r).record.entity);
    return in(records_.entities_of_chains, first(r).label_chain);
  }

  // Finds an ion or a water by the residue's own atoms and name. decide() weighs this against the
  // entity table and other records.
  Decision special(std::uint32_t r) const {
    const ResidueFacts& f = facts(r);
    const std::uint32_t matter = f.atoms - f.sites;
    if (f.atoms > 0 && f.ions == f.atoms) return {ResidueKind::ion, ResidueReason::ion_name};
    const bool water_atoms = f.oxygens + f.hydrogens + f.unknown >= matter;
    if (f.water_name && water_atoms) return {ResidueKind::water, ResidueReason::water_name};
    const bool listed = f.family == ResidueFamily::biopolymer || f.family == ResidueFamily::dummy;
    if (!listed && f.family != ResidueFamily::ligand && matter == 1 && f.metals == 1) {
      return {ResidueKind::ion, ResidueReason::one_metal};
    }
    const bool one = f.oxygens == 1 && f.hydrogens <= 2 && matter == 1 + f.hydrogens;
    if (one && !listed && !is_oxide(name(r)))
      return {ResidueKind::water, ResidueReason::one_oxygen};
    return {};
  }

  Decision decide(std::uint32_t r) {
    const ResidueFacts& f = facts(r);
    if (f.atoms == 0) {
      const bool named = f.family == ResidueFamily::dummy;
      return {ResidueKind::dummy, named ? ResidueReason::dummy_name : ResidueReason::virtual_site};
    }
    const Decision own = special(r);
    const bool is_special = own.why != ResidueReason::none;
    const bool in_sequence = records_.only_some_are_numbered() && f.record.numbered;
    const EntityType type = entity(r);
    if (type != EntityType::none) return by_entity(r, type, own, in_sequence);
    if (f.record.modified) return {ResidueKind::polymer, ResidueReason::modified_record};
    if (is_special && !(in_sequence && own.why == ResidueReason::one_oxygen)) return own;
    if (f.water_name) notes_.no_water(f.first);
    if (in_sequence) return {ResidueKind::polymer, ResidueReason::sequence_number};
    // A known ligand stays a ligand, even when it is bound to a chain.
    if (f.family == ResidueFamily::unknown && recorded_.is_within_chain(r)) {
      return {ResidueKind::polymer, ResidueReason::bond_record};
    }
    if (f.chain_like && bonds_.is_bound(r))
      return {ResidueKind::polymer, ResidueReason::chain_bond};
    const bool after_ter = ended_.contains(chain(r)) && place_of(r) == nullptr;
    if (!f.chain_like && !after_ter && bonds_.is_linked(r)) {
      return {ResidueKind::polymer, ResidueReason::chain_bond};
    }
    return f.hetero ? by_hetatm(r, after_ter) : by_atom(r);
  }

  Decision by_entity(std::uint32_t r, EntityType type, const Decision& own, bool in_sequence) {
    const bool is_special = own.why != ResidueReason::none;
    switch (type) {
      case EntityType::water:
        return {ResidueKind::water, ResidueReason::entity_water};
      case EntityType::branched:
        return {ResidueKind::ligand, ResidueReason::entity_branched};
      case EntityType::non_polymer:
        if (!is_special) return {ResidueKind::ligand, ResidueReason::entity_non_polymer};
        // An ion is a non-polymer. Water has an entity type of its own, so this is a contradiction.
        if (own.kind == ResidueKind::water)
          notes_.disagrees("non-polymer", own.kind, facts(r).first);
        return own;
      default:
        break;
    }
    const bool by_oxygen = own.why == ResidueReason::one_oxygen;
    if (!is_special || (by_oxygen && (in_sequence || !facts(r).hetero))) {
      return {ResidueKind::polymer, ResidueReason::entity_polymer};
    }
    notes_.disagrees("polymer", own.kind, facts(r).first);
    return own;
  }

  Decision by_atom(std::uint32_t r) const {
    const ResidueFacts& f = facts(r);
    const bool shape = f.amino_shape() || f.nucleic_shape() || f.only_ca();
    if (f.family == ResidueFamily::biopolymer && f.chain_like) {
      return {ResidueKind::polymer, ResidueReason::polymer_name};
    }
    if (f.family == ResidueFamily::ligand) return {ResidueKind::ligand, ResidueReason::ligand_name};
    if (f.family == ResidueFamily::dummy) return {ResidueKind::dummy, ResidueReason::dummy_name};
    if (shape && !bonds_.any() && bonds_.has_neighbour_by_number(r)) {
      return {ResidueKind::polymer, ResidueReason::chain_number};
    }
    if (shape) return {ResidueKind::polymer, ResidueReason::backbone_names};
    if (bonds_.is_numbered_between(r)) return {ResidueKind::polymer, ResidueReason::place_in_chain};
    if (recorded_.is_bound_to_chain(r)) return {ResidueKind::ligand, ResidueReason::bound_ligand};
    if (records_.only_some_are_numbered())
      return {ResidueKind::ligand, ResidueReason::no_sequence_number};
    if (first(r).residue_name == 0) return {ResidueKind::polymer, ResidueReason::no_name};
    return {ResidueKind::ligand, ResidueReason::no_polymer};
  }

  Decision by_hetatm(std::uint32_t r, bool after_ter) const {
    const ResidueFacts& f = facts(r);
    if (f.family == ResidueFamily::dummy) return {ResidueKind::dummy, ResidueReason::dummy_name};
    // Without any chain the name decides.
    if (f.family == ResidueFamily::biopolymer && f.chain_like && !any_chain_) {
      return {ResidueKind::polymer, ResidueReason::polymer_name};
    }
    const ChainPlace* place = place_of(r);
    const bool not_after = place != nullptr && r < place->last;
    // An amino acid or nucleotide may also be free beside the chain.
    const bool listed = f.family == ResidueFamily::biopolymer;
    if (in_sequence_record(r) && !after_ter && (!listed || place == nullptr || not_after)) {
      return {ResidueKind::polymer, ResidueReason::sequence_record};
    }
    if (f.chain_like && place != nullptr && (not_after || is_before_ter(r))) {
      return {ResidueKind::polymer, ResidueReason::place_in_chain};
    }
    if (f.chain_like && !after_ter && !bonds_.any() && bonds_.has_neighbour_by_number(r)) {
      return {ResidueKind::polymer, ResidueReason::chain_number};
    }
    if (recorded_.is_bound_to_chain(r)) return {ResidueKind::ligand, ResidueReason::bound_ligand};
    return {ResidueKind::ligand, after_ter ? ResidueReason::after_ter : ResidueReason::hetatm};
  }

  // A TER behind waters ends no chain.
  bool is_before_ter(std::uint32_t r) const {
    const Section& section = sections_[section_];
    return section.number < records_.ter_count && section.first_water == kNoIndex &&
           chain(r) == chain(section.last);
  }

  bool in_sequence_record(std::uint32_t r) const {
    const auto found = records_.sequences.find(std::string(molecule_.text(first(r).chain)));
    return found != records_.sequences.end() && found->second.contains(std::string(name(r)));
  }

  void apply(const ResiduePiece& piece, const Decision& decision) {
    for (std::size_t i = piece.begin; i < piece.end; ++i) {
      Atom& atom = molecule_.atoms[i];
      const bool site =
          decision.kind == ResidueKind::water && roles_.is_water_site(molecule_, atom);
      if (atom.kind == ResidueKind::dummy || site) {
        const bool named = decision.why == ResidueReason::dummy_name;
        if (site) atom.element = kUnknownElement;
        atom.kind = ResidueKind::dummy;
        atom.why = named ? decision.why : ResidueReason::virtual_site;
        continue;
      }
      // An ion that is named among other atoms stays an ion.
      if (atom.kind == ResidueKind::ion && decision.kind != ResidueKind::ion &&
          decision.why > ResidueReason::chain_number) {
        atom.why = ResidueReason::ion_name;
        continue;
      }
      atom.kind = decision.kind;
      atom.why = decision.why;
    }
  }

  struct Section {
    std::uint32_t number = 0, begin = 0, last = 0;
    std::map<ChainKey, ChainPlace> chains;
    std::uint32_t first_water = kNoIndex;
  };
  Molecule& molecule_;
  const ResidueRecords& records_;
  ResidueNotes& notes_;
  const AtomRoles& roles_;
  ResidueTable table_;
  ChainBonds bonds_;
  BondEvidence recorded_;
  std::vector<Section> sections_;
  std::size_t section_ = 0;
  bool any_chain_ = false;  // some ATOM records belong to a chain
  std::set<ChainKey> ended_;
};

// Sets the reasons for the kinds of atoms in a model without residue names.
void judge_unnamed(Molecule& molecule) {
  for (Atom& atom : molecule.atoms) {
    if (atom.why != ResidueReason::none) continue;
    if (atom.kind == ResidueKind::polymer) atom.why = ResidueReason::no_name;
    if (atom.kind == ResidueKind::ligand) atom.why = ResidueReason::hetatm;
    if (atom.kind == ResidueKind::ion) atom.why = ResidueReason::ion_name;
    if (atom.kind == ResidueKind::water) atom.why = ResidueReason::water_name;
    if (atom.kind == ResidueKind::dummy) atom.why = ResidueReason::virtual_site;
  }
}

bool same_atom(const Atom& a, const Atom& b) {
  return same_residue_number(a, b) && a.residue_name == b.residue_name && a.name == b.name &&
         a.altloc == b.altloc && a.hetero == b.hetero && a.element == b.element;
}

bool same_atoms(const Molecule& molecule, const ModelRange& first, const ModelRange& model) {
  if (first.size() != model.size()) return false;
  for (std::size_t k = 0; k < model.size(); ++k) {
    if (!same_atom(molecule.atoms[first.begin + k], molecule.atoms[model.begin + k])) return false;
  }
  return true;
}

void copy_answers(Molecule& molecule, const ModelRange& first, const ModelRange& model) {
  for (std::size_t k = 0; k < model.size(); ++k) {
    const Atom& answer = molecule.atoms[first.begin + k];
    Atom& atom = molecule.atoms[model.begin + k];
    atom.kind = answer.kind;
    atom.why = answer.why;
    atom.element = answer.element;
  }
}

}  // namespace

void decide_residues(Molecule& molecule, const ResidueRecords& records) {
  AtomRoles roles(molecule);
  ResidueNotes notes(molecule);
  // Elements are compared with the first model's before decisions change them.
  std::vector<bool> as_first(molecule.models.size());
  for (std::size_t k = 1; k < molecule.models.size(); ++k) {
    as_first[k] = same_atoms(molecule, molecule.models.front(), molecule.models[k]);
  }
  for (std::size_t k = 0; k < molecule.models.size(); ++k) {
    if (as_first[k]) {
      copy_answers(molecule, molecule.models.front(), molecule.models[k]);
    } else {
      ModelJudge(molecule, molecule.models[k], records, roles, notes).judge();
    }
  }
  judge_unnamed(molecule);
  notes.finish();
}

}  // namespace alphascope
