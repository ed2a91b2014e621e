// The cavities of one molecule with one set of radii and one solvent radius, and all that is
// reported of them. Used by the sources of alphascope-cli cavities.
#pragma once

#include <string>
#include <vector>

#include "app/cli/commands.hpp"
#include "app/cli/input.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavity_contents.hpp"
#include "core/document/cavity_names.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope::cli {

// By row of the table, where nothing else is said.
struct CavityAnswer {
  Input input;
  Request request;
  CavityTable table;
  std::vector<ClippedMeasures> exact;     // of table.found.cavities
  std::vector<std::size_t> clipped_rank;  // 1: the largest clipped volume
  std::vector<double> depth_angstrom;
  CavityLives lives;
  CavityContents contents;
  BallReferences atoms;
  std::vector<std::size_t> rows;  // those to report: not below the volume asked for

  StageTimes times;
  std::vector<std::string> differences;  // from what CASTp takes
  std::string device;                    // "CPU, 2 threads"

  explicit CavityAnswer(const Input& of)
      : input(of), atoms(of.opened.molecule, of.opened.prepared) {}

  const ClippedMeasures& clipped(std::size_t row) const { return exact[table.order[row]]; }
  bool is_doubtful(std::size_t row) const;
  const char* kind(std::size_t row) const {
    return table.cavity(row).is_void() ? "void" : "pocket";
  }
  // "A:HEM 142 (41 of 43 atoms)"; "" when it holds nothing.
  std::string contents_text(std::size_t row) const;
  // Å²; the solvent radius stays.
  struct Life {
    double born, closed, gone;
    bool closes;  // it is a void from `closed` on
  };
  Life life(std::size_t row) const;
};

// Throws Cancelled.
CavityAnswer find_cavities_of(const Input& input, const CavitiesOptions& options,
                              double solvent_radius_angstrom, const RunContext& context);

std::string comparable_text(const CavityAnswer& answer);
// What a reader must know of the numbers.
std::vector<std::string> notes_of(const CavityAnswer& answer, const CavitiesOptions& options);

// As text on standard output.
void print_cavities(const CavityAnswer& answer, const CavitiesOptions& options);

}  // namespace alphascope::cli
