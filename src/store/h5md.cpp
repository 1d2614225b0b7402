#include "sigmasweep/store/h5md.hpp"

#include <fmt/format.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "h5md_tree.hpp"
#include "posix.hpp"
#include "sigmasweep/errors.hpp"
#include "sigmasweep/scene/plate_motion.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/store/build_info.hpp"
#include "sigmasweep/sweep/fields.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "table_types.hpp"

namespace sigmasweep {
namespace {

using namespace h5md;

/// Who runs the program: H5MD wants a name.
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

/// What makes two files the same trajectory.
std::string key_of(const Parameters& parameters, std::size_t samples, double duration) {
  return fmt::format("{:016x}-{}-{:016x}", content_key(parameters), samples, std::bit_cast<std::uint64_t>(duration));
}

void put_parameters(hid_t file, const Tuple& tuple, const Trajectory& trajectory) {
  const Handle group = new_group(file, "parameters");
  Row row;
  row.parameters = tuple.parameters;
  for (const Field& field : parameter_fields()) {
    const std::string name(field.name);
    if (!enumerators(field.type).empty()) put_text(group, name, text(field, row));
    else if (field.type == FieldType::real) put_real(group, name, number(field, row));
    else put_whole(group, name, static_cast<std::int64_t>(number(field, row)));
  }
  put_whole(group, "row", static_cast<std::int64_t>(tuple.index));
  put_whole(group, "physics_version", physics_version);
  put_text(group, "key", key_of(tuple.parameters, trajectory.samples(), trajectory.time.back()));
}

/// The first element brings step and time, the others share them.
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

std::vector<double> positions(const Trajectory& t) {
  std::vector<double> h = t.z;
  for (std::size_t i = 0; i < t.beads(); ++i)
    for (std::size_t s = 0; s < t.samples(); ++s) h[s * t.beads() + i] += t.base(i);
  return h;
}

/// sum m_i v_i^2 over sum m_i unit^2.
std::vector<double> kinetic_energies(const Trajectory& t, double unit) {
  const double all = std::accumulate(t.mass.begin(), t.mass.end(), 0.0);
  std::vector<double> energies(t.samples());
  for (std::size_t s = 0; s < t.samples(); ++s)
    for (std::size_t i = 0; i < t.beads(); ++i) {
      const double v = t.velocity[s * t.beads() + i] / unit;
      energies[s] += t.mass[i] * v * v / all;
    }
  return energies;
}

/// A flying column's energy over that at the start; a vibrated one's in SI units, over its mass, and its plate.
void put_observables(hid_t group, const Parameters& p, const Trajectory& trajectory, Elements& elements) {
  if (p.geometry == Geometry::column) {
    elements.put(group, "kinetic_energy", kinetic_energies(trajectory, p.v0), {}, "");
    return;
  }
  elements.put(group, "kinetic_energy", kinetic_energies(trajectory, std::numbers::sqrt2), {}, "J kg-1");
  std::vector<double> plate;
  for (const double t : trajectory.time) plate.push_back(plate_height(p, t));
  elements.put(group, "plate_height", plate, {}, "m");
}

std::vector<std::byte> image_of(const Tuple& tuple, const Trajectory& trajectory) {
  const Handle file = new_file();
  put_metadata(file);
  Elements elements(trajectory);
  {
    const Handle beads = new_group(new_group(file, "particles"), "beads");
    const Handle box = new_group(beads, "box");
    put_whole(box, "dimension", 1);
    put_texts(box, "boundary", "none");
    const hsize_t N = trajectory.beads();
    elements.put(beads, "position", positions(trajectory), {N, 1}, "m");
    elements.put(beads, "velocity", trajectory.velocity, {N, 1}, "m s-1");
    elements.put(beads, "reduced_height", trajectory.z, {N, 1}, "m");
    put_array(beads, "mass", trajectory.mass, {N}, "");
    put_array(beads, "diameter", trajectory.diameter, {N}, "m");
  }
  put_observables(new_group(file, "observables"), tuple.parameters, trajectory, elements);
  put_parameters(file, tuple, trajectory);
  return h5md::image_of(file);
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
    trajectory.time = get_array(beads, "reduced_height/time", samples);
    trajectory.mass = get_array(beads, "mass", N);
    trajectory.diameter = get_array(beads, "diameter", N);
    std::vector<hsize_t> extents{samples[0], N[0], 1};
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
