#pragma once

// Rows and files for the tests of journal and table.

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "store/journal/record.hpp"

namespace sigmasweep::samples {

/// A directory of its own, gone with its owner.
class Directory {
 public:
  Directory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "sigmasweep-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = pattern;
  }
  ~Directory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) found.push_back(entry.path().filename());
    return found;
  }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Without emptying the file first: some file systems make that, and thousands of tests, wait for the disk.
inline void put_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::app).close();
  std::fstream(path, std::ios::binary | std::ios::in | std::ios::out) << bytes;
  std::filesystem::resize_file(path, bytes.size());
}

/// A row whose every member differs from its default and from its neighbours; `variant` makes other rows of the same
/// index. NaN, infinity, -0 and the smallest numbers come up.
inline Row row(std::uint64_t index, std::uint64_t variant = 0) {
  std::uint64_t state = index * 0x9e3779b97f4a7c15u + variant;
  const auto next = [&state] {  // splitmix64
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  };
  const auto real = [&next] { return static_cast<double>(next() >> 11) * 0x1p-53 + 1.0; };
  Row r;
  r.index = index;
  Parameters& p = r.parameters;
  for (double* x : {&p.v0, &p.tc, &p.s0, &p.sigma, &p.epsilon, &p.d, &p.steps_per_tc, &p.tolerance, &p.K_over_m, &p.D_n,
                    &p.beta, &p.gamma, &p.width, &p.gravity, &p.frequency, &p.alpha, &p.A0, &p.D_t})
    *x = real();
  p.periods = static_cast<std::int64_t>(next() >> 20);
  p.transient = static_cast<std::int64_t>(next() >> 20);
  p.geometry = static_cast<Geometry>(next() % 4);
  p.rows = static_cast<std::int64_t>(next() >> 20);
  p.columns = static_cast<std::int64_t>(next() >> 20);
  p.side_walls = static_cast<SideWalls>(next() % 2);
  p.N = static_cast<std::int64_t>(next() >> 20);
  p.method = static_cast<Method>(next() % 2);
  p.wall = static_cast<Wall>(next() % 2);
  p.integrator = static_cast<Integrator>(next() % 4);
  p.seed = static_cast<std::int64_t>(next() >> 20);
  p.law = static_cast<Law>(next() % 5);
  p.material = static_cast<Material>(next() % 3);
  p.ed_rule = static_cast<EdRule>(next() % 2);
  p.random_separation = static_cast<Flag>(next() % 2);
  SimulationResult& c = r.result;
  for (double* x : {&c.eps_eff, &c.eps_eff_error, &c.Er_Ef, &c.Er_E0, &c.v_cm, &c.t_k, &c.x_max}) *x = real();
  if (index % 5 == 1) c.eps_eff = std::numeric_limits<double>::quiet_NaN();
  if (index % 5 == 2) c.t_k = std::numeric_limits<double>::infinity();
  if (index % 5 == 3) c.x_max = -0.0;
  if (index % 5 == 4) c.v_cm = std::numeric_limits<double>::denorm_min();
  Vibration& v = c.vibration;
  for (double* x : {&v.h_cm, &v.h_cm_error, &v.h_cm_excess, &v.separation, &v.separation_max, &v.E_r, &v.cm_period,
                    &v.power_in, &v.power_lost, &v.imbalance})
    *x = real();
  c.contacts = next();
  c.end = static_cast<End>(next() % 4);
  c.status = static_cast<Status>(next() % 9);
  r.timing.run_time = real();
  r.timing.predicted_time = real();
  r.timing.rank = static_cast<std::int32_t>(next() >> 33);
  r.timing.attempt = static_cast<std::int32_t>(next() >> 33);
  return r;
}

inline std::vector<Row> rows(std::uint64_t first, std::uint64_t count) {
  std::vector<Row> all;
  for (std::uint64_t i = first; i < first + count; ++i) all.push_back(row(i));
  return all;
}

/// Every member of a row to the bit, in words: written out here, not taken from the list of fields that is tested.
inline std::vector<std::uint64_t> parameter_bits(const Row& r) {
  std::vector<std::uint64_t> bits{r.index};
  const Parameters& p = r.parameters;
  for (const double x : {p.v0, p.tc, p.s0, p.sigma, p.epsilon, p.d, p.steps_per_tc, p.tolerance})
    bits.push_back(std::bit_cast<std::uint64_t>(x));
  for (const std::uint64_t x : {static_cast<std::uint64_t>(p.N), static_cast<std::uint64_t>(p.method),
                                static_cast<std::uint64_t>(p.wall), static_cast<std::uint64_t>(p.integrator)})
    bits.push_back(x);
  return bits;
}

inline void add_bits_of_results(const Row& r, std::vector<std::uint64_t>& all) {
  const SimulationResult& c = r.result;
  for (const double x : {c.eps_eff, c.eps_eff_error, c.Er_Ef, c.Er_E0, c.v_cm, c.t_k, c.x_max, r.timing.run_time,
                         r.timing.predicted_time})
    all.push_back(std::bit_cast<std::uint64_t>(x));
  for (const std::uint64_t x :
       {c.contacts, static_cast<std::uint64_t>(c.end), static_cast<std::uint64_t>(c.status),
        static_cast<std::uint64_t>(r.timing.rank), static_cast<std::uint64_t>(r.timing.attempt)})
    all.push_back(x);
}

inline std::vector<std::uint64_t> bits(const Row& r) {
  std::vector<std::uint64_t> all = parameter_bits(r);
  add_bits_of_results(r, all);
  return all;
}

/// The same of what a journal has: the content key instead of the parameters.
inline std::vector<std::uint64_t> bits(const JournalledRow& found) {
  std::vector<std::uint64_t> all{found.row.index, found.content_key};
  add_bits_of_results(found.row, all);
  return all;
}

inline JournalledRow journalled(const Row& r) { return {r, content_key(r.parameters)}; }

/// The message of the `Kind` of error that `action` throws; a test failure if it throws none or another.
template <class Kind, class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const Kind& error) {
    return error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another kind of error: " << error.what();
    return {};
  }
  ADD_FAILURE() << "no error";
  return {};
}

}  // namespace sigmasweep::samples
