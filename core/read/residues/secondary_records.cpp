// SPDX-License-Identifier: GPL-3.0-or-later
// Reads HELIX and SHEET records, and finds the atoms of all records on secondary structure.
#include "core/read/residues/secondary_records.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "core/molecule/molecule.hpp"
#include "core/read/pdb/pdb_numbers.hpp"
#include "core/read/pdb/pdb_records.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

// The columns where a residue's chain, number and insertion code begin. The chain may have a second
// letter before its column.
struct EndColumns {
  std::size_t chain, number, insertion_code;
};

EndResidue end_residue(std::string_view line, const EndColumns& at,
                       PdbChainColumns& chain_columns) {
  // PdbChainColumns asks for the columns of an atom: residue name in 18-20, chain in 21-22.
  std::string like_atom(17, ' ');
  like_atom += columns(line, at.chain - 4, at.chain);
  EndResidue residue;
  residue.chain = chain_columns.chain_of(like_atom);
  const std::string_view text = trimmed(columns(line, at.number, at.number + 3));
  residue.number = parse_pdb_number(columns(line, at.number, at.number + 3), 4);
  residue.has_number =
      residue.number != 0 || (!text.empty() && text.find_first_not_of("+-0") == text.npos);
  const std::string_view code = columns(line, at.insertion_code, at.insertion_code);
  if (!code.empty() && !is_blank(code.front())) residue.insertion_code = code.front();
  return residue;
}

// Where a residue is: the run of neighbouring atoms with its address, and the run of its chain.
struct Place {
  std::uint32_t begin = 0, end = 0, chain_run = 0;
  bool found() const { return end > begin; }
};

enum class Fault : std::uint8_t { none, absent, inverted, apart };
constexpr std::size_t kFaults = 4;

class Statement {
 public:
  Statement(Molecule& molecule, const std::vector<SecondaryRecord>& records)
      : molecule_(molecule), records_(records) {}

  void make() {
    std::vector<Fault> faults(records_.size(), Fault::absent);
    for (const ModelRange& model : molecule_.models) {
      find_places(model);
      for (std::size_t k = 0; k < records_.size(); ++k) {
        const Fault fault = add(records_[k]);
        // Models may have different atoms. A record that fits one of them is right.
        if (faults[k] != Fault::none && fault != Fault::absent) faults[k] = fault;
      }
    }
    note(faults);
    molecule_.stated_secondary.shrink_to_fit();
  }

 private:
  using Key = std::tuple<NameId, std::int32_t, char>;

  Key key(const EndResidue& residue) const {
    return {molecule_.names.find(residue.chain), residue.number, residue.insertion_code};
  }
  bool is_there(const EndResidue& residue) const {
    return residue.has_number &&
           (residue.chain.empty() || molecule_.names.find(residue.chain) != 0);
  }

  // A residue of a polymer comes before waters and ligands of the same number.
  void find_places(const ModelRange& model) {
    polymers_.clear();
    others_.clear();
    for (const SecondaryRecord& record : records_) {
      polymers_[key(record.first)] = others_[key(record.first)] = {};
      polymers_[key(record.last)] = others_[key(record.last)] = {};
    }
    std::uint32_t chain_run = 0;
    Place* place = nullptr;
    for (std::size_t i = model.begin; i < model.end; ++i) {
      const Atom& atom = molecule_.atoms[i];
      const bool first = i == model.begin;
      if (first || !same_chain(atom, molecule_.atoms[i - 1])) ++chain_run;
      if (first || !same_run(atom, molecule_.atoms[i - 1])) place = begin_place(atom, i, chain_run);
      if (place != nullptr) place->end = static_cast<std::uint32_t>(i + 1);
    }
  }

  static bool same_chain(const Atom& a, const Atom& b) {
    return a.chain == b.chain && a.segment == b.segment;
  }
  static bool same_run(const Atom& a, const Atom& b) {
    return same_residue_number(a, b) &&
           (a.kind == ResidueKind::polymer) == (b.kind == ResidueKind::polymer);
  }

  // The place that begins with an atom; null if no record names it, or if it is known already.
  Place* begin_place(const Atom& atom, std::size_t i, std::uint32_t chain_run) {
    auto& places = atom.kind == ResidueKind::polymer ? polymers_ : others_;
    const auto found = places.find({atom.chain, atom.residue_number, atom.insertion_code});
    if (found == places.end() || found->second.found()) return nullptr;
    found->second.begin = static_cast<std::uint32_t>(i);
    found->second.chain_run = chain_run;
    return &found->second;
  }

  Place place_of(const EndResidue& residue) {
    if (!is_there(residue)) return {};
    const Place polymer = polymers_[key(residue)];
    return polymer.found() ? polymer : others_[key(residue)];
  }

  Fault add(const SecondaryRecord& record) {
    const Place first = place_of(record.first), last = place_of(record.last);
    if (!first.found() || !last.found()) return Fault::absent;
    if (record.first.chain != record.last.chain || first.chain_run != last.chain_run) {
      return Fault::apart;
    }
    if (last.begin < first.begin) return Fault::inverted;
    molecule_.stated_secondary.push_back({first.begin, last.end, record.kind});
    return Fault::none;
  }

  void note(const std::vector<Fault>& faults) const {
    constexpr std::array<const char*, kFaults> kReasons = {
        "", "they name residues that are not in the file", "they end before they begin",
        "their ends are in different chains or on both sides of another chain"};
    std::array<CountedLines, kFaults> lines;
    for (std::size_t k = 0; k < faults.size(); ++k) {
      lines[static_cast<std::size_t>(faults[k])].add(records_[k].line);
    }
    for (std::size_t fault = 1; fault < kFaults; ++fault) {
      if (lines[fault].count() == 0) continue;
      molecule_.notes.push_back("Records of helices and strands left out, because " +
                                std::string(kReasons[fault]) + ": " + lines[fault].text());
    }
  }

  Molecule& molecule_;
  const std::vector<SecondaryRecord>& records_;
  std::map<Key, Place> polymers_, others_;
};

}  // namespace

SecondaryStructure helix_of_class(std::string_view text) {
  text = trimmed(text);
  if (text == "3") return SecondaryStructure::pi_helix;
  if (text == "5") return SecondaryStructure::three_ten_helix;
  return text == "10" ? SecondaryStructure::polyproline : SecondaryStructure::alpha_helix;
}

void SecondaryRecords::take_helix(std::string_view line, std::size_t number,
                                  PdbChainColumns& chain_columns) {
  add({helix_of_class(columns(line, 39, 40)), end_residue(line, {20, 22, 26}, chain_columns),
       end_residue(line, {32, 34, 38}, chain_columns), number});
}

void SecondaryRecords::take_strand(std::string_view line, std::size_t number,
                                   PdbChainColumns& chain_columns) {
  add({SecondaryStructure::strand, end_residue(line, {22, 23, 27}, chain_columns),
       end_residue(line, {33, 34, 38}, chain_columns), number});
}

void SecondaryRecords::state(Molecule& molecule) const {
  if (!records_.empty()) Statement(molecule, records_).make();
}

}  // namespace alphascope
