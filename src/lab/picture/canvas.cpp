#include "lab/picture/canvas.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster {
namespace {

constexpr int kRowsPerPixel = 5;

}  // namespace

Canvas::Canvas(std::int32_t width, std::int32_t height, Colour ground)
    : width_(width), height_(height), coverage_(static_cast<std::size_t>(width) + 1) {
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (std::size_t i = 0; i < pixels_.size(); i += 3) {
        pixels_[i] = ground.red;
        pixels_[i + 1] = ground.green;
        pixels_[i + 2] = ground.blue;
    }
}

void Canvas::blend(std::int32_t x, std::int32_t y, Colour colour, double coverage) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    const auto share = static_cast<float>(std::min(1.0, coverage) * colour.opacity);
    float* pixel = &pixels_[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                             static_cast<std::size_t>(x)) *
                            3];
    pixel[0] += (static_cast<float>(colour.red) - pixel[0]) * share;
    pixel[1] += (static_cast<float>(colour.green) - pixel[1]) * share;
    pixel[2] += (static_cast<float>(colour.blue) - pixel[2]) * share;
}

/// Adds the part of each pixel that [from, to] covers.
void Canvas::addSpan(double from, double to, double weight) {
    from = std::clamp(from, 0.0, static_cast<double>(width_));
    to = std::clamp(to, 0.0, static_cast<double>(width_));
    if (to <= from) return;
    const auto first = static_cast<std::size_t>(from);
    const auto last = static_cast<std::size_t>(to);
    if (first == last) {
        coverage_[first] += (to - from) * weight;
        return;
    }
    coverage_[first] += (static_cast<double>(first + 1) - from) * weight;
    for (std::size_t x = first + 1; x < last; ++x) coverage_[x] += weight;
    coverage_[last] += (to - static_cast<double>(last)) * weight;
}

void Canvas::sampleRow(double y, double weight) {
    crossings_.clear();
    for (const Edge& e : edges_) {
        if (y < e.y0 || y >= e.y1) continue;
        crossings_.push_back({e.x0 + (e.x1 - e.x0) * (y - e.y0) / (e.y1 - e.y0), e.winding});
    }
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
        winding += crossings_[i].winding;
        if (winding != 0) addSpan(crossings_[i].x, crossings_[i + 1].x, weight);
    }
}

void Canvas::fill(std::span<const std::vector<Vec2>> loops, Colour colour) {
    if (colour.opacity <= 0.0) return;
    std::vector<Edge> all;
    double low = height_, high = 0.0;
    for (const auto& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
            if (a.y == b.y || !isFinite(a) || !isFinite(b)) continue;
            all.push_back(a.y < b.y ? Edge{a.x, a.y, b.x, b.y, 1} : Edge{b.x, b.y, a.x, a.y, -1});
            low = std::min(low, all.back().y0);
            high = std::max(high, all.back().y1);
        }
    }
    std::sort(all.begin(), all.end(), [](const Edge& a, const Edge& b) { return a.y0 < b.y0; });
    const auto top = static_cast<std::int32_t>(std::max(0.0, std::floor(low)));
    const auto bottom = static_cast<std::int32_t>(std::min<double>(height_, std::ceil(high)));
    edges_.clear();
    std::size_t next = 0;
    for (std::int32_t y = top; y < bottom; ++y) {
        while (next < all.size() && all[next].y0 < y + 1) edges_.push_back(all[next++]);
        std::erase_if(edges_, [&](const Edge& e) { return e.y1 <= y; });
        std::fill(coverage_.begin(), coverage_.end(), 0.0);
        for (int row = 0; row < kRowsPerPixel; ++row)
            sampleRow(y + (row + 0.5) / kRowsPerPixel, 1.0 / kRowsPerPixel);
        for (std::int32_t x = 0; x < width_; ++x) {
            if (const double c = coverage_[x]; c > 0.0) blend(x, y, colour, c);
        }
    }
}

std::vector<std::uint8_t> Canvas::bytes() const {
    std::vector<std::uint8_t> bytes(pixels_.size());
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(std::clamp(pixels_[i] + 0.5f, 0.0f, 255.0f));
    return bytes;
}

std::vector<Vec2> discLoop(Vec2 centre, double radius) {
    const int sides = std::clamp(static_cast<int>(4.0 * std::sqrt(radius) + 8.0), 10, 96);
    std::vector<Vec2> loop;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * kPi * i / sides;
        loop.push_back(centre + Vec2{cosine(angle), sine(angle)} * radius);
    }
    return loop;
}

namespace {

/// A straight segment with both round ends.
void penLoop(Vec2 a, Vec2 b, double half, std::vector<std::vector<Vec2>>& loops) {
    const Vec2 along = normalized(b - a);
    if (lengthSquared(along) > 0.0) {
        const Vec2 side = perpendicular(along) * half;
        loops.push_back({a - side, b - side, b + side, a + side});
    }
    if (half < 0.4) return;  // A hairline needs no round ends: they are invisible.
    loops.push_back(discLoop(a, half));
    loops.push_back(discLoop(b, half));
}

}  // namespace

void strokeLoops(std::span<const Vec2> points, bool closed, double width, double dash,
                 std::vector<std::vector<Vec2>>& loops) {
    if (points.empty() || width <= 0.0) return;
    const double half = width / 2.0;
    const std::size_t segments = points.size() - (closed ? 0 : 1);
    double along = 0.0;
    for (std::size_t i = 0; i < segments; ++i) {
        const Vec2 a = points[i], b = points[(i + 1) % points.size()];
        const double size = distance(a, b);
        if (dash <= 0.0) {
            penLoop(a, b, half, loops);
            continue;
        }
        const double period = 2.0 * dash + width;
        for (double start = -std::fmod(along, period); start < size; start += period) {
            const double from = std::max(0.0, start), to = std::min(size, start + dash);
            if (to > from) penLoop(lerp(a, b, from / size), lerp(a, b, to / size), half, loops);
        }
        along += size;
    }
}

Colour sampleRaster(std::int32_t width, std::int32_t height, std::span<const Colour> colours, double u,
                    double v) {
    const auto at = [&](double x, double y) {
        const auto column = static_cast<std::size_t>(std::clamp<double>(x, 0.0, width - 1));
        const auto row = static_cast<std::size_t>(std::clamp<double>(y, 0.0, height - 1));
        return colours[row * static_cast<std::size_t>(width) + column];
    };
    const double x = std::floor(u), y = std::floor(v);
    double sum[4] = {0, 0, 0, 0};
    for (int k = 0; k < 4; ++k) {
        const double wx = (k & 1) != 0 ? u - x : 1.0 - (u - x), wy = (k & 2) != 0 ? v - y : 1.0 - (v - y);
        const Colour c = at(x + (k & 1), y + (k >> 1));
        const double weight = wx * wy * c.opacity;
        sum[0] += weight * c.red;
        sum[1] += weight * c.green;
        sum[2] += weight * c.blue;
        sum[3] += weight;
    }
    if (sum[3] <= 1e-9) return {};
    const auto byte = [&](double value) { return static_cast<std::uint8_t>(value / sum[3] + 0.5); };
    return {byte(sum[0]), byte(sum[1]), byte(sum[2]), std::min(1.0, sum[3])};
}

}  // namespace muster
