// SPDX-License-Identifier: GPL-3.0-or-later
// Writes VTK's XML files. The XML names the arrays and their offsets; their bytes follow in one
// piece ("appended, raw"). VTK's own writers are not used. They want the whole data set in memory
// once more, and core does not depend on VTK. Tests read the files with VTK's readers.
#include "core/write/write_vtk.hpp"

#include <functional>
#include <limits>
#include <map>
#include <stdexcept>

#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/write/text_writer.hpp"

namespace alphascope {
namespace {

// Calls visit(list, dimension) for the dimensions of the range, in order.
template <class Visit>
void visit_lists(const AlphaComplex& complex, int least_dimension, int most_dimension,
                 const Visit& visit) {
  const auto wanted = [&](int d) { return d >= least_dimension && d <= most_dimension; };
  if (wanted(0)) visit(complex.vertices, 0);
  if (wanted(1)) visit(complex.edges, 1);
  if (wanted(2)) visit(complex.triangles, 2);
  if (wanted(3)) visit(complex.tetrahedra, 3);
}

struct Array {
  std::uint64_t bytes = 0;
  std::function<void(TextWriter&)> write;
};

class VtkWriter {
 public:
  VtkWriter(const VtkSource& source, bool grid, AtomicFile& file, const RunContext& context)
      : source_(source), grid_(grid), context_(context), text_(file, context.cancel) {}

  void write() {
    const char* const type = grid_ ? "UnstructuredGrid" : "PolyData";
    text_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
          << "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" << type
          << ">\n";
    write_header();
    write_piece();
    text_ << "</" << type << ">\n<AppendedData encoding=\"raw\">\n_";
    for (std::size_t n = 0; n < arrays_.size(); ++n) {
      context_.report("writing", static_cast<double>(n) / static_cast<double>(arrays_.size()));
      text_.bytes(arrays_[n].bytes);
      arrays_[n].write(text_);
    }
    text_ << "\n</AppendedData>\n</VTKFile>\n";
    text_.flush();
  }

 private:
  // Keys that occur several times, such as notes, become one array of several texts.
  void write_header() {
    std::map<std::string, std::vector<std::string_view>> values;
    for (const auto& [key, value] : source_.header) values[key].push_back(value);
    text_ << "<FieldData>\n";
    for (const auto& [key, texts] : values) {
      text_ << "<Array type=\"String\" Name=\"" << key << "\" NumberOfTuples=\"" << texts.size()
            << "\" format=\"ascii\">\n";
      for (const std::string_view value : texts) write_string(value);
      text_ << "</Array>\n";
    }
    text_ << "</FieldData>\n";
  }

  // A string in VTK's encoding: the codes of its characters, then 0.
  void write_string(std::string_view value) {
    for (const char c : value) text_ << std::size_t{static_cast<unsigned char>(c)} << " ";
    text_ << "0";
    text_.end_line();
  }

  void write_piece() {
    text_ << "<Piece NumberOfPoints=\"" << source_.balls.size() << "\"";
    if (grid_) {
      text_ << " NumberOfCells=\"" << cells(0, 3) << "\">\n";
    } else {
      text_ << " NumberOfVerts=\"" << cells(0, 0) << "\" NumberOfLines=\"" << cells(1, 1)
            << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << cells(2, 2) << "\">\n";
    }
    write_point_data();
    write_cell_data();
    text_ << "<Points>\n";
    add<double>("NumberOfComponents=\"3\" Name=\"Points\"", 3 * source_.balls.size(),
                [this](const auto& put) {
                  for (const LatticePoint& p : source_.balls.centres) {
                    for (const std::int32_t x : {p.x, p.y, p.z}) put(lattice().angstrom(x));
                  }
                });
    text_ << "</Points>\n";
    if (grid_) {
      write_cells("Cells", 0, 3);
    } else {
      write_cells("Verts", 0, 0);
      write_cells("Lines", 1, 1);
      write_cells("Polys", 2, 2);
    }
    text_ << "</Piece>\n";
  }

  void write_point_data() {
    const std::size_t balls = source_.balls.size();
    text_ << "<PointData>\n";
    add<double>("Name=\"radius_angstrom\"", balls, [this](const auto& put) {
      for (const std::int32_t radius : source_.balls.radii) put(lattice().angstrom(radius));
    });
    add<std::int32_t>("Name=\"ball\"", balls, [balls](const auto& put) {
      for (std::size_t i = 0; i < balls; ++i) put(static_cast<std::int32_t>(i));
    });
    add_of_atoms<std::uint8_t>("Name=\"element\"", [](const Atom& atom) { return atom.element; });
    add_of_atoms<std::int32_t>("Name=\"serial\"", [](const Atom& atom) { return atom.serial; });
    add_of_atoms<std::int32_t>("Name=\"residue_number\"",
                               [](const Atom& atom) { return atom.residue_number; });
    write_names("atom_name", &Atom::name);
    write_names("residue_name", &Atom::residue_name);
    write_names("chain", &Atom::chain);
    text_ << "</PointData>\n";
  }

