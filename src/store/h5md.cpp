#include "store/h5md.hpp"

#include <fmt/format.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "assembly/ground.hpp"
#include "base/atomic_file.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/physics_version.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/build_info.hpp"
#include "store/hdf5/tree.hpp"
#include "store/table/types.hpp"

namespace sigmasweep {
namespace {

using namespace h5md;

/// The name of the user who runs the program, which H5MD wants.
std::string author() {
  std::array<char, 4096> text{};
  passwd entry{}, *found = nullptr;
  if (::getpwuid_r(::getuid(), &entry, text.data(), text.size(), &found) != 0 || found == nullptr) return "unknown";
  const std::string full(found->pw_gecos != nullptr ? found->pw_gecos : "");
  const std::string name = full.substr(0, full.find(','));  // then office, telephone, ...
  return name.empty() ? found->pw_name : name;
}

void put_metadata(hid_t file) {
  const Handle metadata = new_group(file, "h5md");
  put_version(metadata, 1, 1);
  put_text(new_group(metadata, "author"), "name", author());
  const Handle creator = new_group(metadata, "creator");
  put_text(creator, "name", "sigmasweep");
  put_text(creator, "version", build_info().program_version);
  const Handle units = new_group(new_group(metadata, "modules"), "units");
  put_version(units, 1, 0);
  put_text(units, "system", "SI");
}

/// A key that two files share if and only if they are the same trajectory.
std::string key_of(const Parameters& parameters, std::size_t samples, double duration) {
  return fmt::format("{:016x}-{}-{:016x}", content_key(parameters), samples, std::bit_cast<std::uint64_t>(duration));
}

void put_parameters(hid_t file, const Tuple& tuple, const Trajectory& trajectory) {
  const Handle group = new_group(file, "parameters");
  Row row;
  row.parameters = tuple.parameters;
  for (const Field& field : parameter_fields()) {
    const std::string name(field.name);
    if (!enumerators(field.type).empty())
      put_text(group, name, text(field, row));
    else if (field.type == FieldType::real)
      put_real(group, name, number(field, row));
    else
      put_whole(group, name, static_cast<std::int64_t>(number(field, row)));
  }
  put_whole(group, "row", static_cast<std::int64_t>(tuple.index));
  put_whole(group, "physics_version", physics_version);
  put_text(group, "key", key_of(tuple.parameters, trajectory.samples(), trajectory.time.back()));
}

/// Time-dependent elements. The first one has datasets step and time, which the others share.
class Elements {
 public:
  explicit Elements(const Trajectory& trajectory) : trajectory_(trajectory) {}

  void put(hid_t group, const std::string& name, std::span<const double> values, std::vector<hsize_t> item,
           const std::string& unit) {
    item.insert(item.begin(), trajectory_.samples());
    Handle element = new_group(group, name);
    put_array(element, "value", values, item, unit);
    if (first_ < 0) {
      std::vector<std::int64_t> steps(trajectory_.samples());
      std::iota(steps.begin(), steps.end(), 0);
      put_counts(element, "step", steps);
      put_array(element, "time", trajectory_.time, {trajectory_.samples()}, "s");
      first_ = std::move(element);
      return;
    }
    for (const char* shared : {"step", "time"})
      check(H5Lcreate_hard(first_, shared, element, shared, H5P_DEFAULT, H5P_DEFAULT), "cannot share the time");
  }

