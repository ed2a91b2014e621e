// SPDX-License-Identifier: GPL-3.0-or-later
// Describes where a result comes from, as lines for the head of its files. Window and command line
// write the same lines.
#pragma once

#include <string>
#include <string_view>

#include "core/document/export/record_source.hpp"
#include "core/document/store/answer.hpp"
#include "core/selection/provenance.hpp"
#include "core/write/write_complex.hpp"

namespace alphascope {

ProgramName program_named(std::string_view program);
// For example "alphascope-cli 0.2.0 (0123456789ab)".
std::string program_text(std::string_view program);

// `program`, then `balls`, then the request and its answer, then the notes of the molecule's reader
// and of the engine.
ComplexHeader result_header(std::string_view program, const Provenance& balls,
                            const std::vector<std::string>& notes, const EngineAnswer& answer);

// The same as texts of a picture (docs/output-files.md).
std::vector<std::pair<std::string, std::string>> picture_texts(const ComplexHeader& header);

}  // namespace alphascope
