// SPDX-License-Identifier: GPL-3.0-or-later
// Words of a caption: one function for each part.
#include "ui/caption.hpp"

#include <cstdint>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_class.hpp"
#include "core/document/picture/caption_parts.hpp"
#include "core/document/store/answer.hpp"
#include "core/engine/known_results.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/printable.hpp"
#include "ui/number_text.hpp"

namespace alphascope {
namespace {

std::string counts_text(const AlphaComplex& c) {
  const std::string tetrahedra = counted(c.tetrahedra.size(), "tetrahedron", "tetrahedra");
  if (c.tetrahedra_only) return tetrahedra;
  return counted(c.vertices.size(), "vertex", "vertices") + ", " +
         counted(c.edges.size(), "edge", "edges") + ", " +
         counted(c.triangles.size(), "triangle", "triangles") + ", " + tetrahedra;
}

// Shows all digits of a typed alpha, since a rounded alpha may give another complex.
std::string alpha_text(const Alpha& alpha) {
  constexpr int kDecimals = 6;
  constexpr std::int64_t kBeyondThem = Alpha::kParts / 1000000;
  if (alpha.is_decimal() && alpha.fraction() % kBeyondThem != 0) {
    return with_minus_signs(alpha.digits());
  }
  return short_number_text(alpha, kDecimals);
}

}  // namespace

std::vector<std::string> caption_words(const EngineAnswer& answer, const Molecule& molecule,
                                       const std::string& radii, CaptionParts parts) {
  constexpr int kSolventDecimals = 4;  // at most
  const AlphaComplex& c = answer.complex;
  const double solvent = answer.request.solvent_radius_angstrom;
  std::vector<std::string> words;
  const auto add = [&](CaptionPart part, const std::string& text) {
    if (parts.has(part) && !text.empty()) words.push_back(text);
  };
  add(CaptionPart::file, printable(molecule.source.filename().string()));
  add(CaptionPart::alpha, "α = " + alpha_text(answer.request.alpha_angstrom2) + " Å²");
  if (solvent > 0) {
    add(CaptionPart::solvent, "solvent " + short_number_text(solvent, kSolventDecimals) + " Å");
  }
  if (!radii.empty()) add(CaptionPart::radii, "radii: " + printable(radii));
  add(CaptionPart::counts, counts_text(c));
  add(CaptionPart::engine, c.engine.name + " on " + c.engine.device);
  add(CaptionPart::hash, "hash " + hash_text(c.hash));
  return words;
}

}  // namespace alphascope
