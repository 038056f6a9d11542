#include "lab/study/statistics/mixed_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/maths.h"
#include "lab/study/statistics/numerics.h"

namespace muster::statistics {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// The model's matrices. Its parameters are the lower triangle of persons' factor and the layouts' one, all
/// relative to the residual.
struct Design {
    Matrix x;       ///< Matrix of the fixed effects.
    Matrix zx, zz;  ///< Products of the random effects' columns with the fixed effects and with themselves.
    Vector y, zy;   ///< Log times, and their product.
    std::vector<std::int32_t> touched;  ///< Environments whose effect of touch is a column...
    std::vector<Eigen::Index> columns;  ///< ...and the columns of these environments.
    Eigen::Index people = 0, layouts = 0;
};

/// The parts of the profiled likelihood at one point.
struct Profile {
    Matrix inverse;  ///< Inverse of the fixed effects' matrix, without the residual variance.
    Vector fixed;
    double penalised = 0.0;     ///< Penalised sum of squares.
    double determinants = 0.0;  ///< Sum of the logarithms of the determinants.
};

/// Adds a column where it is no combination of the columns that are there.
bool addColumn(Matrix& x, const Vector& column) {
    Vector rest = column;
    if (x.cols() > 0) rest -= x * x.householderQr().solve(column);
    if (rest.norm() < 1e-8 * std::max(1.0, column.norm())) return false;
    x.conservativeResize(column.size(), x.cols() + 1);
    x.col(x.cols() - 1) = column;
    return true;
}

void addFixed(Design& design, const std::vector<MixedRow>& rows) {
    const auto n = static_cast<Eigen::Index>(rows.size());
    std::set<std::int32_t> environments;
    for (const MixedRow& row : rows) environments.insert(row.environment);
    const auto column = [&](auto value) {
        Vector values(n);
        for (Eigen::Index i = 0; i < n; ++i) values[i] = value(rows[static_cast<std::size_t>(i)]);
        return values;
    };
    for (const std::int32_t e : environments)
        addColumn(design.x, column([e](const MixedRow& r) { return r.environment == e ? 1.0 : 0.0; }));
    for (const std::int32_t e : environments) {
        if (!addColumn(design.x,
                       column([e](const MixedRow& r) { return r.environment == e && r.touch ? 1.0 : 0.0; })))
            continue;
        design.touched.push_back(e);
        design.columns.push_back(design.x.cols() - 1);
    }
    addColumn(design.x, column([](const MixedRow& r) { return r.period; }));
    addColumn(design.x, column([](const MixedRow& r) { return r.order; }));
}

/// The index of each of these numbers in their order, from 0.
template <class Number>
std::map<std::int32_t, Eigen::Index> places(const std::vector<MixedRow>& rows, Number number) {
    std::map<std::int32_t, Eigen::Index> found;
    for (const MixedRow& row : rows) found[number(row)] = 0;
    Eigen::Index place = 0;
    for (auto& entry : found) entry.second = place++;
    return found;
}

Design designOf(const std::vector<MixedRow>& rows) {
    Design design;
    const auto n = static_cast<Eigen::Index>(rows.size());
    design.y.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) design.y[i] = rows[static_cast<std::size_t>(i)].logTime;
    design.x.resize(n, 0);
    addFixed(design, rows);
    const auto people = places(rows, [](const MixedRow& r) { return r.person; });
    const auto layouts = places(rows, [](const MixedRow& r) { return r.layout; });
    design.people = static_cast<Eigen::Index>(people.size());
    design.layouts = static_cast<Eigen::Index>(layouts.size());
    Matrix z = Matrix::Zero(n, 2 * design.people + design.layouts);
    for (Eigen::Index i = 0; i < n; ++i) {
        const MixedRow& row = rows[static_cast<std::size_t>(i)];
        const Eigen::Index person = 2 * people.at(row.person);
        z(i, person) = 1.0;
        z(i, person + 1) = row.touch ? 1.0 : 0.0;
        z(i, 2 * design.people + layouts.at(row.layout)) = 1.0;
    }
    design.zx = z.transpose() * design.x;
    design.zy = z.transpose() * design.y;
    design.zz = z.transpose() * z;
    return design;
}

