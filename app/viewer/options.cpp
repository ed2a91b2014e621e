// CLI11 does the parsing; what it would print is handed to main().
#include "app/viewer/options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <sstream>

namespace alphascope {
namespace {

constexpr int kLeastSize = 640, kMostSize = 8192;

// "1280x800" to width and height; an error text otherwise.
std::string parse_size(const std::string& text, int& width, int& height) {
  char x = 0;
  std::istringstream stream(text);
  if (stream >> width >> x >> height && (x == 'x' || x == 'X') && stream.peek() == EOF &&
      std::min(width, height) >= 480 && width >= kLeastSize &&
      std::max(width, height) <= kMostSize) {
    return {};
  }
  return "'" + text + "' is no size; write WIDTHxHEIGHT from 640x480 to 8192x8192, as 1280x800";
}

}  // namespace

ParsedOptions parse_options(int argc, const char* const* argv) {
  ParsedOptions parsed;
  ViewerOptions& o = parsed.options;
  CLI::App app{"Alphascope: the exact alpha complex of a molecule, live.", "alphascope"};
  app.set_version_flag("--version", std::string("alphascope ") + ALPHASCOPE_VERSION);
  app.footer(
      "Examples:\n"
      "  alphascope 4hhb.pdb.gz --alpha 1.4\n"
      "  alphascope 4hhb.pdb.gz --solvent 1.4 --shot picture.png   (needs no display)\n"
      "Exit codes: 0 done, 1 bad arguments, 2 no display, 3 could not do what was asked.");
  std::string size;
  bool no_compare = false;
  app.add_option("FILE", o.file, "Molecule to open: PDB, mmCIF, XYZR, PQR, XYZ, CRD; plain or .gz");
  const auto finite = [](const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return end != text.c_str() && *end == '\0' && std::isfinite(value)
               ? std::string()
               : "'" + text + "' is not a finite number";
  };
  app.add_option("--alpha", o.alpha, "Alpha (Å²)")->check(finite);
  app.add_option("--solvent", o.solvent, "Solvent radius (Å), 1.4 for water")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--scale", o.scale, "Size of fonts and controls, 1 = 100 %")
      ->check(CLI::Range(0.5, 4.0));
  app.add_option("--size", size, "Window size, WIDTHxHEIGHT at scale 1")
      ->check([&o](const std::string& text) { return parse_size(text, o.width, o.height); });
  app.add_flag("--light", o.light, "Light theme");
  app.add_flag("--tetrahedra-only", o.tetrahedra_only, "Compute tetrahedra only");
  app.add_flag("--no-compare", no_compare, "Do not compare with CGAL by itself");
  app.add_option("--drawing-memory", o.drawing_memory_mb,
                 "Draw as if so much memory were free (MB); otherwise what the system says")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 40));
  app.add_option("--script", o.script, "Drive the window by the commands in this file")
      ->check(CLI::ExistingFile);
  app.add_option("--shot", o.shot, "Write a picture of the window and exit; needs no display");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = app.exit(error, out, err);
    parsed.exit_code = code == 0 ? 0 : 1;
    parsed.text = out.str() + err.str();
  }
  o.compare = !no_compare;
  return parsed;
}

}  // namespace alphascope
