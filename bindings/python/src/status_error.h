// Failures of the engine as exceptions.
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <string>
#include <utility>

#include "muster/status.h"

namespace muster::python {

/// Carries a failure to Python, where it is raised as a subclass of muster.Error.
class StatusError : public std::exception {
public:
    explicit StatusError(Status status) : status_(std::move(status)) {}

    const Status& status() const { return status_; }
    const char* what() const noexcept override { return status_.message().c_str(); }

private:
    Status status_;
};

/// Throws where the status is a failure.
inline void check(const Status& status) {
    if (!status.ok()) throw StatusError(status);
}
/// The value; throws where there is none.
template <class T>
T take(Result<T> result) {
    if (!result.ok()) throw StatusError(result.status());
    return std::move(result).value();
}
/// The Python exception of a failure.
pybind11::object exceptionOf(const Status& status);
/// Makes pybind11 raise StatusError as muster.Error.
void registerErrors();

}  // namespace muster::python