Matrix factorOf(const Design& design, const std::vector<double>& theta) {
    const Eigen::Index q = design.zz.rows();
    Matrix factor = Matrix::Zero(q, q);
    for (Eigen::Index i = 0; i < 2 * design.people; i += 2) {
        factor(i, i) = theta[0];
        factor(i + 1, i) = theta[1];
        factor(i + 1, i + 1) = theta[2];
    }
    for (Eigen::Index i = 2 * design.people; i < q; ++i) factor(i, i) = theta[3];
    return factor;
}

Profile profileAt(const Design& design, const std::vector<double>& theta) {
    const Eigen::Index q = design.zz.rows(), p = design.x.cols();
    const Matrix factor = factorOf(design, theta);
    const Matrix inner = factor.transpose() * design.zz * factor + Matrix::Identity(q, q);
    const Eigen::LLT<Matrix> lower(inner);
    const Matrix rx = lower.matrixL().solve(factor.transpose() * design.zx);
    const Vector ry = lower.matrixL().solve(factor.transpose() * design.zy);
    const Eigen::LLT<Matrix> fixedLower(design.x.transpose() * design.x - rx.transpose() * rx);
    const Vector right = design.x.transpose() * design.y - rx.transpose() * ry;
    Profile profile{.inverse = fixedLower.solve(Matrix::Identity(p, p)), .fixed = fixedLower.solve(right)};
    profile.penalised = design.y.squaredNorm() - ry.squaredNorm() - profile.fixed.dot(right);
    for (Eigen::Index i = 0; i < q; ++i) profile.determinants += 2.0 * std::log(lower.matrixLLT()(i, i));
    for (Eigen::Index i = 0; i < p; ++i) profile.determinants += 2.0 * std::log(fixedLower.matrixLLT()(i, i));
    return profile;
}

double freedom(const Design& design) {
    return static_cast<double>(design.x.rows() - design.x.cols());
}

/// -2 log restricted likelihood, with the best residual variance.
double criterion(const Design& design, const std::vector<double>& theta) {
    const Profile profile = profileAt(design, theta);
    const double df = freedom(design);
    const double value = profile.determinants + df * (1.0 + std::log(2.0 * kPi * profile.penalised / df));
    return std::isfinite(value) ? value : std::numeric_limits<double>::max();
}

/// The criterion where the residual deviation is a parameter, the last one.
double openCriterion(const Design& design, std::vector<double> parameters) {
    const double sigma = parameters.back();
    parameters.pop_back();
    const Profile profile = profileAt(design, parameters);
    return profile.determinants + freedom(design) * std::log(2.0 * kPi * sigma * sigma) +
           profile.penalised / (sigma * sigma);
}

Vector variances(const Design& design, std::vector<double> parameters) {
    const double sigma = parameters.back();
    parameters.pop_back();
    const Profile profile = profileAt(design, parameters);
    Vector values(static_cast<Eigen::Index>(design.columns.size()));
    for (std::size_t i = 0; i < design.columns.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = sigma * sigma *
                                               profile.inverse(design.columns[i], design.columns[i]);
    return values;
}

/// Second derivatives of the criterion, by central differences.
Matrix curvature(const Design& design, const std::vector<double>& parameters) {
    const std::size_t k = parameters.size();
    Matrix hessian(k, k);
    const auto at = [&](std::size_t i, double di, std::size_t j, double dj) {
        std::vector<double> moved = parameters;
        moved[i] += di;
        moved[j] += dj;
        return openCriterion(design, moved);
    };
    const auto stepOf = [&](std::size_t i) { return 1e-3 * std::max(0.1, std::abs(parameters[i])); };
    for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const double a = stepOf(i), b = stepOf(j);
            const double value = (at(i, a, j, b) - at(i, a, j, -b) - at(i, -a, j, b) + at(i, -a, j, -b)) /
                                 (4.0 * a * b);
            hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = value;
            hessian(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = value;
        }
    }
    return hessian;
}

/// The covariance of the parameters; directions in which the likelihood does not fall are left out.
Matrix covariance(const Matrix& hessian) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(hessian);
    const double least = 1e-6 * std::max(1e-12, solver.eigenvalues().maxCoeff());
    Vector inverse = solver.eigenvalues();
    for (Eigen::Index i = 0; i < inverse.size(); ++i)
        inverse[i] = inverse[i] > least ? 2.0 / inverse[i] : 0.0;
    return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

