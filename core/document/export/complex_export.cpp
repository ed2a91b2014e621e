// SPDX-License-Identifier: GPL-3.0-or-later
// The list of export formats, and the class Exporter with a function for each.
#include "core/document/export/complex_export.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "core/chart/chart.hpp"
#include "core/chart/flat_svg.hpp"
#include "core/complex/own_dimension.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/measure/union_measures.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/chain_colours.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/run/work_threads.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/text/grouped_number.hpp"
#include "core/triangulation/boundary.hpp"
#include "core/write/complex_script.hpp"
#include "core/write/csv.hpp"
#include "core/write/write_balls.hpp"
#include "core/write/write_medit.hpp"
#include "core/write/write_mesh.hpp"
#include "core/write/write_vtk.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

// Most objects in a GLB or OBJ file, since viewers draw each object by itself. A large molecule at
// a small alpha has hundreds of thousands of solids.
constexpr std::size_t kMostObjects = 1000;

Mesh::Colour bytes(const Rgb8& c) {
  return {c.r, c.g, c.b};
}

std::string number_text(double number) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f", number);
  return text;
}

class Exporter {
 public:
  Exporter(const ExportSource& source, const RunContext& context)
      : source_(source), own_(*source.answer.balls, source.answer.complex), context_(context) {}

  // A function for each format, listed in kFormats.
  Lines ply(AtomicFile& file) { return with_unit(write_boundary(write_ply, file)); }
  Lines obj(AtomicFile& file) { return with_unit(write_boundary(write_obj, file, kMostObjects)); }
  Lines stl(AtomicFile& file) { return with_unit(with_pieces(write_boundary(write_stl, file))); }
  Lines off(AtomicFile& file) { return with_unit(write_boundary(write_off, file)); }
  Lines glb(AtomicFile& file) { return with_unit(write_boundary(write_glb, file, kMostObjects)); }
  Lines vtu(AtomicFile& file) {
    write_vtu(vtk_source(), file, context_);
    return simplices_text();
  }
  Lines vtp(AtomicFile& file) {
    write_vtp(vtk_source(), file, context_);
    return simplices_text();
  }
  Lines medit(AtomicFile& file) {
    write_medit(balls(), complex_, source_.header, file, context_);
    return simplices_text();
  }
  Lines xyzr(AtomicFile& file) {
    write_xyzr(balls(), source_.header, file, context_);
    return {balls_counted()};
  }
  Lines pqr(AtomicFile& file) {
    write_pqr(balls(), source_.molecule, source_.prepared.atom_of_ball, source_.header, file,
              context_);
    return {balls_counted()};
  }
  Lines alpha(AtomicFile& file) {
    write_complex_text(balls(), complex_, source_.header, file, context_);
    return simplices_text();
  }
  Lines parallelac(AtomicFile& file) {
    require_faces("ParallelAC's layout");
    write_parallelac_text(balls(), complex_, file, context_);
    return simplices_text();
  }
  Lines svg(AtomicFile& file) { return write_drawing(file); }
  Lines csv(AtomicFile& file) {
    write_counts(file);
    return {"counts and times of " + balls_counted()};
  }

  // Writes a script, and the balls and the surface that it opens.
  Lines script(std::string (*text)(const ComplexScript&), Lines (Exporter::*surface)(AtomicFile&),
               const std::vector<fs::path>& names, const std::vector<AtomicFile*>& files) {
    files[0]->write(text({fs::absolute(names[1]), fs::absolute(names[2]), groups(),
                          source_.colours == ExportColours::chain, source_.header}));
    Lines lines = pqr(*files[1]);
    const Lines more = (this->*surface)(*files[2]);
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
  }

 private:
  const BallSet& balls() const { return *source_.answer.balls; }
  VtkSource vtk_source() const {
    return {balls(), complex_, source_.molecule, source_.prepared.atom_of_ball, source_.header};
  }

  void require_faces(const char* what) const {
    if (!complex_.tetrahedra_only) return;
    throw std::invalid_argument(std::string(what) +
                                " holds edges and triangles, and only tetrahedra were computed. "
                                "Compute all simplices.");
  }

  const Boundary& boundary() {
    if (!boundary_) {
      boundary_ = make_boundary(*source_.answer.balls, complex_.tetrahedra.simplices, context_);
    }
    return *boundary_;
  }

