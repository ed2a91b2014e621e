// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the table of cavities for people.
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/text/printed_columns.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_columns.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope::cli {
namespace {

std::string totals_text(const CavityTable& table) {
  const auto kind = [&](bool voids, std::size_t number) {
    return grouped(number) + ", SA volume " +
           format_text("%.3f", table.volume_sa_angstrom3(voids)) + " Å³, SA area " +
           format_text("%.3f", table.area_sa_angstrom2(voids)) + " Å²\n";
  };
  return "voids       " + kind(true, table.voids) + "pockets     " + kind(false, table.pockets) +
         "mouths      " + grouped(table.mouths) + "\n";
}

constexpr PrintedColumn kPrinted[] = {{"id", 4},
                                      {"kind", 6, true},
                                      {"volume_sa_angstrom3", 11},
                                      {"area_sa_angstrom2", 11},
                                      {"volume_sa_clipped_angstrom3", 11},
                                      {.id = "doubtful", .width = 1, .left = true, .none = ""},
                                      {"rank_by_clipped_volume", 4},
                                      {"volume_ms_angstrom3", 11},
                                      {"area_ms_angstrom2", 11},
                                      {"mouths", 6},
                                      {"mouth_area_angstrom2", 9},
                                      {.id = "depth_angstrom", .width = 7, .decimals = 1},
                                      {"lining_residues", 8},
                                      {.id = "polar_lining_percent", .width = 7, .decimals = 1},
                                      {"name", 0, true}};

void print_rows(const CavityAnswer& answer, std::size_t shown) {
  if (answer.rows.empty() || shown == 0) return;
  const PrintedTable<CavityRow> table(cavity_columns(), kPrinted);
  std::cout << table.heading();
  for (std::size_t k = 0; k < std::min(shown, answer.rows.size()); ++k) {
    const std::size_t row = answer.rows[k];
    std::vector<std::string> cells = table.cells({answer, row, &answer});
    const std::string held = answer.contents_text(row);
    if (!held.empty()) cells.back() += "  holds " + held;
    std::cout << table.line(cells);
  }
  if (answer.rows.size() > shown) {
    std::cout << "… and " << grouped(answer.rows.size() - shown)
              << " smaller ones; --show sets how many are printed\n";
  }
  if (verbosity() != Verbosity::quiet) {
    std::cout
        << "SA: the region of the probe's centre; MS: the region that the probe reaches; both as "
           "CASTp sums them. exact: the part of the cavity's tetrahedra outside all balls, and its "
           "rank. *: below 1 Å³, or SA and exact volume differ by more than a tenth\n";
  }
}

}  // namespace

void print_cavities(const CavityAnswer& answer, const CavitiesOptions& options) {
  const Request& request = answer.request;
  std::cout << input_text(answer.input) << "sha256      " << answer.input.molecule().sha256 << "\n"
            << "alpha       " << shortest_number(request.alpha_angstrom2) << " Å², solvent radius "
            << shortest_number(request.solvent_radius_angstrom) << " Å\n"
            << "choices     " << comparable_text(answer.differences) << "\n"
            << totals_text(answer.table());
  if (verbosity() != Verbosity::quiet) {
    for (const std::string& note : notes_of(answer, options))
      std::cout << "note        " << note << "\n";
  }
  if (times_shown()) {
    std::cout << "time        " << milliseconds_text(answer.times.wall_milliseconds) << " ("
              << answer.device << ")\n";
    for (const StageTime& s : answer.times.stages) {
      std::cout << "            " << s.label << " " << milliseconds_text(s.milliseconds) << "\n";
    }
  }
  print_rows(answer, static_cast<std::size_t>(options.shown));
  std::cout << std::flush;
}

}  // namespace alphascope::cli
