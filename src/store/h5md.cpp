#include "store/h5md.hpp"

#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "assembly/ground.hpp"
#include "assembly/springs.hpp"
#include "base/atomic_file.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/exact_number.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/physics_version.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/build_info.hpp"
#include "store/hdf5/open.hpp"
#include "store/hdf5/seal.hpp"
#include "store/hdf5/tree.hpp"
#include "store/hdf5/trial.hpp"

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
  row.parameters = with_springs(tuple.parameters);
  for (const Field& field : parameter_fields()) {
    const std::string name(field.name);
    if (!enumerators(field.type).empty())
      put_text(group, name, text(field, row));
    else if (field.type == FieldType::real)
      put_real(group, name, number(field, row));
    else
      put_whole(group, name, static_cast<std::int64_t>(exact_number(field, row)));
  }
  put_whole(group, "row", static_cast<std::int64_t>(tuple.index));
  put_whole(group, "physics_version", physics_version);
  put_text(group, "key", key_of(tuple.parameters, trajectory.samples(), trajectory.time.back()));
}

/// Time-dependent elements. The first one has datasets step and time, which the others share. Units are attributes of
/// the elements, not of their datasets, where H5MD has them: MDAnalysis gives up on datasets in units that it does not
/// know, and it knows no metres.
class Elements {
 public:
  explicit Elements(const Trajectory& trajectory) : trajectory_(trajectory) {}

