// SPDX-License-Identifier: GPL-3.0-or-later
// Reads annotations from the words of a command line.
#include "core/document/reference/annotations.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/document/reference/atom_labels.hpp"
#include "core/document/reference/atom_words.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"

namespace alphascope {
namespace {

constexpr const char* kWhat = "their label";
constexpr const char* kExample = "resn HEM=residue";

std::string known_labels() {
  std::string all;
  for (const auto& [text, id] : label_text_ids()) {
    all += (all.empty() ? "" : ", ") + std::string(id);
  }
  return all;
}

LabelText label_named(const AtomWord& word) {
  for (const auto& [text, id] : label_text_ids()) {
    if (word.word == id) return text;
  }
  refuse_atom_word(word.part, kWhat,
                   std::string(kExample) + " (labels are " + known_labels() + ")");
}

}  // namespace

Annotations read_annotations(const BallReferences& atoms, const AnnotationWords& words) {
  Annotations read;
  const Molecule& molecule = atoms.molecule();
  for (const AtomWord& word : atom_words(molecule, words.labels, kWhat, kExample)) {
    set_labels(read.labels, word.atoms, label_named(word));
  }
  if (label_count(molecule, read.labels) > kMostLabels) {
    throw std::invalid_argument("more than " + std::to_string(kMostLabels) +
                                " labels are not drawn; name fewer atoms");
  }
  for (const std::string& measurement : words.measurements) {
    if (read.measurements.size() == kMostMeasurements) {
      throw std::invalid_argument("more than " + std::to_string(kMostMeasurements) +
                                  " measurements are not drawn");
    }
    read.measurements.push_back(read_measurement(atoms, measurement));
  }
  return read;
}

}  // namespace alphascope
