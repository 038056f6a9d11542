#include "from_python.h"

#include <cmath>

#include "muster/parameter_table.h"

namespace muster::python {

namespace {

constexpr std::size_t kShown = 60;  // Characters of a wrong value that a sentence shows.

/// How a sentence shows a wrong value.
std::string shown(py::handle found) {
    std::string text;
    try {
        text = py::repr(found).cast<std::string>();
    } catch (const py::error_already_set&) {
        text = "something without a text";
    } catch (const py::cast_error&) {
        text = "text that is not UTF-8";
    }
    for (char& c : text)
        if (c == '\n') c = ' ';
    if (text.size() <= kShown) return text;
    std::size_t cut = kShown;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80)
        --cut;  // Whole characters of UTF-8.
    return text.substr(0, cut) + "...";
}

bool isText(py::handle from) {
    return PyUnicode_Check(from.ptr()) || PyBytes_Check(from.ptr()) || PyByteArray_Check(from.ptr());
}

}  // namespace

void FromPython::fail(py::handle found, const std::string& expected) const {
    const bool ofRoot = path_.empty() || path_.front() == '[';
    check(invalidArgument((ofRoot ? root_ : "") + path_ + ": found " + shown(found) + ", expected " +
                          expected));
    std::abort();  // Not reached: check() throws.
}

std::string FromPython::withArticle(const char* name) {
    return (std::string("AEIO").find(name[0]) == std::string::npos ? "a " : "an ") + std::string(name);
}

std::string FromPython::text(py::handle from) const {
    Py_ssize_t size = 0;
    const char* const bytes = PyUnicode_AsUTF8AndSize(from.ptr(), &size);
    if (bytes == nullptr) {
        PyErr_Clear();
        fail(from, "text that UTF-8 can hold");
    }
    return {bytes, static_cast<std::size_t>(size)};
}

py::object FromPython::list(py::handle from, const char* expected) const {
    if (isText(from) || PyDict_Check(from.ptr()) || !PySequence_Check(from.ptr())) fail(from, expected);
    // A tuple of its own: no code that runs while its items are read can change it.
    PyObject* const items = PySequence_Tuple(from.ptr());
    if (items == nullptr) {
        PyErr_Clear();
        fail(from, expected);
    }
    return py::reinterpret_steal<py::object>(items);
}

std::uint64_t FromPython::whole(py::handle from, double minimum, std::uint64_t maximum) const {
    if (PyBool_Check(from.ptr()) || !PyIndex_Check(from.ptr())) fail(from, "a whole number");
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(from.ptr()));
    if (!number) {
        PyErr_Clear();
        fail(from, "a whole number");
    }
    int overflow = 0;
    const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
    bool fits = overflow == 0 && static_cast<double>(value) >= minimum &&
                (value < 0 || static_cast<std::uint64_t>(value) <= maximum);
    auto bits = static_cast<std::uint64_t>(value);
    if (overflow > 0) {  // Above what is signed.
        bits = PyLong_AsUnsignedLongLong(number.ptr());
        fits = PyErr_Occurred() == nullptr && bits <= maximum;
        PyErr_Clear();
    }
    if (!fits) {
        const std::string least = minimum < 0.0 ? std::to_string(static_cast<long long>(minimum)) : "0";
        fail(from, "a whole number from " + least + " to " + std::to_string(maximum));
    }
    return bits;
}

void FromPython::read(py::handle from, bool& into) {
    const bool ofNumpy = std::string(Py_TYPE(from.ptr())->tp_name) == "numpy.bool_";
    if (!PyBool_Check(from.ptr()) && !ofNumpy) fail(from, "True or False");
    into = PyObject_IsTrue(from.ptr()) == 1;
}

void FromPython::read(py::handle from, double& into) {
    if (isText(from) || PyBool_Check(from.ptr()) || !PyNumber_Check(from.ptr())) fail(from, "a number");
    into = PyFloat_AsDouble(from.ptr());
    if (PyErr_Occurred() == nullptr) return;
    PyErr_Clear();
    fail(from, "a number");
}

void FromPython::read(py::handle from, std::string& into) {
    if (!PyUnicode_Check(from.ptr())) fail(from, "text");
    into = text(from);
}

void FromPython::read(py::handle from, Vec2& into) {
    const py::object pair = list(from, "a point (x, y)");
    if (PyTuple_GET_SIZE(pair.ptr()) != 2) fail(from, "a point (x, y)");
    readItem(PyTuple_GET_ITEM(pair.ptr(), 0), 0, into.x);
    readItem(PyTuple_GET_ITEM(pair.ptr(), 1), 1, into.y);
}