  void put(hid_t group, const std::string& name, std::span<const double> values, std::vector<hsize_t> item,
           const std::string& unit) {
    item.insert(item.begin(), trajectory_.samples());
    Handle element = new_group(group, name);
    put_array(element, "value", values, item, "");
    if (!unit.empty()) put_text(element, "unit", unit);
    put_text(element, "time_unit", "s");
    if (first_ < 0) {
      std::vector<std::int64_t> steps(trajectory_.samples());
      std::iota(steps.begin(), steps.end(), 0);
      put_counts(element, "step", steps);
      put_array(element, "time", trajectory_.time, {trajectory_.samples()}, "");
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

constexpr hsize_t dimensions = 3;  // tools of molecular dynamics know no others

/// The vectors (x_0, 0, z_0), (x_1, 0, z_1), ...; a column has no x.
std::vector<double> vectors(std::span<const double> x, std::span<const double> z) {
  std::vector<double> all;
  all.reserve(dimensions * z.size());
  for (std::size_t k = 0; k < z.size(); ++k) all.insert(all.end(), {x.empty() ? 0.0 : x[k], 0.0, z[k]});
  return all;
}

std::vector<double> positions(const Trajectory& t) {
  std::vector<double> h = t.z;
  for (std::size_t i = 0; i < t.beads(); ++i)
    for (std::size_t s = 0; s < t.samples(); ++s) h[s * t.beads() + i] += t.base(i);
  return vectors(t.x, h);
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

/// The vectors along the edges of a lattice's box, for each sample. The box is as deep as the largest bead and as high
/// as the beads come. Nothing bounds them above, but H5MD has edges in all directions or in none.
std::vector<double> edges_of(const Trajectory& t) {
  double height = 0.0;
  for (std::size_t k = 0; k < t.z.size(); ++k)
    if (std::isfinite(t.z[k])) height = std::max(height, t.z[k] + 0.5 * t.diameter[k % t.beads()]);
  std::vector<double> edges;
  for (std::size_t s = 0; s < t.samples(); ++s)
    edges.insert(edges.end(), {t.box_width, 0.0, 0.0, 0.0, std::ranges::max(t.diameter), 0.0, 0.0, 0.0, height});
  return edges;
}

/// The box of a lattice has edges, as an element that depends on time: MDAnalysis reads no other ones.
void put_box(hid_t beads, const Trajectory& t, Elements& elements) {
  const Handle box = new_group(beads, "box");
  std::vector<std::string> boundary(dimensions, "none");
  if (t.periodic) boundary.front() = "periodic";
  put_whole(box, "dimension", dimensions);
  put_texts(box, "boundary", boundary);
  if (t.is_plane()) elements.put(box, "edges", edges_of(t), {dimensions, dimensions}, "m");
}

std::vector<std::byte> image_of(const Tuple& tuple, const Trajectory& trajectory) {
  const Handle file = new_file();
  put_metadata(file);
  Elements elements(trajectory);
  {
    const Handle beads = new_group(new_group(file, "particles"), "beads");
    const hsize_t N = trajectory.beads();
    elements.put(beads, "position", positions(trajectory), {N, dimensions}, "m");
    elements.put(beads, "velocity", vectors(trajectory.x_velocity, trajectory.velocity), {N, dimensions}, "m s-1");
    put_box(beads, trajectory, elements);
    if (!trajectory.is_plane()) elements.put(beads, "reduced_height", trajectory.z, {N, 1}, "m");
    put_array(beads, "mass", trajectory.mass, {N}, "");
    put_array(beads, "diameter", trajectory.diameter, {N}, "m");
  }
  put_observables(new_group(file, "observables"), tuple.parameters, trajectory, elements);
  put_parameters(file, tuple, trajectory);
  return h5md::image_of(file);
}

/// The components of vectors of that many dimensions: the first ones, and the last ones, which are the heights.
void split(std::span<const double> all, std::size_t dimension, std::vector<double>& x, std::vector<double>& z) {
  for (std::size_t k = 0; k + dimension <= all.size(); k += dimension) {
    if (dimension > 1) x.push_back(all[k]);
    z.push_back(all[k + dimension - 1]);
  }
}

double box_width(hid_t beads, hsize_t samples, hsize_t dimension) {
  std::vector<hsize_t> of_old{dimension}, of_all{samples, dimension, dimension};
  const double width = dimension == 2 ? get_array(beads, "box/edges", of_old)[0]  // of earlier files
                                      : get_array(beads, "box/edges/value", of_all)[0];
  if (!(width > 0.0 && std::isfinite(width))) throw IoError("its box has no width");
  return width;
}

void read_plane(hid_t beads, Trajectory& t, std::vector<hsize_t> extents) {
  extents.back() = 0;  // any
  const std::vector<double> position = get_array(beads, "position/value", extents);
  const hsize_t dimension = extents.back();
  if (dimension != 2 && dimension != 3) throw IoError("its positions have not two or three dimensions");
  split(position, dimension, t.x, t.z);
  split(get_array(beads, "velocity/value", extents), dimension, t.x_velocity, t.velocity);
  t.box_width = box_width(beads, extents.front(), dimension);
  const Handle box = open_group(beads, "box");
  const std::vector<std::string> boundary = get_texts(box, "boundary");
  if (boundary.size() != dimension) throw IoError("its box has not the dimensions of its positions");
  t.periodic = boundary[0] == "periodic";
}

void read_column(hid_t beads, Trajectory& t, std::vector<hsize_t> extents) {
  t.z = get_array(beads, "reduced_height/value", extents);
  extents.back() = 0;  // any
  const std::vector<double> velocity = get_array(beads, "velocity/value", extents);
  std::vector<double> none;
  split(velocity, extents.back(), none, t.velocity);
}

/// Of a file that is somebody else's. Positions and velocities may be NaN, where a solver gave up.
void require_sound(const Trajectory& t) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!std::ranges::all_of(t.mass, positive)) throw IoError("it has beads without a mass");
  if (!std::ranges::all_of(t.diameter, positive)) throw IoError("it has beads without a diameter");
  if (!std::ranges::all_of(t.time, [](double time) { return std::isfinite(time) && time >= 0.0; }) ||
      !std::ranges::is_sorted(t.time))
    throw IoError("its times do not ascend");
}

Trajectory read_open_h5md(const std::string& path) {
  const Handle file = open_file(path, "trajectory"), beads = open_group(file, "particles/beads");
  Trajectory trajectory;
  std::vector<hsize_t> samples{0}, N{0};
  trajectory.time = get_array(beads, "position/time", samples);
  trajectory.mass = get_array(beads, "mass", N);
  trajectory.diameter = get_array(beads, "diameter", N);
  std::vector<hsize_t> extents{samples[0], N[0], 1};
  require_sound(trajectory);
  if (check(H5Lexists(beads, "reduced_height", H5P_DEFAULT), "cannot look for reduced_height") == 0)
    read_plane(beads, trajectory, extents);
  else
    read_column(beads, trajectory, extents);
  return trajectory;
}

}  // namespace

void write_h5md(const std::string& path, const Tuple& tuple, const Trajectory& trajectory) {
  const Hdf5Session session;
  std::vector<std::byte> image;
  try {
    image = image_of(tuple, trajectory);
    seal(image);
  } catch (const IoError& error) {
    throw IoError(fmt::format("cannot make {}: {}", path, error.what()));
  }
  write_whole_file(path, image);
}

Trajectory read_h5md(const std::string& path) {
  const Hdf5Session session;
  try {
    return read_after_trial(path, [&] { return read_open_h5md(path); });
  } catch (const IoError& error) {
    throw IoError(fmt::format("{} is not a trajectory of sigmasweep: {}", path, error.what()));
  }
}

bool is_h5md_of(const std::string& path, const Parameters& parameters, std::size_t samples, double duration) {
  const Hdf5Session session;
  try {
    const std::string key = read_after_trial(path, [&] {
      const Handle file = open_file(path, "trajectory"), group = open_group(file, "parameters");
      return get_text(group, "key");
    });
    const std::string wanted = key_of(parameters, samples, duration);
    return std::isnan(duration) ? key.substr(0, key.rfind('-')) == wanted.substr(0, wanted.rfind('-')) : key == wanted;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace sigmasweep
