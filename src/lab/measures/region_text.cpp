// Well-known text of polygons.
#include <cctype>
#include <cstdlib>
#include <string>

#include "lab/measures/region.h"

namespace muster {
namespace {

/// Reads `(x y, x y, ...)` lists, nested to any depth.
class WktReader {
public:
    explicit WktReader(std::string_view text) : text_(text) {}

    bool read(std::vector<PolygonWithHoles>& polygons) {
        const std::string kind = word();
        if (kind == "POLYGON") return polygon(polygons);
        if (kind == "MULTIPOLYGON") return list([&] { return polygon(polygons); });
        if (kind == "GEOMETRYCOLLECTION") return list([&] { return read(polygons); });
        return false;
    }
    bool atEnd() {
        skip();
        return at_ == text_.size();
    }

private:
    void skip() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }
    bool take(char c) {
        skip();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    std::string word() {
        skip();
        std::string word;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])))
            word += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
        return word;
    }
    bool number(double& value) {
        skip();
        const std::string rest(text_.substr(at_, 40));
        char* end = nullptr;
        value = std::strtod(rest.c_str(), &end);
        at_ += end - rest.c_str();
        return end != rest.c_str();
    }
    template <class Item>
    bool list(const Item& item) {
        if (!take('(')) return false;
        do {
            if (!item()) return false;
        } while (take(','));
        return take(')');
    }
    bool ring(Polygon& corners) {
        return list([&] {
            Vec2 p;
            if (!number(p.x) || !number(p.y)) return false;
            corners.push_back(p);
            return true;
        });
    }
    bool polygon(std::vector<PolygonWithHoles>& polygons) {
        PolygonWithHoles one;
        const bool good = list([&] {
            Polygon corners;
            if (!ring(corners)) return false;
            if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
            if (one.outline.empty()) {
                one.outline = std::move(corners);
            } else {
                one.holes.push_back(std::move(corners));
            }
            return true;
        });
        if (good) polygons.push_back(std::move(one));
        return good;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

Result<Region> Region::parse(std::string_view text) {
    std::vector<PolygonWithHoles> polygons;
    WktReader reader(text);
    if (!reader.read(polygons) || !reader.atEnd())
        return Status(StatusCode::ParseError, "area: found \"" + std::string(text.substr(0, 40)) +
                                                  "\", expected POLYGON ((x y, ...)) or MULTIPOLYGON");
    return create(polygons);
}

}  // namespace muster
