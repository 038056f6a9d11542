// The least value of a function without derivatives.
#pragma once

#include <functional>
#include <vector>

namespace muster::statistics {

/// A local minimum by the simplex of Nelder & Mead (1965) from `start`, its first edges `edge` long: at most
/// 2000 values are asked for.
std::vector<double> leastBySimplex(const std::function<double(const std::vector<double>&)>& value,
                                   const std::vector<double>& start, double edge);

}  // namespace muster::statistics
