// Whether B factors are no displacements but the confidences (pLDDT) of a predicted model, as the
// file itself says.
#pragma once

#include <string_view>

#include "core/molecule/molecule.hpp"

namespace alphascope {

class PredictedModel {
 public:
  // A line of remarks in a PDB file: AlphaFold's disclaimer, or what names pLDDT.
  void take_remark(std::string_view line);
  // A value of mmCIF's ma_qa_metric.
  void take_metric(std::string_view value);
  // EXPDTA or exptl.method: of an experiment, which may have begun with a predicted model.
  void take_method(std::string_view method);

  // Marks the molecule and says so. Its title is set; values beyond 0 to 100 are no confidences.
  void finish(Molecule& molecule) const;

 private:
  bool says_so_ = false, measured_ = false;
};

}  // namespace alphascope
