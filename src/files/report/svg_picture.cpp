#include "files/report/markup.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace muster {
namespace {

/// The tag of the root element, from "<svg" up to ">"; empty if there is none.
std::string rootTag(const std::string& svg) {
    const std::size_t from = svg.find("<svg");
    const std::size_t end = from == std::string::npos ? from : svg.find('>', from);
    return end == std::string::npos ? std::string() : svg.substr(from, end - from);
}

/// Range of the value of attribute `name` in a tag, between the quotes; npos if the tag has none.
std::string attributeOf(const std::string& tag, const std::string& name) {
    const std::string start = " " + name + "=\"";
    const std::size_t from = tag.find(start);
    if (from == std::string::npos) return {};
    const std::size_t value = from + start.size();
    return tag.substr(value, tag.find('"', value) - value);
}

void removeAttribute(std::string& tag, const std::string& name) {
    const std::string start = " " + name + "=\"";
    const std::size_t from = tag.find(start);
    if (from == std::string::npos) return;
    const std::size_t end = tag.find('"', from + start.size());
    tag.erase(from, end == std::string::npos ? end : end + 1 - from);
}

void insertAfter(std::string& text, const std::string& sign, const std::string& inserted) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + 1))
        text.insert(at + sign.size(), inserted);
}

double positive(const std::string& text) {
    const double value = std::strtod(text.c_str(), nullptr);
    return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

}  // namespace

PictureSize pictureSize(const std::string& svg) {
    const std::string tag = rootTag(svg);
    PictureSize size{positive(attributeOf(tag, "width")), positive(attributeOf(tag, "height"))};
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    const bool box = std::sscanf(attributeOf(tag, "viewBox").c_str(), "%lf %lf %lf %lf", &x, &y, &width,
                                 &height) == 4;
    if (size.width > 0.0 && size.height > 0.0) return size;
    return box && width > 0.0 && height > 0.0 ? PictureSize{width, height} : PictureSize{};
}

std::string nestedPicture(const std::string& svg, const std::string& attributes, const std::string& prefix) {
    std::string tag = rootTag(svg);
    const std::size_t end = svg.rfind("</svg>");
    if (tag.empty() || end == std::string::npos) return {};
    const PictureSize size = pictureSize(svg);
    const std::size_t bodyStart = svg.find("<svg") + tag.size();
    for (const char* name : {"x", "y", "width", "height", "xmlns"}) removeAttribute(tag, name);
    if (attributeOf(tag, "viewBox").empty())
        tag += " viewBox=\"0 0 " + svgNumber(size.width) + " " + svgNumber(size.height) + "\"";
    std::string body = svg.substr(bodyStart, end - bodyStart);
    for (const char* sign : {" id=\"", "url(#", "href=\"#"}) insertAfter(body, sign, prefix);
    return "<svg" + attributes + tag.substr(4) + body + "</svg>";
}

}  // namespace muster
