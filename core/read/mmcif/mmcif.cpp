// SPDX-License-Identifier: GPL-3.0-or-later
// Reads mmCIF: the atom_site table, assemblies and the title. Numbers stay text until they go to
// the lattice, and every value knows its line.
#include <charconv>
#include <optional>
#include <set>

#include "core/geometry/lattice_alpha.hpp"
#include "core/read/file_format.hpp"
#include "core/read/mmcif/cif_grammar.hpp"
#include "core/read/mmcif/cif_value.hpp"
#include "core/read/mmcif/mmcif_assembly.hpp"
#include "core/read/mmcif/mmcif_bonds.hpp"
#include "core/read/mmcif/mmcif_component.hpp"
#include "core/read/mmcif/mmcif_entities.hpp"
#include "core/read/mmcif/mmcif_secondary.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/predicted_model.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text/letter_case.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kAtomSite = "_atom_site.";
constexpr std::string_view kMetric = "_ma_qa_metric.";
constexpr std::size_t kProgressRows = 16384;

// The columns of atom_site that we use, in the order of kColumnTags.
enum Column : std::size_t {
  kGroup,
  kId,
  kSymbol,
  kLabelAtom,
  kAuthAtom,
  kAltloc,
  kLabelComp,
  kAuthComp,
  kLabelAsym,
  kEntityId,
  kAuthAsym,
  kLabelSeq,
  kAuthSeq,
  kInsertionCode,
  kX,
  kY,
  kZ,
  kOccupancy,
  kBFactor,
  kModel,
  kColumnCount
};
constexpr std::array<std::string_view, kColumnCount> kColumnTags = {
    "group_pdb",      "id",
    "type_symbol",    "label_atom_id",
    "auth_atom_id",   "label_alt_id",
    "label_comp_id",  "auth_comp_id",
    "label_asym_id",  "label_entity_id",
    "auth_asym_id",   "label_seq_id",
    "auth_seq_id",    "pdbx_pdb_ins_code",
    "cartn_x",        "cartn_y",
    "cartn_z",        "occupancy",
    "b_iso_or_equiv", "pdbx_pdb_model_num"};

// Receives the events of the grammar, in file order.
class MmcifReader : public CifHandler {
 public:
  explicit MmcifReader(const ReaderInput& input) : input_(input), builder_(input.source, "mmCIF") {}

  void begin_block() override { ++block_; }
  void begin_loop() override {
    tags_.clear();
    row_.clear();
    column_ = 0;
    kind_ = Table::undecided;
  }
  void loop_tag(std::string_view tag) override { tags_.emplace_back(lower_case(tag)); }

  void loop_value(std::string_view raw, std::size_t line) override {
    if (kind_ == Table::undecided) kind_ = recognise();
    if (kind_ == Table::other) return;
    if (kind_ == Table::metrics) {
      predicted_.take_metric(plain_cif(raw));
      return;
    }
    if (kind_ == Table::methods) {
      take_method(tags_[column_], plain_cif(raw));
      column_ = (column_ + 1) % tags_.size();
      return;
    }
    if (kind_ == Table::spheres) {
      ++sphere_values_;
      sphere_columns_ = tags_.size();
      return;
    }
    if (kind_ == Table::component) {
      component_.add({raw, line});
      return;
    }
    if (kind_ == Table::assembly) {
      assemblies_.add(tags_[column_], plain_cif(raw), line);
      column_ = (column_ + 1) % tags_.size();
      return;
    }
    if (kind_ == Table::bonds) {
      bonds_.add(block_, tags_[column_], plain_cif(raw));
      column_ = (column_ + 1) % tags_.size();
      return;
    }
    if (kind_ == Table::secondary) {
      secondary_.add(block_, tags_[column_], plain_cif(raw), line);
      column_ = (column_ + 1) % tags_.size();
      return;
    }
    if (kind_ == Table::entity) {
      entities_.add(block_, tags_[column_], plain_cif(raw));
      column_ = (column_ + 1) % tags_.size();
      return;
    }
    row_.push_back({raw, line});
    if (row_.size() < tags_.size()) return;
    take_row();
    row_.clear();
  }

  void end_loop() override {
    if (kind_ == Table::atoms && !row_.empty()) {
      fail(row_.front().line,
           "this row of the atom_site table has " + std::to_string(row_.size()) + " of its " +
               std::to_string(tags_.size()) + " values",
           "The file is truncated or damaged; fetch it again");
    }
  }

  void item_tag(std::string_view tag) override { item_ = lower_case(tag); }

