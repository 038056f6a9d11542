// Python's data as C++ values. What does not fit is refused by one sentence that names the field.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "described.h"
#include "status_error.h"

namespace muster::python {

namespace py = pybind11;

/// Reads a tree of Python objects.
class FromPython {
public:
    /// `root` names the whole in sentences where no field can be named.
    explicit FromPython(std::string root) : root_(std::move(root)) {}

    void read(py::handle from, bool& into);
    void read(py::handle from, double& into);
    void read(py::handle from, std::string& into);
    void read(py::handle from, Vec2& into);
    void read(py::handle from, Box& into);
    void read(py::handle from, std::vector<Vec2>& into);
    void read(py::handle from, std::array<double, 3>& into);
    void read(py::handle from, Parameters& into);
    void read(py::handle from, CommandBody& into);

    template <std::integral T>
    requires(!std::same_as<T, bool>) void read(py::handle from, T& into) {
        using Limits = std::numeric_limits<T>;
        into = static_cast<T>(
            whole(from, static_cast<double>(Limits::min()), static_cast<std::uint64_t>(Limits::max())));
    }
    template <class Tag>
    void read(py::handle from, Id<Tag>& into) {
        read(from, into.value);
    }
    template <class T>
    void read(py::handle from, std::optional<T>& into) {
        into.reset();
        if (!from.is_none()) read(from, into.emplace());
    }
    template <class T>
    void read(py::handle from, std::vector<T>& into) {
        const py::object items = list(from, "a list");
        const auto count = static_cast<std::size_t>(PyTuple_GET_SIZE(items.ptr()));
        into.clear();
        into.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            readItem(PyTuple_GET_ITEM(items.ptr(), static_cast<Py_ssize_t>(i)), i, into[i]);
    }
    template <class T>
    requires std::is_enum_v<T>
    void read(py::handle from, T& into) {
        const auto& words = Words<T>::kWords;
        if (py::isinstance<py::str>(from)) {
            const std::string found = text(from.get_type().is(py::type::of(py::str())) ? from
                                                                                       : from.attr("value"));
            for (std::size_t i = 0; i < words.size(); ++i) {
                if (found != words[i]) continue;
                into = static_cast<T>(i);
                return;
            }
        }
        std::string names;
        for (const char* word : words) names += (names.empty() ? "" : ", ") + std::string(word);
        fail(from, "one of " + names);
    }
    template <class T>
    requires(Described<T>::value) void read(py::handle from, T& into) {
        if (!py::isinstance(from, classOf<T>())) fail(from, withArticle(Described<T>::kName));
        readFields(from, into);
    }

private:
    struct FieldVisitor {
        FromPython& reader;
        py::handle from;
        template <class T>
        void operator()(const char* name, T& field) {
            const std::size_t length = reader.path_.size();
            if (length > 0) reader.path_.push_back('.');
            reader.path_.append(name);
            reader.read(from.attr(name), field);
            reader.path_.resize(length);
        }
    };

    template <class T>
    void readFields(py::handle from, T& into) {
        FieldVisitor visitor{*this, from};
        Described<T>::fields(visitor, into);
    }
    template <class T>
    void readItem(py::handle from, std::size_t index, T& into) {
        const std::size_t length = path_.size();
        path_.append("[").append(std::to_string(index)).append("]");
        read(from, into);
        path_.resize(length);
    }
    template <class Kind>
    bool readKind(py::handle from, CommandBody& into);
    /// Reads a command of any of the kinds of a variant, which is named by a null pointer.
    template <class... Kind>
    bool readAnyOf(py::handle from, CommandBody& into, const std::variant<Kind...>* kinds);

    static std::string withArticle(const char* name);
    [[noreturn]] void fail(py::handle found, const std::string& expected) const;
    std::string text(py::handle from) const;
    py::object list(py::handle from, const char* expected) const;
    std::uint64_t whole(py::handle from, double minimum, std::uint64_t maximum) const;
    bool readArray(py::handle from, std::vector<Vec2>& into) const;

    std::string root_;
    std::string path_;
};

/// The number of threads of a world: 0 to 256.
std::int32_t threadsFrom(py::handle from);
/// A step time [s], above 0 and finite.
double stepTimeFrom(py::handle from);
/// A path as the system has it, of text or of os.PathLike.
std::string pathFrom(py::handle from);
/// The bytes of a bytes object; valid as long as it is.
std::span<const std::uint8_t> bytesFrom(py::handle from, const char* root);

/// A value of Python as one of C++.
template <class T>
T fromPython(py::handle from, const char* root) {
    T value;
    FromPython(root).read(from, value);
    return value;
}

}  // namespace muster::python
