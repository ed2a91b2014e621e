// SPDX-License-Identifier: GPL-3.0-or-later
// Decides from the file's own statements whether B factors are confidences (pLDDT) of a predicted
// model.
#pragma once

#include <string_view>

#include "core/molecule/molecule.hpp"

namespace alphascope {

class PredictedModel {
 public:
  // A remark of a PDB file: AlphaFold's disclaimer, or a remark that names pLDDT.
  void take_remark(std::string_view line);
  // A value of mmCIF's ma_qa_metric.
  void take_metric(std::string_view value);
  // EXPDTA or exptl.method. It names an experiment, so B factors are no confidences, even if the
  // model was built from a predicted one.
  void take_method(std::string_view method);

  // Marks the molecule and adds a note. The title must be set. Values outside 0 to 100 are no
  // confidences.
  void finish(Molecule& molecule) const;

 private:
  bool says_so_ = false, measured_ = false;
};

}  // namespace alphascope
