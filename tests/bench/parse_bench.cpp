// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the speed of our readers with gemmi's, in one process: parse_bench [RUNS] FILE...
//
// In memory: the unpacked text becomes a molecule. MB are 10^6 bytes of text. From disk: opening a
// file as a whole, with unpacking and, for ours, the SHA-256. Results are medians. Both readers
// take turns, so a machine that slows down affects both. Times are CPU times of all threads of the
// process, so other users of the machine matter little. All work is on one thread but the hash of
// large unpacked files.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <gemmi/cif.hpp>
#include <gemmi/gz.hpp>
#include <gemmi/mmcif.hpp>
#include <gemmi/mmread.hpp>
#include <gemmi/pdb.hpp>
#include <gemmi/version.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/read_molecule.hpp"
#include "core/text_files/text_file.hpp"
#include "tests/bench/times.hpp"

namespace {

using namespace alphascope;

using bench::median;

double cpu_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

template <class Work>
double timed(Work work) {
  const double start = cpu_milliseconds();
  work();
  return cpu_milliseconds() - start;
}

// Keeps the compiler from removing the readers' work.
std::size_t atoms_seen = 0;

void read_with_gemmi(const FileFormat* format, std::string_view text) {
  gemmi::Structure structure;
  if (format == format_from_id("pdb")) {
    structure = gemmi::read_pdb_from_memory(text.data(), text.size(), "bench");
  } else {
    gemmi::cif::Document document = gemmi::cif::read_memory(text.data(), text.size(), "bench");
    structure = gemmi::make_structure(document);
  }
  if (!structure.models.empty()) atoms_seen += structure.models[0].chains.size();
}

struct Times {
  std::vector<double> ours, gemmi;  // ms
};

std::string number_or_dash(double number, bool known, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return known ? text : "-";
}

void measure(const std::filesystem::path& path, int runs) {
  const LoadedText loaded = load_text(path, std::uint64_t{4} << 30, {});
  const FileFormat* const format = recognise_format(path, loaded.text);
  const bool gemmi_too = format == format_from_id("pdb") || format == format_from_id("mmcif");
  Times memory, disk;
  std::size_t atoms = 0;
  std::string name;
  for (int run = 0; run < runs; ++run) {
    memory.ours.push_back(timed([&] {
      const Molecule m = read_format(format, {path, loaded.text, {}});
      atoms = m.atoms.size();
      name = m.format;
    }));
    if (gemmi_too) memory.gemmi.push_back(timed([&] { read_with_gemmi(format, loaded.text); }));
    disk.ours.push_back(timed([&] { atoms_seen += read_molecule(path).atoms.size(); }));
    if (gemmi_too) {
      disk.gemmi.push_back(timed([&] {
        atoms_seen += gemmi::read_structure(gemmi::MaybeGzipped(path.string())).models.size();
      }));
    }
  }
  const double megabytes = static_cast<double>(loaded.text.size()) / 1e6;
  const double ours = median(memory.ours), ours_disk = median(disk.ours);
  const double theirs = gemmi_too ? median(memory.gemmi) : 0;
  const double theirs_disk = gemmi_too ? median(disk.gemmi) : 0;
  std::printf("%-24s %-10s %9zu %7.2f  %8.2f %7.0f %8s %7s %6s   %8.2f %8s %6s\n",
              path.filename().c_str(), name.c_str(), atoms, megabytes, ours,
              megabytes * 1000 / ours, number_or_dash(theirs, gemmi_too, 2).c_str(),
              number_or_dash(megabytes * 1000 / theirs, gemmi_too, 0).c_str(),
              number_or_dash(ours / theirs, gemmi_too, 2).c_str(), ours_disk,
              number_or_dash(theirs_disk, gemmi_too, 2).c_str(),
              number_or_dash(ours_disk / theirs_disk, gemmi_too, 2).c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int first = 1, runs = 11;
  if (argc > 1 && static_cast<int>(std::strtol(argv[1], nullptr, 10)) > 0)
    runs = static_cast<int>(std::strtol(argv[first++], nullptr, 10));
  if (first >= argc) {
    std::fprintf(stderr, "usage: %s [RUNS] FILE...\n", argv[0]);
    return 2;
  }
  std::printf("medians of %d runs; ratio = ours / gemmi %s\n", runs, GEMMI_VERSION);
  std::printf("%-24s %-10s %9s %7s  %8s %7s %8s %7s %6s   %8s %8s %6s\n", "file", "format", "atoms",
              "MB", "ms", "MB/s", "gemmi ms", "MB/s", "ratio", "disk ms", "gemmi", "ratio");
  for (int k = first; k < argc; ++k) {
    try {
      measure(argv[k], runs);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
  }
  return atoms_seen == 0;
}