  double volume_angstrom3(const BoundarySolid& solid) const {
    return solid.volume_cubic_units / std::pow(10.0, 3 * complex_.lattice.digits);
  }

  // Makes at most `most` meshes, one for each solid. The last mesh contains all remaining, smaller
  // solids.
  std::vector<Mesh> meshes(std::size_t most) {
    std::vector<Rgb8> colours;
    if (source_.colours != ExportColours::solid) {
      const auto of =
          source_.colours == ExportColours::chain ? colours_by_chain : colours_by_element;
      colours = of(source_.molecule, source_.prepared.atom_of_ball);
    }
    std::vector<Mesh> meshes;
    for (const BoundarySolid& solid : boundary().solids) {
      const std::size_t place = meshes.size();
      if (place < most) {
        Mesh& mesh = meshes.emplace_back();
        const bool several = place + 1 == most && most < boundary().solids.size();
        mesh.name = several ? "smaller_solids" : "solid_" + std::to_string(place + 1);
        const Rgb8 c = chart_colour(place);
        mesh.colour = {c.r, c.g, c.b};
      }
      append(solid, colours, meshes.back());
    }
    return meshes;
  }

  void append(const BoundarySolid& solid, const std::vector<Rgb8>& colours, Mesh& mesh) const {
    const auto before = static_cast<std::uint32_t>(mesh.points.size());
    if (before == 0) {
      mesh.points.reserve(solid.vertices);
      mesh.colours.reserve(colours.empty() ? 0 : solid.vertices);
      mesh.triangles.reserve(solid.triangles);
    }
    for (std::uint32_t n = 0; n < solid.vertices; ++n) {
      const BoundaryVertex& vertex = boundary_->vertices[solid.first_vertex + n];
      mesh.points.push_back(place_angstrom(*source_.answer.balls, vertex));
      if (!colours.empty()) mesh.colours.push_back(bytes(colours[vertex.ball]));
    }
    for (std::uint32_t n = 0; n < solid.triangles; ++n) {
      auto triangle = boundary_->triangles[solid.first_triangle + n];
      for (std::uint32_t& v : triangle) v = before + v - solid.first_vertex;
      mesh.triangles.push_back(triangle);
    }
  }

  Lines write_boundary(decltype(write_ply)* write_meshes, AtomicFile& file,
                       std::size_t most_meshes = std::numeric_limits<std::size_t>::max()) {
    write_meshes(meshes(most_meshes), source_.header, file, context_);
    const Boundary& b = boundary();
    double volume = 0;
    for (const BoundarySolid& solid : b.solids) volume += volume_angstrom3(solid);
    Lines lines{"boundary of " + counted(b.solids.size(), "solid", "solids") + ": " +
                grouped(b.triangles.size()) + " triangles, " + grouped(b.vertices.size()) +
                " vertices, " + number_text(volume) + " Å³"};
    if (b.solids.empty()) lines[0] = "no boundary: the complex has no tetrahedra";
    if (complex_.tetrahedra_only) return lines;
    // Counts of space, since only there a surface encloses something.
    const auto [vertices, edges, triangles, all] = class_counts(source_.answer.complex);
    if (triangles.singular + edges.singular + vertices.singular > 0) {
      const bool in_space = own_.dimension() == 3;
      lines.push_back("left out, as they enclose nothing: " +
                      counted(triangles.singular, in_space ? "singular triangle" : "triangle",
                              in_space ? "singular triangles" : "triangles") +
                      ", " + counted(edges.singular, "edge", "edges") + ", " +
                      counted(vertices.singular, "vertex", "vertices"));
    }
    return lines;
  }

  // For formats without a unit.
  static Lines with_unit(Lines lines) {
    lines.emplace_back("1 unit of the file is 1 Å");
    return lines;
  }
  // For printers, which make each solid separately.
  Lines with_pieces(Lines lines) {
    const std::size_t solids = boundary().solids.size();
    if (solids > 1) {
      lines.push_back("a printer makes " + grouped(solids) +
                      " separate pieces of this; a larger alpha joins them");
    }
    return lines;
  }