void FromPython::read(py::handle from, Box& into) {
    const py::object corners = list(from, "two corners ((x, y), (x, y))");
    if (PyTuple_GET_SIZE(corners.ptr()) != 2) fail(from, "two corners ((x, y), (x, y))");
    readItem(PyTuple_GET_ITEM(corners.ptr(), 0), 0, into.min);
    readItem(PyTuple_GET_ITEM(corners.ptr(), 1), 1, into.max);
}

bool FromPython::readArray(py::handle from, std::vector<Vec2>& into) const {
    if (!py::isinstance<py::array>(from)) return false;
    const auto given = py::reinterpret_borrow<py::array>(from);
    const char kind = given.dtype().kind();
    if (kind != 'f' && kind != 'i' && kind != 'u') fail(from, "numbers");
    const bool empty = given.size() == 0;
    if (!empty && (given.ndim() != 2 || given.shape(1) != 2))
        fail(py::str("an array of shape " + py::str(given.attr("shape")).cast<std::string>()),
             "one of shape (n, 2)");
    into.clear();
    if (empty) return true;
    const auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
    if (!numbers) throw py::error_already_set();
    const auto rows = numbers.template unchecked<2>();
    into.reserve(static_cast<std::size_t>(rows.shape(0)));
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) into.push_back({rows(i, 0), rows(i, 1)});
    return true;
}

void FromPython::read(py::handle from, std::vector<Vec2>& into) {
    if (readArray(from, into)) return;
    const py::object items = list(from, "a list of points");
    const auto count = static_cast<std::size_t>(PyTuple_GET_SIZE(items.ptr()));
    into.assign(count, {});
    for (std::size_t i = 0; i < count; ++i)
        readItem(PyTuple_GET_ITEM(items.ptr(), static_cast<Py_ssize_t>(i)), i, into[i]);
}

void FromPython::read(py::handle from, std::array<double, 3>& into) {
    const py::object items = list(from, "three numbers");
    if (PyTuple_GET_SIZE(items.ptr()) != 3) fail(from, "three numbers");
    for (std::size_t i = 0; i < 3; ++i)
        readItem(PyTuple_GET_ITEM(items.ptr(), static_cast<Py_ssize_t>(i)), i, into[i]);
}

void FromPython::read(py::handle from, Parameters& into) {
    if (!PyDict_Check(from.ptr())) fail(from, "a dict of names and numbers");
    into = Parameters();
    for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(from)) {
        if (!PyUnicode_Check(key.ptr())) fail(key, "the name of a parameter");
        const std::string name = text(key);
        const std::size_t length = path_.size();
        path_.append("[").append(name).append("]");
        double number = 0.0;
        if (PyBool_Check(value.ptr())) {
            number = value.is(py::handle(Py_True)) ? 1.0 : 0.0;  // Switches.
        } else {
            read(value, number);
        }
        path_.resize(length);
        check(setParameter(into, name, number).within(path_));
    }
}

template <class Kind>
bool FromPython::readKind(py::handle from, CommandBody& into) {
    if (!py::isinstance(from, classOf<Kind>())) return false;
    Kind kind;
    readFields(from, kind);
    into = CommandBody(std::move(kind));
    return true;
}

template <class... Kind>
bool FromPython::readAnyOf(py::handle from, CommandBody& into, const std::variant<Kind...>*) {
    return (readKind<Kind>(from, into) || ...);
}

void FromPython::read(py::handle from, CommandBody& into) {
    const CommandKinds* const kinds = nullptr;
    const FormerKinds* const formerKinds = nullptr;
    if (!readAnyOf(from, into, kinds) && !readAnyOf(from, into, formerKinds))
        fail(from, "a command, as muster.Touch or muster.GiveOrder");
}

std::int32_t threadsFrom(py::handle from) {
    const auto threads = fromPython<std::int32_t>(from, "threads");
    if (threads < 0 || threads > 256)
        check(invalidArgument("threads: found " + std::to_string(threads) +
                              ", expected 1 to 256, or 0 for all cores"));
    return threads;
}

double stepTimeFrom(py::handle from) {
    const auto seconds = fromPython<double>(from, "step_time");
    if (!(seconds > 0.0) || !std::isfinite(seconds))
        check(invalidArgument("step_time: found " + shown(from) + ", expected a number above 0"));
    return seconds;
}

std::string pathFrom(py::handle from) {
    const py::object bytes = py::module_::import("os").attr("fsencode")(from);
    return bytes.cast<std::string>();
}

std::span<const std::uint8_t> bytesFrom(py::handle from, const char* root) {
    if (!PyBytes_Check(from.ptr()))
        check(invalidArgument(std::string(root) + ": found " + shown(from) + ", expected bytes"));
    return {reinterpret_cast<const std::uint8_t*>(PyBytes_AS_STRING(from.ptr())),
            static_cast<std::size_t>(PyBytes_GET_SIZE(from.ptr()))};
}

}  // namespace muster::python