 private:
  const Trajectory& trajectory_;
  Handle first_;
};

/// The values x_0, z_0, x_1, z_1, ...; of a column, which has no x, the values of z.
std::vector<double> interleaved(std::span<const double> x, std::span<const double> z) {
  std::vector<double> both;
  for (std::size_t k = 0; k < z.size(); ++k) {
    if (!x.empty()) both.push_back(x[k]);
    both.push_back(z[k]);
  }
  return both;
}

std::vector<double> positions(const Trajectory& t) {
  std::vector<double> h = t.z;
  for (std::size_t i = 0; i < t.beads(); ++i)
    for (std::size_t s = 0; s < t.samples(); ++s) h[s * t.beads() + i] += t.base(i);
  return interleaved(t.x, h);
}

/// sum m_i v_i^2 divided by sum m_i unit^2, for each sample.
std::vector<double> kinetic_energies(const Trajectory& t, double unit) {
  const double all = std::accumulate(t.mass.begin(), t.mass.end(), 0.0);
  std::vector<double> energies(t.samples());
  for (std::size_t s = 0; s < t.samples(); ++s)
    for (std::size_t i = 0; i < t.beads(); ++i) {
      const std::size_t k = s * t.beads() + i;
      const double v = t.velocity[k] / unit, u = t.is_plane() ? t.x_velocity[k] / unit : 0.0;
      energies[s] += t.mass[i] * (v * v + u * u) / all;
    }
  return energies;
}

/// Of beads that fly into a wall: kinetic energy divided by that at the start. Of beads on a vibrating plate: kinetic
/// energy per mass, J/kg, and the height of the plate, m.
void put_observables(hid_t group, const Parameters& p, const Trajectory& trajectory, Elements& elements) {
  if (!applies_to(*find_field("frequency"), p)) {
    elements.put(group, "kinetic_energy", kinetic_energies(trajectory, p.v0), {}, "");
    return;
  }
  elements.put(group, "kinetic_energy", kinetic_energies(trajectory, std::numbers::sqrt2), {}, "J kg-1");
  std::vector<double> plate;
  for (const double t : trajectory.time) plate.push_back(plate_height(p, t));
  elements.put(group, "plate_height", plate, {}, "m");
}

/// The box of a lattice is as high as its beads come. Nothing bounds them above, but H5MD has edges in all directions
/// or in none.
void put_box(hid_t beads, const Trajectory& t) {
  const Handle box = new_group(beads, "box");
  std::vector<std::string> boundary{"none"};
  if (t.is_plane()) {
    boundary.insert(boundary.begin(), t.periodic ? "periodic" : "none");
    double height = 0.0;
    for (std::size_t k = 0; k < t.z.size(); ++k)
      if (std::isfinite(t.z[k])) height = std::max(height, t.z[k] + 0.5 * t.diameter[k % t.beads()]);
    put_array(box, "edges", std::vector<double>{t.box_width, height}, {2}, "m");
  }
  put_whole(box, "dimension", static_cast<std::int64_t>(boundary.size()));
  put_texts(box, "boundary", boundary);
}

std::vector<std::byte> image_of(const Tuple& tuple, const Trajectory& trajectory) {
  const Handle file = new_file();
  put_metadata(file);
  Elements elements(trajectory);
  {
    const Handle beads = new_group(new_group(file, "particles"), "beads");
    put_box(beads, trajectory);
    const hsize_t N = trajectory.beads(), dimension = trajectory.is_plane() ? 2 : 1;
    elements.put(beads, "position", positions(trajectory), {N, dimension}, "m");
    elements.put(beads, "velocity", interleaved(trajectory.x_velocity, trajectory.velocity), {N, dimension}, "m s-1");
    if (!trajectory.is_plane()) elements.put(beads, "reduced_height", trajectory.z, {N, 1}, "m");
    put_array(beads, "mass", trajectory.mass, {N}, "");
    put_array(beads, "diameter", trajectory.diameter, {N}, "m");
  }
  put_observables(new_group(file, "observables"), tuple.parameters, trajectory, elements);
  put_parameters(file, tuple, trajectory);
  return h5md::image_of(file);
}

/// Splits values that interleaved() joined, of two dimensions.
void split(std::span<const double> both, std::vector<double>& x, std::vector<double>& z) {
  for (std::size_t k = 0; k + 1 < both.size(); k += 2) {
    x.push_back(both[k]);
    z.push_back(both[k + 1]);
  }
}

void read_plane(hid_t beads, Trajectory& t, std::vector<hsize_t> extents) {
  extents.back() = 2;
  split(get_array(beads, "position/value", extents), t.x, t.z);
  split(get_array(beads, "velocity/value", extents), t.x_velocity, t.velocity);
  std::vector<hsize_t> directions{2};
  t.box_width = get_array(beads, "box/edges", directions)[0];
  if (!(t.box_width > 0.0 && std::isfinite(t.box_width))) throw IoError("its box has no width");
  const Handle box(H5Gopen2(beads, "box", H5P_DEFAULT), H5Gclose, "it has no box");
  const std::vector<std::string> boundary = get_texts(box, "boundary");
  if (boundary.size() != 2) throw IoError("its box has not two dimensions");
  t.periodic = boundary[0] == "periodic";
}

}  // namespace

void write_h5md(const std::string& path, const Tuple& tuple, const Trajectory& trajectory) {
  const Hdf5Session session;
  std::vector<std::byte> image;
  try {
    image = image_of(tuple, trajectory);
  } catch (const IoError& error) {
    throw IoError(fmt::format("cannot make {}: {}", path, error.what()));
  }
  write_whole_file(path, image);
}

Trajectory read_h5md(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 && (errno == ENOENT || errno == ENOTDIR))
    throw InputNotFound(fmt::format("there is no trajectory {}", path));
  const Hdf5Session session;
  try {
    const Handle file = open_for_reading(path);
    const Handle beads(H5Gopen2(file, "particles/beads", H5P_DEFAULT), H5Gclose, "it has no group particles/beads");
    Trajectory trajectory;
    std::vector<hsize_t> samples{0}, N{0};
    trajectory.time = get_array(beads, "position/time", samples);
    trajectory.mass = get_array(beads, "mass", N);
    trajectory.diameter = get_array(beads, "diameter", N);
    std::vector<hsize_t> extents{samples[0], N[0], 1};
    if (check(H5Lexists(beads, "reduced_height", H5P_DEFAULT), "cannot look for reduced_height") == 0) {
      read_plane(beads, trajectory, extents);
      return trajectory;
    }
    trajectory.z = get_array(beads, "reduced_height/value", extents);
    trajectory.velocity = get_array(beads, "velocity/value", extents);
    return trajectory;
  } catch (const IoError& error) {
    throw IoError(fmt::format("{} is not a trajectory of sigmasweep: {}", path, error.what()));
  }
}

bool is_h5md_of(const std::string& path, const Parameters& parameters, std::size_t samples, double duration) {
  const Hdf5Session session;
  try {
    const Handle file = open_for_reading(path);
    const Handle group(H5Gopen2(file, "parameters", H5P_DEFAULT), H5Gclose, "it has no parameters");
    const std::string key = get_text(group, "key"), wanted = key_of(parameters, samples, duration);
    return std::isnan(duration) ? key.substr(0, key.rfind('-')) == wanted.substr(0, wanted.rfind('-')) : key == wanted;
  } catch (const IoError&) {
    return false;
  }
}

}  // namespace sigmasweep