  Lines simplices_text() const {
    std::string text;
    if (!complex_.tetrahedra_only) {
      text = counted(complex_.vertices.size(), "vertex", "vertices") + ", " +
             counted(complex_.edges.size(), "edge", "edges") + ", " +
             counted(complex_.triangles.size(), "triangle", "triangles") + ", ";
    }
    return {text + counted(complex_.tetrahedra.size(), "tetrahedron", "tetrahedra")};
  }
  std::string balls_counted() const {
    return counted(source_.answer.balls->size(), "ball", "balls");
  }

  Lines write_drawing(AtomicFile& file) const {
    require_faces("A flat drawing");
    const FlatBox box = box_of(balls(), complex_.alpha_angstrom2());
    const std::string text = grouped(complex_.vertices.size()) + " of " +
                             counted(balls().size(), "centre", "centres") + ", " +
                             counted(complex_.edges.size(), "edge", "edges") + ", " +
                             counted(complex_.triangles.size(), "triangle", "triangles");
    const std::string alpha =
        "α = " + shortest_number(source_.answer.request.alpha_angstrom2) + " Å²";
    FlatPage page{.box = box, .caption = {alpha + ": " + text}, .origin = source_.header};
    file.write(flat_svg(flat_shapes(balls(), complex_, box), page));
    return {text};
  }

  // A group for each chain or element among all balls, with its colour. A script refers to them by
  // the molecule's names.
  std::vector<ComplexScript::Group> groups() const {
    const bool chains = source_.colours == ExportColours::chain;
    const auto& atoms = source_.prepared.atom_of_ball;
    const auto colours = (chains ? colours_by_chain : colours_by_element)(source_.molecule, atoms);
    std::map<std::string, Rgb8> found;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      const Atom& atom = source_.molecule.atoms[atoms[i]];
      const std::string_view name =
          chains ? source_.molecule.text(atom.chain) : element_symbol(atom.element);
      found.try_emplace(std::string(name), colours[i]);
    }
    std::vector<ComplexScript::Group> groups;
    for (const auto& [name, colour] : found) groups.push_back({name, bytes(colour)});
    return groups;
  }

  // One row for each number, because the names of stages differ between engines.
  void write_counts(AtomicFile& file) {
    std::vector<CsvRow> rows;
    const auto add = [&rows](std::string quantity, std::string value, const char* unit) {
      rows.push_back(
          {{"quantity", std::move(quantity)}, {"value", std::move(value)}, {"unit", unit}});
    };
    for (const auto& [key, value] : source_.header) add(key, value, "");
    add("balls", std::to_string(source_.answer.balls->size()), "");
    add_counts(add);
    double volume = 0;
    for (const BoundarySolid& solid : boundary().solids) volume += volume_angstrom3(solid);
    add("solids", std::to_string(boundary().solids.size()), "");
    add("boundary triangles", std::to_string(boundary().triangles.size()), "");
    add("volume of tetrahedra", all_digits(volume), "Å³");
    if (source_.times) add_times(add);
    file.write(csv_text(rows));
  }

  template <class Add>
  void add_times(const Add& add) {
    const StageTimes& times = complex_.timings;
    add("wall time", csv_milliseconds(times.wall_milliseconds), "ms");
    add("setup", csv_milliseconds(times.setup_milliseconds()), "ms");
    for (const StageTime& stage : times.stages) {
      add("stage: " + stage.label, csv_milliseconds(stage.milliseconds), "ms");
    }
    for (const EngineCounter& counter : complex_.engine.counters) {
      add(counter.name, std::to_string(counter.value), "");
    }
  }

  template <class Add>
  void add_counts(const Add& add) const {
    const auto counts = class_counts(complex_);
    const char* const names[] = {"vertices", "edges", "triangles"};
    for (std::size_t n = 0; n < 3 && !complex_.tetrahedra_only; ++n) {
      add(names[n], std::to_string(counts[n].all()), "");
      add(std::string("singular ") + names[n], std::to_string(counts[n].singular), "");
      add(std::string("regular ") + names[n], std::to_string(counts[n].regular), "");
      add(std::string("interior ") + names[n], std::to_string(counts[n].interior), "");
    }
    add("tetrahedra", std::to_string(complex_.tetrahedra.size()), "");
    if (complex_.tetrahedra_only) return;
    add("Euler characteristic", std::to_string(complex_.euler_characteristic()), "");
  }

  const ExportSource& source_;
  const InOwnDimension own_;
  const AlphaComplex& complex_ = own_.complex();
  const RunContext& context_;
  std::optional<Boundary> boundary_;
};