  void item_value(std::string_view raw, std::size_t line) override {
    if (item_ == "_struct.title" && builder_.molecule().title.empty()) {
      builder_.molecule().title = std::string(trimmed(plain_cif(raw)));
    } else if (item_.starts_with(kAtomSite)) {
      single_tags_.push_back(item_);
      single_row_.push_back({raw, line});
    } else if (MmcifAssemblyTables::wants(item_)) {
      assemblies_.add(item_, plain_cif(raw), line);
    } else if (MmcifEntityTables::wants(item_)) {
      entities_.add(block_, item_, plain_cif(raw));
    } else if (MmcifBondTable::wants(item_)) {
      bonds_.add(block_, item_, plain_cif(raw));
    } else if (MmcifSecondaryTables::wants(item_)) {
      secondary_.add(block_, item_, plain_cif(raw), line);
    }
    if (item_.starts_with(kMetric)) predicted_.take_metric(plain_cif(raw));
    take_method(item_, plain_cif(raw));
    fractional_ |= item_.starts_with("_atom_site_fract") || item_ == "_cell_length_a";
  }

  Molecule finish() {
    if (!single_row_.empty() && builder_.size() == 0) {  // a single atom, without a loop
      tags_ = single_tags_;
      row_ = single_row_;
      kind_ = recognise();
      take_row();
    }
    if (builder_.size() == 0 && !component_.empty()) {
      component_.take(builder_, guesser_);
      atoms_block_ = component_block_;
    }
    if (builder_.size() == 0) refuse_without_atoms();
    if (sphere_values_ > 0) {
      builder_.molecule().notes.push_back(
          "The model also has spheres in place of atoms (ihm_sphere_obj_site), which are not "
          "read: " +
          std::to_string(sphere_values_ / sphere_columns_));
    }
    if (ignored_blocks_ > 0) {
      builder_.molecule().notes.push_back(
          "Only the first data block with atoms is read; further blocks with atoms are ignored");
    }
    guesser_.add_note(builder_.molecule(), "because the column type_symbol holds none");
    predicted_.finish(builder_.molecule());
    assemblies_.finish(builder_.molecule());
    entities_.finish(atoms_block_, builder_.molecule().names, builder_.records());
    bonds_.finish(atoms_block_, builder_.records().bonds);
    secondary_.finish(atoms_block_, builder_.records().secondary);
    return builder_.finish();
  }

 private:
  enum class Table : std::uint8_t {
    undecided,
    atoms,
    assembly,
    entity,
    bonds,
    secondary,
    component,
    metrics,
    methods,
    spheres,
    other
  };

  void take_method(std::string_view tag, std::string_view method) {
    if (tag == "_exptl.method") predicted_.take_method(method);
  }

  Table recognise() {
    for (const std::string& tag : tags_) fractional_ |= tag == "_atom_site_fract_x";
    if (MmcifAssemblyTables::wants(tags_.front())) return Table::assembly;
    if (tags_.front().starts_with(kMetric)) return Table::metrics;
    if (tags_.front().starts_with("_exptl.")) return Table::methods;
    if (tags_.front().starts_with("_ihm_sphere_obj_site.")) return Table::spheres;
    if (MmcifComponent::wants(tags_.front()) && component_.empty()) {
      component_.begin(tags_);
      component_block_ = block_;
      return Table::component;
    }
    if (MmcifEntityTables::wants(tags_.front())) return Table::entity;
    if (MmcifBondTable::wants(tags_.front())) return Table::bonds;
    if (MmcifSecondaryTables::wants(tags_.front())) return Table::secondary;
    if (!tags_.front().starts_with(kAtomSite)) return Table::other;
    if (builder_.size() > 0 && block_ != atoms_block_) {
      ++ignored_blocks_;
      return Table::other;
    }
    atoms_block_ = block_;
    where_.fill(std::nullopt);
    for (std::size_t k = 0; k < tags_.size(); ++k) {
      if (!tags_[k].starts_with(kAtomSite)) continue;  // the loop mixes tables
      const std::string_view name = std::string_view(tags_[k]).substr(kAtomSite.size());
      for (std::size_t c = 0; c < kColumnCount; ++c) {
        if (kColumnTags[c] == name) where_[c] = k;
      }
    }
    for (const Column c : {kX, kY, kZ}) {
      if (!where_[c]) {
        fail(0, "the atom_site table has no column Cartn_" + std::string(1, "xyz"[c - kX]),
             "Only files with Cartesian coordinates can be read");
      }
    }
    return Table::atoms;
  }

  std::string_view value(Column column) const {
    return where_[column] ? plain_cif(row_[*where_[column]].raw) : std::string_view();
  }
  std::string_view value(Column first, Column second) const {
    const std::string_view text = value(first);
    return text.empty() ? value(second) : text;
  }

  // Open Babel writes no chain names, but numbers of chains as entities.
  std::string_view chain(Column first, Column second) const {
    return where_[first] || where_[second] ? value(first, second) : value(kEntityId);
  }

