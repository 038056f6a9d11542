#include "lab/study/models/chance.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kLeastGamma = 0.05;

}  // namespace

double Chance::normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += random_.uniform();
    return sum;
}

double Chance::gamma(double variation) {
    const double z = normal();
    if (!(variation > 0.0)) return 1.0;
    // A gamma variable of shape 1 / variation^2 has the mean 1 / variation^2 too.
    const double ninth = variation * variation / 9.0;
    const double root = 1.0 - ninth + z * std::sqrt(ninth);
    return std::max(kLeastGamma, root * root * root);
}

double Chance::logNormal(double deviation) {
    return exponential(deviation * normal());
}

}  // namespace muster