  void write_names(const char* name, NameId Atom::*of) {
    text_ << "<Array type=\"String\" Name=\"" << name << "\" NumberOfTuples=\""
          << source_.balls.size() << "\" format=\"ascii\">\n";
    for (const std::uint32_t atom : source_.atom_of_ball) {
      write_string(source_.molecule.text(source_.molecule.atoms[atom].*of));
    }
    text_ << "</Array>\n";
  }

  void write_cell_data() {
    const std::size_t count = cells(0, most_dimension());
    text_ << "<CellData>\n";
    add<std::uint8_t>("Name=\"dimension\"", count, [this](const auto& put) {
      for_lists([&](const auto& list, int dimension) {
        for (std::size_t n = 0; n < list.size(); ++n) put(static_cast<std::uint8_t>(dimension));
      });
    });
    if (!source_.complex.tetrahedra_only) {
      add<double>("Name=\"alpha_angstrom2\"", count, [this](const auto& put) {
        for_lists([&](const auto& list, int) {
          for (const float value : list.alpha_values) put(lattice().square_angstrom(value));
        });
      });
      add<std::uint8_t>("Name=\"class\"", count, [this](const auto& put) {
        for_lists([&](const auto& list, int) {
          for (const SimplexClass c : list.classes) put(static_cast<std::uint8_t>(c));
        });
      });
    }
    text_ << "</CellData>\n";
  }

  void write_cells(const char* element, int least, int most) {
    std::uint64_t corners = 0;
    visit_lists(source_.complex, least, most, [&](const auto& list, int dimension) {
      corners += list.size() * static_cast<std::uint64_t>(dimension + 1);
    });
    if (corners > std::uint64_t{std::numeric_limits<std::int32_t>::max()}) {
      throw WriteError(
          "The complex has too many simplices for a VTK file. Write it as .alpha, or choose a "
          "smaller alpha.");
    }
    const std::size_t count = cells(least, most);
    text_ << "<" << element << ">\n";
    add<std::int32_t>("Name=\"connectivity\"", corners, [this, least, most](const auto& put) {
      visit_lists(source_.complex, least, most, [&](const auto& list, int) {
        for (const auto& simplex : list.simplices) {
          for (const BallIndex v : simplex) put(static_cast<std::int32_t>(v));
        }
      });
    });
    add<std::int32_t>("Name=\"offsets\"", count, [this, least, most](const auto& put) {
      std::int32_t end = 0;
      visit_lists(source_.complex, least, most, [&](const auto& list, int dimension) {
        for (std::size_t n = 0; n < list.size(); ++n) put(end += dimension + 1);
      });
    });
    if (grid_) {
      add<std::uint8_t>("Name=\"types\"", count, [this](const auto& put) {
        constexpr std::uint8_t kTypes[] = {1, 3, 5, 10};  // vertex, line, triangle, tetrahedron
        for_lists([&](const auto& list, int dimension) {
          for (std::size_t n = 0; n < list.size(); ++n) put(kTypes[dimension]);
        });
      });
    }
    text_ << "</" << element << ">\n";
  }

  // Declares an array. `fill` calls put(value) `count` times later, when the bytes are written.
  template <class T, class Fill>
  void add(const std::string& attributes, std::uint64_t count, const Fill& fill) {
    text_ << "<DataArray type=\"" << type_name(T{}) << "\" " << attributes
          << " format=\"appended\" offset=\"" << offset_ << "\"/>\n";
    arrays_.push_back(
        {count * sizeof(T), [fill](TextWriter& to) { fill([&to](T value) { to.bytes(value); }); }});
    offset_ += sizeof(std::uint64_t) + count * sizeof(T);
  }
  template <class T, class Value>
  void add_of_atoms(const std::string& attributes, const Value& value) {
    add<T>(attributes, source_.atom_of_ball.size(), [this, value](const auto& put) {
      for (const std::uint32_t atom : source_.atom_of_ball) {
        put(value(source_.molecule.atoms[atom]));
      }
    });
  }
  static const char* type_name(double) { return "Float64"; }
  static const char* type_name(std::int32_t) { return "Int32"; }
  static const char* type_name(std::uint8_t) { return "UInt8"; }

  const Lattice& lattice() const { return source_.balls.lattice; }
  int most_dimension() const { return grid_ ? 3 : 2; }
  template <class Visit>
  void for_lists(const Visit& visit) const {
    visit_lists(source_.complex, 0, most_dimension(), visit);
  }
  std::size_t cells(int least, int most) const {
    std::size_t count = 0;
    visit_lists(source_.complex, least, most, [&](const auto& list, int) { count += list.size(); });
    return count;
  }

  const VtkSource& source_;
  const bool grid_;
  const RunContext& context_;
  TextWriter text_;
  std::vector<Array> arrays_;
  std::size_t offset_ = 0;  // of the next array, in bytes
};

}  // namespace

void write_vtu(const VtkSource& source, AtomicFile& file, const RunContext& context) {
  VtkWriter(source, true, file, context).write();
}

void write_vtp(const VtkSource& source, AtomicFile& file, const RunContext& context) {
  if (source.complex.tetrahedra_only) {
    throw std::invalid_argument(
        "A VTP file holds vertices, edges and triangles, and only tetrahedra were computed. Write "
        "VTU, or compute all simplices.");
  }
  VtkWriter(source, false, file, context).write();
}

}  // namespace alphascope
