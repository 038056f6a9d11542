// The only file that includes the stb headers.
#include "lab/picture/canvas.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_easy_font.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <string>

namespace muster {
namespace {

struct Corner {
    float x, y, z;
    unsigned char colour[4];
};

}  // namespace

std::vector<std::uint8_t> encodePng(std::int32_t width, std::int32_t height, std::int32_t channels,
                                    std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> png;
    const auto append = [](void* context, void* data, int size) {
        auto& out = *static_cast<std::vector<std::uint8_t>*>(context);
        const auto* from = static_cast<const std::uint8_t*>(data);
        out.insert(out.end(), from, from + size);
    };
    stbi_write_png_to_func(append, &png, width, height, channels, bytes.data(), width * channels);
    return png;
}

double letterLoops(std::string_view words, double size, std::vector<std::vector<Vec2>>& loops) {
    // The font has no other letters, and stb would read beyond its tables.
    std::string copy = plainLetters(words).substr(0, 200);
    std::vector<Corner> corners(copy.size() * 400 / sizeof(Corner) + 64);
    const int quads = stb_easy_font_print(0.0f, 0.0f, copy.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(Corner)));
    const double scale = size / 9.0;  // Capitals are 7 units high and lines 12.
    for (int q = 0; q < quads; ++q) {
        std::vector<Vec2> loop;
        for (int k = 0; k < 4; ++k) {
            const Corner& c = corners[4 * q + k];
            loop.push_back({static_cast<double>(c.x) * scale, (static_cast<double>(c.y) - 4.0) * scale});
        }
        if (signedArea(loop) < 0.0) std::reverse(loop.begin(), loop.end());
        loops.push_back(std::move(loop));
    }
    return stb_easy_font_width(copy.data()) * scale;
}

}  // namespace muster
