// Distributions for tests and models, and the least value of a function without derivatives.
#pragma once

#include <functional>
#include <vector>

namespace muster::statistics {

/// P(Z <= z) of the standard normal distribution.
double normalBelow(double z);
/// The z with P(Z <= z) = p, for 0 < p < 1 (by bisection, to 1e-12).
double normalQuantile(double p);
/// The regularised incomplete beta function I_x(a, b), a, b > 0 (continued fraction; Press et al., Numerical
/// Recipes, 3rd edition, section 6.4).
double incompleteBeta(double a, double b, double x);
/// P(T <= t) of Student's distribution; df > 0, infinite for the normal one.
double studentBelow(double t, double df);
/// The t with P(T <= t) = p, for 0 < p < 1.
double studentQuantile(double p, double df);

/// A local minimum by the simplex of Nelder & Mead (1965) from `start`, its first edges `edge` long: at most
/// 2000 values are asked for.
std::vector<double> leastBySimplex(const std::function<double(const std::vector<double>&)>& value,
                                   const std::vector<double>& start, double edge);

}  // namespace muster::statistics
