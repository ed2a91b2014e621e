// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli fetch: fetches molecules by their id, and prints or copies their files.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/cli/command.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/input.hpp"
#include "app/cli/many_files.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/options/fetch_flags.hpp"
#include "core/document/fetch/molecule_id.hpp"
#include "core/files/fetched_file.hpp"
#include "core/files/read_error.hpp"
#include "core/files/read_options.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/text_file.hpp"

namespace alphascope::cli {
namespace {

namespace fs = std::filesystem;

struct FetchCommandOptions {
  std::vector<std::string> ids;
  InputOptions input;  // only its options of ids
  std::string out;     // "-": standard output; empty: none
};

// Here a file does not win over an id. So an id is fetched even in a folder with a file of its
// name.
MoleculeId id_of(const std::string& typed) {
  try {
    if (auto id = molecule_id(typed)) return *id;
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(error.what()) + ".");
  }
  throw UsageError("\"" + typed + "\" is not a valid id. Ids look like pdb:1CRN and af:P69905.");
}

// Writes the text, or the file as it was fetched if the name of the copy ends in .gz.
void copy(const fs::path& file, const std::string& out, AtomicFile& to) {
  if (!out.ends_with(".gz")) {
    to.write(load_text(file, ReadOptions{}.max_bytes, run_context()).text);
    return;
  }
  if (!file.string().ends_with(".gz")) {
    throw UsageError("--output " + out +
                     ": models of AlphaFold DB are not packed. Leave out .gz in the name.");
  }
  std::ifstream in(file, std::ios::binary);
  std::vector<char> bytes(std::size_t{1} << 20);
  while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())), in.gcount() > 0) {
    run_context().cancel.throw_if_cancelled();
    to.write({bytes.data(), static_cast<std::size_t>(in.gcount())});
  }
  if (in.bad()) throw ReadError(file, 0, "reading stopped", "Check the disk");
}

ExitCode run_fetch(const FetchCommandOptions& options) {
  if (options.out.empty()) {
    return for_each_file(options.ids, options.ids.size() > 1,
                         [&](const std::string& typed) {
                           const fs::path file =
                               fetched_file(id_of(typed), options.input, run_context());
                           clear_progress();
                           std::cout << printable(file.string()) << std::endl;
                         })
        .code;
  }
  if (options.ids.size() > 1) throw UsageError("--output takes the file of one id.");
  const MoleculeId id = id_of(options.ids.front());
  std::error_code ignored;
  if (fs::is_regular_file(options.out, ignored)) {
    throw UsageError("--output " + options.out +
                     ": this file exists. Give another name, or remove the file.");
  }
  Outputs outputs({});
  AtomicFile* const to = outputs.add("--output", options.out, {".cif", ".gz"});
  const fs::path file = fetched_file(id, options.input, run_context());
  copy(file, options.out, *to);
  outputs.commit();
  clear_progress();
  if (verbosity() != Verbosity::quiet) {
    std::cout << "file        " << printable(options.out) << "\n";
    if (const auto from = fetched_from(file)) std::cout << "fetched     " << from->text() << "\n";
    std::cout << std::flush;
  }
  return ExitCode::ok;
}

OptionCommand table_of_fetch(FetchCommandOptions& options) {
  return {"fetch",
          "Fetch molecules by their id, and print the names of the files",
          {required(texts_option({"ID", "ID",
                                  "Entry of the PDB (pdb:1CRN) or model of AlphaFold "
                                  "DB (af:P69905)"},
                                 options.ids)),
           text_option({"-o,--output", "OUT.cif",
                        "Copy the file: unpacked to OUT.cif, packed to OUT.cif.gz; - for standard "
                        "output. An existing file is never replaced"},
                       options.out),
           offline_option(options.input.offline), fetch_again_option(options.input.fetch_again)}};
}

}  // namespace

Command fetch_command() {
  return make_command<FetchCommandOptions>(table_of_fetch, run_fetch,
                                           {"alphascope-cli fetch pdb:1CRN -o 1crn.cif"});
}

}  // namespace alphascope::cli