  void take_row() {
    if (++rows_ % kProgressRows == 0) {
      const char* const end = input_.text.data() + input_.text.size();
      input_.report(static_cast<std::size_t>(end - row_[0].raw.data()));
    }
    NameTable& names = builder_.molecule().names;
    begin_model_if_new();
    Atom atom;
    const std::array<Decimal, 3> position = {coordinate(kX), coordinate(kY), coordinate(kZ)};
    atom.source_line = static_cast<std::uint32_t>(row_[0].line);
    atom.hetero = value(kGroup) == "HETATM";
    atom.serial = integer(kId, 0);
    atom.name = names.intern(value(kAuthAtom, kLabelAtom));
    atom.residue_name = names.intern(value(kAuthComp, kLabelComp));
    atom.chain = names.intern(chain(kAuthAsym, kLabelAsym));
    atom.label_chain = names.intern(chain(kLabelAsym, kAuthAsym));
    const std::string_view altloc = value(kAltloc), insertion_code = value(kInsertionCode);
    if (!altloc.empty()) atom.altloc = altloc[0];
    if (!insertion_code.empty()) atom.insertion_code = insertion_code[0];
    atom.residue_number = integer(kAuthSeq, integer(kLabelSeq, 0));
    atom.occupancy = real(kOccupancy, 1);
    take_b_factor(real(kBFactor, kNoNumber), atom);
    // A symbol for "no known element" (X) leaves the element unknown.
    const StatedElement stated = stated_element(trimmed(value(kSymbol)));
    const ResidueFamily family = guesser_.identify(atom, stated, NamePlace::free, names);
    atom.kind = residue_kind(family, atom.hetero);
    builder_.set_record(
        {.entity = names.intern(value(kEntityId)), .numbered = !value(kLabelSeq).empty()});
    builder_.add(atom, position);
  }

  void begin_model_if_new() {
    const std::int32_t number = integer(kModel, 1);
    if (!models_.empty() && number == model_) return;
    if (!models_.insert(number).second) {
      fail(row_[0].line, "the atoms of model " + std::to_string(number) + " are not together",
           "Sort the atom_site table by pdbx_PDB_model_num");
    }
    model_ = number;
    builder_.begin_model(number);
  }

  Decimal coordinate(Column column) const {
    return cif_coordinate(input_.source, row_[*where_[column]], "xyz"[column - kX]);
  }

  std::int32_t integer(Column column, std::int32_t fallback) const {
    const std::string_view text = value(column);
    std::int32_t number = fallback;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
  }

  float real(Column column, float fallback) const {
    std::string_view text = value(column);
    Decimal number;
    text = text.substr(0, text.find('('));
    return parse_decimal(text, number) == DecimalStatus::ok ? static_cast<float>(number.to_double())
                                                            : fallback;
  }

  [[noreturn]] void refuse_without_atoms() const {
    if (fractional_) {
      fail(0, "this is a small-molecule CIF with fractional coordinates, not mmCIF",
           "Convert it to PDB, mmCIF or XYZ with Cartesian coordinates first");
    }
    fail(0, "the CIF file holds no atoms: there is no atom_site table",
         "Check that it is the coordinate file and not, for example, structure factors");
  }

  [[noreturn]] void fail(std::size_t line, std::string reason, std::string remedy) const {
    throw ReadError(input_.source, line, std::move(reason), std::move(remedy));
  }

  const ReaderInput& input_;
  MoleculeBuilder builder_;
  AtomGuesser guesser_;
  MmcifAssemblyTables assemblies_;
  MmcifEntityTables entities_;
  MmcifBondTable bonds_;
  MmcifSecondaryTables secondary_;
  std::vector<std::string> tags_, single_tags_;
  std::vector<CifValue> row_, single_row_;
  MmcifComponent component_;
  PredictedModel predicted_;
  std::size_t sphere_values_ = 0, sphere_columns_ = 1;
  std::array<std::optional<std::size_t>, kColumnCount> where_{};
  std::string item_;
  std::set<std::int32_t> models_;
  std::int32_t model_ = 0;
  std::size_t rows_ = 0, column_ = 0, ignored_blocks_ = 0;
  int block_ = 0, atoms_block_ = 0, component_block_ = 0;
  Table kind_ = Table::undecided;
  bool fractional_ = false;
};

Molecule read_mmcif(const ReaderInput& input) {
  MmcifReader reader(input);
  try {
    parse_cif(input.text, reader);
  } catch (const CifSyntaxError& error) {
    throw ReadError(input.source, error.line(),
                    "this is not correct CIF: " + std::string(error.what()),
                    "The file is truncated or damaged; fetch it again");
  }
  return reader.finish();
}

Recognised recognise_mmcif(const FileSample& sample) {
  const std::string_view first = trimmed(sample.first);
  const bool begins = lower_case(first.substr(0, 5)) == "data_";
  return begins ? Recognised::likely : Recognised::by_ending;
}

}  // namespace

FileFormat mmcif_format() {
  return {"mmcif", "mmCIF", {".cif", ".mmcif"}, recognise_mmcif, read_mmcif};
}

}  // namespace alphascope
