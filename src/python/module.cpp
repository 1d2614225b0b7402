#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "model/packing.hpp"
#include "python/compute.hpp"
#include "python/given.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sweep/reference/parameter.hpp"

/// The extension sigmasweep._core: numbers only. What users see is in sigmasweep/__init__.py.
namespace sigmasweep::python {
namespace {

namespace py = pybind11;

/// A field as Python describes it: name, NumPy's type, unit, meaning, and the names of an enumeration.
template <class Owner>
py::tuple described(const FieldOf<Owner>& field, std::string meaning) {
  using enum FieldType::Storage;
  const char* type = field.type == FieldType::of<Flag>()      ? "?"
                     : field.type.storage == real             ? "f8"
                     : field.type.storage == integer          ? "i8"
                     : field.type.storage == unsigned_integer ? "u8"
                     : field.type.storage == integer32        ? "i4"
                                                              : "u1";
  std::vector<std::string> names(field.type.names.begin(), field.type.names.end());
  return py::make_tuple(std::string(field.name), type, std::string(field.unit), std::move(meaning), std::move(names));
}

py::list parameters() {
  py::list list;
  for (const ParameterField& field : fields_of_parameters()) list.append(described(field, parameter_line(field)));
  return list;
}

py::list columns_of(std::span<const Field> fields) {
  py::list list;
  for (const Field& field : fields) list.append(described(field, std::string(field.meaning)));
  return list;
}

template <class Number>
std::span<const Number> numbers(const py::handle& values) {
  const auto array = py::cast<py::array_t<Number, py::array::c_style>>(values);
  return {array.data(), static_cast<std::size_t>(array.size())};
}

std::vector<Given> given_by(const py::dict& values) {
  std::vector<Given> given;
  for (const ParameterField& field : fields_of_parameters()) {
    const py::str name{std::string(field.name)};
    if (!values.contains(name)) continue;
    const py::handle array = values[name];
    if (field.type == FieldType::real)
      given.push_back({&field, numbers<double>(array)});
    else
      given.push_back({&field, numbers<std::int64_t>(array)});
  }
  return given;
}

/// (columns, bytes of the rows): arrays by name of one number, or of `count`; float64, or int64 for whole numbers and
/// enumerators. The arrays must exist until the end.
py::tuple simulate(const py::dict& values, std::size_t count, int threads) {
  const std::vector<Given> given = given_by(values);
  const std::vector<Field> columns = representatives(given, count).columns();
  py::array_t<std::uint8_t> rows(static_cast<py::ssize_t>(count * packed_size(columns)));
  const std::span<std::byte> bytes(reinterpret_cast<std::byte*>(rows.mutable_data()),
                                   static_cast<std::size_t>(rows.size()));
  const auto interrupted = [] {
    const py::gil_scoped_acquire held;
    return PyErr_CheckSignals() != 0;
  };
  bool whole = false;
  {
    const py::gil_scoped_release released;
    whole = compute(given, count, columns, bytes, threads, interrupted);
  }
  if (!whole) throw py::error_already_set();
  return py::make_tuple(columns_of(columns), rows);
}

/// (axes, sizes) of a stored spec, in its order.
py::tuple axes_of(const std::string& text) {
  const Sweep sweep = Sweep::parse_stored(text, "spec");
  return py::make_tuple(sweep.axes(), sweep.axis_sizes());
}

}  // namespace
}  // namespace sigmasweep::python

PYBIND11_MODULE(_core, module) {
  namespace python = sigmasweep::python;
  pybind11::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const sigmasweep::Error& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
  module.def("parameters", &python::parameters);
  module.def("simulate", &python::simulate);
  module.def("axes_of", &python::axes_of);
  module.attr("version") = SIGMASWEEP_VERSION;
}
