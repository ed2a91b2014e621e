// SPDX-License-Identifier: GPL-3.0-or-later
// Searches remarks, titles and metrics for signs of a predicted model.
#include "core/read/predicted_model.hpp"

#include <algorithm>
#include <string>

#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kPrograms[] = {"ALPHAFOLD", "ESMFOLD", "COLABFOLD"};

// True for "ALPHAFOLD MONOMER V2.0 PREDICTION FOR ALBUMIN (P02768)".
bool is_title_of_prediction(std::string_view title) {
  const std::string text = upper_case(title);
  return text.find("PREDICTION") != text.npos &&
         std::any_of(std::begin(kPrograms), std::end(kPrograms),
                     [&](std::string_view program) { return text.starts_with(program); });
}

}  // namespace

void PredictedModel::take_remark(std::string_view line) {
  const std::string text = upper_case(line);
  says_so_ = says_so_ || text.find("PLDDT") != text.npos ||
             text.find("PREDICTED LDDT") != text.npos ||
             text.find("ALPHAFOLD DATA, COPYRIGHT") != text.npos;
}

void PredictedModel::take_metric(std::string_view value) {
  says_so_ = says_so_ || upper_case(value).find("PLDDT") != std::string::npos;
}

void PredictedModel::take_method(std::string_view method) {
  const std::string text = upper_case(method);
  const bool none = text.find_first_not_of(" ?.") == text.npos;
  const bool model = text.find("THEORETICAL") != text.npos || text.find("PREDICT") != text.npos ||
                     text.find("COMPUTATIONAL") != text.npos || text.find("AB INITIO") != text.npos;
  measured_ = measured_ || (!none && !model);
}

void PredictedModel::finish(Molecule& molecule) const {
  if (measured_ || !(says_so_ || is_title_of_prediction(molecule.title))) return;
  const bool within = std::all_of(molecule.atoms.begin(), molecule.atoms.end(), [](const Atom& a) {
    return !a.has_b_factor || (a.b_factor >= 0 && a.b_factor <= 100);
  });
  const bool some = std::any_of(molecule.atoms.begin(), molecule.atoms.end(),
                                [](const Atom& a) { return a.has_b_factor; });
  if (!within || !some) return;
  molecule.has_confidences = true;
  molecule.notes.push_back(
      "This is a predicted model: its B factors are confidences (pLDDT, high is good)");
}

}  // namespace alphascope
