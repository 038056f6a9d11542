#include "status_error.h"

namespace muster::python {

namespace py = pybind11;

namespace {

const char* className(StatusCode code) {
    switch (code) {
        case StatusCode::InvalidArgument:
            return "InvalidArgumentError";
        case StatusCode::NotFound:
            return "NotFoundError";
        case StatusCode::ParseError:
            return "ParseError";
        case StatusCode::IoError:
            return "IoError";
        case StatusCode::Corrupt:
            return "CorruptError";
        case StatusCode::Unsupported:
            return "UnsupportedError";
        case StatusCode::LimitExceeded:
            return "LimitExceededError";
        case StatusCode::Ok:
            break;
    }
    return "Error";
}

}  // namespace

py::object exceptionOf(const Status& status) {
    const std::string& text = status.message();
    // Names of files need not be UTF-8.
    const auto sentence = py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace"));
    return py::module_::import("muster.errors").attr(className(status.code()))(sentence);
}

void registerErrors() {
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const StatusError& error) {
            const py::object made = exceptionOf(error.status());
            PyErr_SetObject(py::type::handle_of(made).ptr(), made.ptr());
        }
    });
}

}  // namespace muster::python