// A format is one entry. Exactly one of `write` and `script` is set; `surface` belongs to a script.
struct Format {
  ExportFormatInfo info;
  Lines (Exporter::*write)(AtomicFile& file) = nullptr;
  std::string (*script)(const ComplexScript& script) = nullptr;
  Lines (Exporter::*surface)(AtomicFile& file) = nullptr;
};

constexpr Format kFormats[] = {
    {{"ply", "PLY", "boundary with colours, binary: MeshLab, CloudCompare", true}, &Exporter::ply},
    {{"obj", "OBJ", "boundary with colours, as text: Blender, MeshLab", true}, &Exporter::obj},
    {{"stl", "STL", "boundary, with each solid separate: 3D printers"}, &Exporter::stl},
    {{"off", "OFF", "boundary with colours, as text: CGAL, MeshLab", true}, &Exporter::off},
    {{"glb", "GLB", "boundary with colours: web pages, slides, Blender", true}, &Exporter::glb},
    {{"vtu", "VTU", "all simplices with alpha values and classes: ParaView"}, &Exporter::vtu},
    {{"vtp", "VTP", "vertices, edges and triangles likewise: ParaView"}, &Exporter::vtp},
    {{"mesh", "Medit mesh", "all simplices, for finite elements: Gmsh, MMG"}, &Exporter::medit},
    {{"xyzr", "XYZR", "balls: x y z r"}, &Exporter::xyzr},
    {{"pqr", "PQR", "balls as atoms with names and radii"}, &Exporter::pqr},
    {{"alpha", "Alphascope text", "all simplices with alpha values, as text"}, &Exporter::alpha},
    {{"txt", "ParallelAC text", "balls and simplices in its layout"}, &Exporter::parallelac},
    {{"svg", "SVG", "flat drawing, of balls in the plane z = 0 only"}, &Exporter::svg},
    {{"csv", "CSV", "counts, measures of the boundary and times"}, &Exporter::csv},
    {{"cxc", "ChimeraX script", "balls and boundary", true, "-boundary.glb"},
     nullptr,
     chimerax_complex_script,
     &Exporter::glb},
    {{"pml", "PyMOL script", "balls and boundary", true, "-boundary.obj"},
     nullptr,
     pymol_complex_script,
     &Exporter::obj},
    {{"tcl", "VMD script", "balls and boundary", true, "-boundary.obj"},
     nullptr,
     vmd_complex_script,
     &Exporter::obj}};

const std::vector<ExportFormatInfo>& infos() {
  static const std::vector<ExportFormatInfo> all = [] {
    std::vector<ExportFormatInfo> found;
    for (const Format& format : kFormats) found.push_back(format.info);
    return found;
  }();
  return all;
}

}  // namespace

std::span<const ExportFormatInfo> export_formats() {
  return infos();
}

const ExportFormatInfo* export_format_from_id(const std::string& id) {
  const auto found = std::find_if(infos().begin(), infos().end(),
                                  [&](const ExportFormatInfo& info) { return id == info.id; });
  return found == infos().end() ? nullptr : &*found;
}

const ExportFormatInfo* export_format_of(const fs::path& path) {
  std::string ending = path.extension().string();
  if (ending.empty()) return nullptr;
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return export_format_from_id(ending.substr(1));
}

std::string export_endings() {
  std::string text;
  for (const ExportFormatInfo& info : infos())
    text += (text.empty() ? "." : ", .") + std::string(info.id);
  return text;
}

std::vector<fs::path> export_files(const ExportFormatInfo& format, const fs::path& path) {
  if (format.surface == nullptr) return {path};
  const auto beside = [&](const char* ending) {
    return path.parent_path() / (path.stem().string() + ending);
  };
  return {path, beside("-balls.pqr"), beside(format.surface)};
}

std::vector<std::string> write_export(const ExportSource& source, const ExportFormatInfo& format,
                                      const fs::path& path, const std::vector<AtomicFile*>& files,
                                      const RunContext& context) {
  Exporter exporter(source, context);
  for (const Format& known : kFormats) {
    if (std::string_view(known.info.id) != format.id) continue;
    if (known.write != nullptr) return (exporter.*known.write)(*files.at(0));
    return exporter.script(known.script, known.surface, export_files(format, path), files);
  }
  throw std::invalid_argument("There is no such format.");
}

}  // namespace alphascope
