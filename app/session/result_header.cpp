// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the header from molecule, request and answer.
#include "app/session/result_header.hpp"

#include "app/session/rounding_note.hpp"
#include "app/session/version.hpp"
#include "core/geometry/shortest_number.hpp"

namespace alphascope {

ProgramName program_named(std::string_view program) {
  return {std::string(program), std::string(program_version()), std::string(program_commit())};
}

std::string program_text(std::string_view program) {
  return program_named(program).text();
}

ComplexHeader result_header(std::string_view program, const Provenance& balls,
                            const std::vector<std::string>& notes, const EngineAnswer& answer) {
  const Request& request = answer.request;
  const AlphaComplex& complex = answer.complex;
  ComplexHeader header{{"program", program_text(program)}};
  header.insert(header.end(), balls.begin(), balls.end());
  // The lattice is that of the complex, since the solvent radius may need a finer one than the
  // molecule.
  for (auto& [key, value] : header) {
    if (key == "lattice_unit_angstrom") value = lattice_unit_text(complex.lattice);
  }
  const ComplexHeader rest{
      {"alpha_angstrom2", shortest_number(request.alpha_angstrom2)},
      {"alpha_used_square_lattice_units", shortest_number(complex.alpha_on_lattice)},
      {"solvent_radius_angstrom", shortest_number(request.solvent_radius_angstrom)},
      {"solvent_rounding_angstrom",
       shortest_number(solvent_rounding_angstrom(request, complex.lattice))},
      {"tetrahedra_only", complex.tetrahedra_only ? "1" : "0"},
      {"engine",
       complex.engine.name + ", " + complex.engine.device + " (" + complex.engine.route + ")"},
      {"hash", hash_text(complex.hash)}};
  header.insert(header.end(), rest.begin(), rest.end());
  for (const std::string& note : notes) header.emplace_back("note", note);
  if (!answer.note.empty()) header.emplace_back("note", answer.note);
  return header;
}

std::vector<std::pair<std::string, std::string>> picture_texts(const ComplexHeader& header) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const auto& [key, value] : header) {
    texts.emplace_back(key == "program" ? "Software" : "alphascope:" + key, value);
  }
  return texts;
}

}  // namespace alphascope
