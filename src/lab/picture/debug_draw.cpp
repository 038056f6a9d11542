#include "lab/picture/debug_draw.h"

#include <cstdio>

namespace muster {

void DebugDraw::polygon(std::span<const Vec2> corners, Colour fill, const Stroke& stroke) {
    const std::vector<std::vector<Vec2>> loops{{corners.begin(), corners.end()}};
    area(loops, fill, stroke);
}

void DebugDraw::lines(std::span<const std::vector<Vec2>> lines, const Stroke& stroke) {
    for (const std::vector<Vec2>& points : lines) line(points, stroke);
}

Status DebugDraw::write(const std::string& path) const {
    const std::string bytes = document();
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return {StatusCode::IoError, path + ": cannot be written"};
    const bool wrote = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const bool closed = std::fclose(file) == 0;
    return wrote && closed ? Status() : Status(StatusCode::IoError, path + ": cannot be written in full");
}

}  // namespace muster