/// Satterthwaite's degrees of freedom of each effect.
std::vector<double> freedoms(const Design& design, const std::vector<double>& parameters) {
    const std::size_t k = parameters.size();
    const Vector values = variances(design, parameters);
    Matrix slopes(values.size(), static_cast<Eigen::Index>(k));
    for (std::size_t i = 0; i < k; ++i) {
        const double step = 1e-4 * std::max(0.1, std::abs(parameters[i]));
        std::vector<double> above = parameters, below = parameters;
        above[i] += step;
        below[i] -= step;
        slopes.col(static_cast<Eigen::Index>(i)) = (variances(design, above) - variances(design, below)) /
                                                   (2.0 * step);
    }
    const Matrix spread = covariance(curvature(design, parameters));
    std::vector<double> dfs;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const double variance = slopes.row(i) * spread * slopes.row(i).transpose();
        dfs.push_back(variance > 0.0 ? std::max(1.0, 2.0 * values[i] * values[i] / variance)
                                     : freedom(design));
    }
    return dfs;
}

/// The best parameters: the simplex from several starts, each begun again until it stands still.
std::vector<double> bestTheta(const Design& design) {
    const auto value = [&](const std::vector<double>& theta) { return criterion(design, theta); };
    std::vector<double> best;
    double least = std::numeric_limits<double>::infinity();
    for (const double start : {1.0, 0.1}) {
        std::vector<double> theta{start, 0.0, start, start};
        for (int round = 0; round < 4; ++round) theta = leastBySimplex(value, theta, round == 0 ? 0.5 : 0.1);
        if (value(theta) >= least) continue;
        least = value(theta);
        best = theta;
    }
    if (best[0] < 0.0) best[0] = -best[0], best[1] = -best[1];  // The other sign gives the same covariance.
    best[2] = std::abs(best[2]);
    best[3] = std::abs(best[3]);
    return best;
}

void addEffects(const Design& design, const std::vector<double>& theta, MixedModel& model) {
    const Profile profile = profileAt(design, theta);
    std::vector<double> parameters = theta;
    parameters.push_back(model.residual);
    const std::vector<double> dfs = freedoms(design, parameters);
    std::vector<double> ps;
    for (std::size_t i = 0; i < design.columns.size(); ++i) {
        MixedEffect effect;
        const Eigen::Index column = design.columns[i];
        effect.environment = design.touched[i];
        effect.estimate = profile.fixed[column];
        effect.error = model.residual * std::sqrt(profile.inverse(column, column));
        effect.df = dfs[i];
        effect.p = 2.0 * studentBelow(-std::abs(effect.estimate / effect.error), effect.df);
        const double half = studentQuantile(0.975, effect.df) * effect.error;
        effect.ratio = {std::exp(effect.estimate), std::exp(effect.estimate - half),
                        std::exp(effect.estimate + half)};
        model.effects.push_back(effect);
        ps.push_back(effect.p);
    }
    const std::vector<double> adjusted = holm(ps);
    for (std::size_t i = 0; i < adjusted.size(); ++i) model.effects[i].holm = adjusted[i];
}

}  // namespace

Result<MixedModel> fitMixedModel(const std::vector<MixedRow>& rows) {
    for (const MixedRow& row : rows)
        if (!std::isfinite(row.logTime)) return invalidArgument("the mixed model needs times above 0");
    if (rows.empty()) return invalidArgument("the mixed model has no trials");
    const Design design = designOf(rows);
    if (design.people < 2) return invalidArgument("the mixed model needs at least two people");
    if (design.touched.empty())
        return invalidArgument("the mixed model needs both controls in one environment");
    if (freedom(design) < 2.0)
        return invalidArgument("the mixed model needs more trials than it has effects");
    const std::vector<double> theta = bestTheta(design);
    const Profile profile = profileAt(design, theta);
    if (!(profile.penalised > 1e-12 * std::max(1.0, design.y.squaredNorm())))
        return invalidArgument("the mixed model needs times that differ by chance");
    MixedModel model{.criterion = criterion(design, theta),
                     .residual = std::sqrt(profile.penalised / freedom(design))};
    model.person = model.residual * theta[0];
    model.slope = model.residual * std::sqrt(theta[1] * theta[1] + theta[2] * theta[2]);
    if (model.person > 1e-9 && model.slope > 1e-9)
        model.correlation = model.residual * theta[1] / model.slope;
    model.layout = model.residual * theta[3];
    model.people = static_cast<std::int32_t>(design.people);
    model.trials = static_cast<std::int32_t>(rows.size());
    addEffects(design, theta, model);
    return model;
}

}  // namespace muster::statistics
