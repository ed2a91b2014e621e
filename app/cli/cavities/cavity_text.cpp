// Prints the table of cavities for people.
#include <iostream>

#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/text/table.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "core/text/fixed_digits.hpp"

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

Table cavity_columns() {
  return Table({{"#", 4},
                {"kind", 6, true},
                {"SA vol Å³", 11},
                {"SA area Å²", 11},
                {"clipped Å³", 11},
                {"", 1, true},
                {"rank", 4},
                {"MS vol Å³", 11},
                {"MS area Å²", 11},
                {"mouths", 6},
                {"mouth Å²", 9},
                {"depth Å", 7},
                {"residues", 8},
                {"name (atoms of the deepest sink)", 0, true}});
}

std::string line(const Table& columns, const CavityAnswer& answer, std::size_t row) {
  const CavityMeasures& m = answer.table().measure(row);
  const auto number = [](double value) { return fixed_digits(value, 3); };
  const std::string held = answer.contents_text(row);
  const bool exact = answer.exact != nullptr;
  return columns.line(
      {std::to_string(row + 1), answer.kind(row), number(m.volume_sa_angstrom3),
       number(m.area_sa_angstrom2), exact ? number(answer.clipped(row).volume_sa_angstrom3) : "-",
       exact && answer.is_doubtful(row) ? "*" : "",
       exact ? std::to_string(answer.clipped_rank[row]) : "-", number(m.volume_ms_angstrom3),
       number(m.area_ms_angstrom2), std::to_string(m.mouths.size()),
       number(m.all_mouths().area_angstrom2), format_text("%.1f", answer.depths->of_angstrom[row]),
       std::to_string(lining_counts(*answer.atoms, answer.table(), row).residues),
       answer.name(row) + (held.empty() ? "" : "  holds " + held)});
}

void print_rows(const CavityAnswer& answer, std::size_t shown) {
  if (answer.rows.empty() || shown == 0) return;
  const Table columns = cavity_columns();
  std::cout << columns.heading();
  for (std::size_t k = 0; k < std::min(shown, answer.rows.size()); ++k) {
    std::cout << line(columns, answer, answer.rows[k]);
  }
  if (answer.rows.size() > shown) {
    std::cout << "… and " << grouped(answer.rows.size() - shown)
              << " smaller ones; --show sets how many are printed\n";
  }
  if (verbosity() != Verbosity::quiet) {
    std::cout << "SA: of the region of the probe's centre, MS: of what the probe reaches; CASTp's "
                 "sums. clipped: of the tetrahedra outside all balls, exact, and its rank. "
                 "* below 1 Å³, or SA and clipped differ by more than a tenth\n";
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
