#include <cmath>
#include <cstdio>

#include "base/base64.h"
#include "lab/picture/canvas.h"
#include "lab/picture/debug_draw.h"

namespace muster {
namespace {

std::string number(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.2f", value);
    std::string text = buffer;
    text.erase(text.find_last_not_of('0') + 1);
    if (!text.empty() && text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string escaped(std::string_view words) {
    std::string text;
    for (char c : words) {
        if (c == '<')
            text += "&lt;";
        else if (c == '&')
            text += "&amp;";
        else if (c == '"')
            text += "&quot;";
        else if (static_cast<unsigned char>(c) >= 32)
            text += c;
    }
    return text;
}

std::string hex(Colour c) {
    char buffer[16];
    std::snprintf(buffer, sizeof(buffer), "#%02X%02X%02X", c.red, c.green, c.blue);
    return buffer;
}

/// Writes shapes as SVG elements, in pixels.
class SvgDraw final : public DebugDraw {
public:
    SvgDraw(const Box& view, std::int32_t width, Colour ground)
        : view_(view),
          scale_(width / view.width()),
          width_(width),
          height_(std::ceil(view.height() * scale_)) {
        body_ = "<rect width=\"100%\" height=\"100%\" fill=\"" + hex(ground) + "\"/>\n";
    }

    void area(std::span<const std::vector<Vec2>> loops, Colour fill, const Stroke& stroke) override {
        std::string data;
        for (const auto& loop : loops) data += points(loop) + "Z";
        body_ += "<path d=\"" + data + "\"" + fillOf(fill) + strokeOf(stroke) + "/>\n";
    }
    void line(std::span<const Vec2> line, const Stroke& stroke) override {
        body_ += "<path d=\"" + points(line) + "\" fill=\"none\"" + strokeOf(stroke) + "/>\n";
    }
    void lines(std::span<const std::vector<Vec2>> lines, const Stroke& stroke) override {
        if (lines.empty()) return;
        std::string data;
        for (const auto& line : lines) data += points(line);
        body_ += "<path d=\"" + data + "\" fill=\"none\"" + strokeOf(stroke) + "/>\n";
    }
    void disc(Vec2 centre, double radius, Colour fill, const Stroke& stroke) override {
        const Vec2 c = toPixel(centre);
        body_ += "<circle cx=\"" + number(c.x) + "\" cy=\"" + number(c.y) + "\" r=\"" +
                 number(radius * scale_) + "\"" + fillOf(fill) + strokeOf(stroke) + "/>\n";
    }
    void raster(const Box& box, std::int32_t width, std::int32_t height,
                std::span<const Colour> colours) override {
        std::vector<std::uint8_t> bytes;
        for (std::int32_t y = height - 1; y >= 0; --y) {
            for (std::int32_t x = 0; x < width; ++x) {
                const Colour c = colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                         static_cast<std::size_t>(x)];
                const auto opacity = static_cast<std::uint8_t>(std::lround(c.opacity * 255.0));
                bytes.insert(bytes.end(), {c.red, c.green, c.blue, opacity});
            }
        }
        const Vec2 corner = toPixel({box.min.x, box.max.y});
        body_ += "<image x=\"" + number(corner.x) + "\" y=\"" + number(corner.y) + "\" width=\"" +
                 number(box.width() * scale_) + "\" height=\"" + number(box.height() * scale_) +
                 "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," +
                 base64(encodePng(width, height, 4, bytes)) + "\"/>\n";
    }
    void text(Vec2 at, std::string_view words, double size, Colour colour, TextAnchor anchor) override {
        const Vec2 p = toPixel(at);
        const char* side = anchor == TextAnchor::Left ? "start"
                                                      : (anchor == TextAnchor::Centre ? "middle" : "end");
        body_ += "<text x=\"" + number(p.x) + "\" y=\"" + number(p.y) + "\" font-size=\"" + number(size) +
                 "\" font-weight=\"500\" text-anchor=\"" + side + "\" dominant-baseline=\"central\"" +
                 fillOf(colour) + ">" + escaped(words) + "</text>\n";
    }
    double pixel() const override { return 1.0 / scale_; }
    Box view() const override { return view_; }
    std::string document() const override {
        const std::string size = number(width_) + "\" height=\"" + number(height_);
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" viewBox=\"0 0 " +
               number(width_) + " " + number(height_) +
               "\" font-family=\"Inter, Helvetica, Arial, sans-serif\" stroke-linecap=\"round\" "
               "stroke-linejoin=\"round\">\n" +
               body_ + "</svg>\n";
    }

private:
    Vec2 toPixel(Vec2 p) const { return {(p.x - view_.min.x) * scale_, (view_.max.y - p.y) * scale_}; }
    std::string points(std::span<const Vec2> line) const {
        std::string data;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Vec2 p = toPixel(line[i]);
            data += (i == 0 ? "M" : "L") + number(p.x) + " " + number(p.y);
        }
        return data;
    }
    static std::string fillOf(Colour c) {
        if (c.opacity <= 0.0) return " fill=\"none\"";
        return " fill=\"" + hex(c) + "\"" +
               (c.opacity < 1.0 ? " fill-opacity=\"" + number(c.opacity) + "\"" : "");
    }
    static std::string strokeOf(const Stroke& stroke) {
        if (stroke.width <= 0.0 || stroke.colour.opacity <= 0.0) return "";
        std::string text = " stroke=\"" + hex(stroke.colour) + "\" stroke-width=\"" + number(stroke.width) +
                           "\"";
        if (stroke.colour.opacity < 1.0) text += " stroke-opacity=\"" + number(stroke.colour.opacity) + "\"";
        if (stroke.dash > 0.0)
            text += " stroke-dasharray=\"" + number(stroke.dash) + " " + number(stroke.dash + stroke.width) +
                    "\"";
        return text;
    }

    Box view_;
    double scale_;  // Pixels per metre.
    double width_;
    double height_;
    std::string body_;
};

}  // namespace

std::unique_ptr<DebugDraw> makeSvgDraw(const Box& view, std::int32_t width, Colour ground) {
    return std::make_unique<SvgDraw>(view, width, ground);
}

}  // namespace muster
