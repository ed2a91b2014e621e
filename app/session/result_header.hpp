// Where a result comes from, for whatever is written of it: the same for window and command line.
#pragma once

#include <string>
#include <string_view>

#include "core/document/export/record_source.hpp"
#include "core/document/store/answer.hpp"
#include "core/selection/provenance.hpp"
#include "core/write/write_complex.hpp"

namespace alphascope {

ProgramName program_named(std::string_view program);
// "alphascope-cli 0.1.0 (0123456789ab)".
std::string program_text(std::string_view program);

// `program`, then `balls`, then what was asked of an engine and what it answered, then the notes of
// the molecule's reader and the engine's.
ComplexHeader result_header(std::string_view program, const Provenance& balls,
                            const std::vector<std::string>& notes, const EngineAnswer& answer);

// The same as texts of a picture (docs/output-files.md).
std::vector<std::pair<std::string, std::string>> picture_texts(const ComplexHeader& header);
// Where some are hidden, says so: nobody sees it in a saved picture.
void note_hidden_atoms(std::vector<std::pair<std::string, std::string>>& texts, std::size_t hidden);

}  // namespace alphascope
