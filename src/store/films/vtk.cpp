#include <fmt/format.h>

#include <iterator>
#include <string>

#include "store/films/formats.hpp"

/// Files of VTK, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html, for ParaView: row-000042.pvd,
/// which names a file of PolyData for each sample, row-000042/00017.vtp. Its points are the beads, its lines the
/// contacts between beads. Units are SI, and the mean bead's mass.
namespace sigmasweep {
namespace {

/// An array of `values`, one after the other.
template <class Values>
std::string array(std::string_view name, int components, const Values& values, std::string_view type = "Float64") {
  const std::string named = name.empty() ? "" : fmt::format(" Name=\"{}\"", name);
  return fmt::format("<DataArray type=\"{}\"{} NumberOfComponents=\"{}\" format=\"ascii\">\n{}\n</DataArray>\n", type,
                     named, components, fmt::join(values, " "));
}

struct Arrays {
  std::vector<double> position, velocity, radius, mass, force;  ///< of the beads
  std::vector<double> overlap, contact_force;                   ///< of the contacts between beads
  std::vector<std::size_t> ends, offsets;
};

Arrays arrays_of(const Film& film, std::size_t s) {
  Arrays all;
  const auto append = [](std::vector<double>& to, const Vec3& v) { to.insert(to.end(), v.begin(), v.end()); };
  for (std::size_t i = 0; i < film.beads(); ++i) {
    append(all.position, film.position(s, i));
    append(all.velocity, film.velocity(s, i));
    all.radius.push_back(film.radius(i));
    all.mass.push_back(film.mass(i));
  }
  if (!film.has_forces()) return all;
  const auto contacts = film.contacts(s);
  for (const Vec3& force : film.forces(contacts)) append(all.force, force);
  for (const FilmContact& contact : contacts) {
    if (contact.j == FilmContact::wall) continue;
    all.ends.insert(all.ends.end(), {contact.i, contact.j});
    all.offsets.push_back(all.ends.size());
    all.overlap.push_back(contact.overlap);
    append(all.contact_force, contact.force);
  }
  return all;
}

/// Points come before lines: arrays of cells have a value for each bead, then one for each contact.
std::string poly_data(const Film& film, std::size_t s) {
  const Arrays all = arrays_of(film, s);
  std::vector<std::size_t> points(film.beads()), point_offsets(film.beads());
  for (std::size_t i = 0; i < film.beads(); ++i) point_offsets[i] = (points[i] = i) + 1;
  std::vector<double> overlap(film.beads()), force(3 * film.beads());
  overlap.insert(overlap.end(), all.overlap.begin(), all.overlap.end());
  force.insert(force.end(), all.contact_force.begin(), all.contact_force.end());
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"{1}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      film.beads(), all.offsets.size());
  text += "<PointData Scalars=\"radius\" Vectors=\"velocity\">\n" + array("radius", 1, all.radius) +
          array("velocity", 3, all.velocity) + array("mass", 1, all.mass);
  if (film.has_forces()) text += array("force", 3, all.force);
  text += "</PointData>\n<CellData>\n";
  if (film.has_forces()) text += array("overlap", 1, overlap) + array("contact_force", 3, force);
  text += "</CellData>\n<Points>\n" + array("", 3, all.position) + "</Points>\n<Verts>\n" +
          array("connectivity", 1, points, "Int64") + array("offsets", 1, point_offsets, "Int64") +
          "</Verts>\n<Lines>\n" + array("connectivity", 1, all.ends, "Int64") +
          array("offsets", 1, all.offsets, "Int64") + "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return text;
}

void write(const Film& film, const PutFile& put) {
  const std::string stem = film_stem(film.row());
  std::string collection =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t s = 0; s < film.samples(); ++s) {
    const std::string name = fmt::format("{}/{:05}.vtp", stem, s);
    put(name, poly_data(film, s));
    collection += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", film.time(s), name);
  }
  put(stem + ".pvd", collection + "</Collection>\n</VTKFile>\n");
}

}  // namespace

FilmFormat vtk_film() {
  return {"vtk", "PolyData of VTK with a collection for each row, for ParaView: beads, and contacts as lines", write};
}

}  // namespace sigmasweep
