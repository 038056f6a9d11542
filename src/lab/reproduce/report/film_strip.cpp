#include "lab/reproduce/report/drawings.h"

#include <algorithm>
#include <cmath>

#include "files/report/markup.h"

namespace muster {
namespace {

// All sizes are in pixels of the strip. Four pictures of 440 and the gaps make 1,850: on a width of 180 mm
// letters of 27 px are 7.5 points high.
constexpr double kPictureWidth = 440.0, kEmptyHeight = 300.0, kGap = 24.0, kMargin = 8.0;
constexpr double kLetter = 27.0, kLine = 34.0, kBelow = 10.0;
constexpr std::size_t kLettersPerLine = 31;
constexpr const char* kInk = "#171B20";

/// A picture with its caption.
struct PlacedPicture {
    double height = 0.0;  // Height of the picture.
    std::vector<std::string> lines;
    double total() const { return height + kBelow + kLine * static_cast<double>(lines.size() + 1); }
};

PlacedPicture cellOf(const FilmFrame& frame) {
    const PictureSize size = pictureSize(frame.svg);
    return {size.width > 0.0 ? kPictureWidth * size.height / size.width : kEmptyHeight,
            wrapped(frame.caption, kLettersPerLine)};
}

std::string textAt(double x, double y, const std::string& words, const char* weight) {
    return "<text x=\"" + svgNumber(x) + "\" y=\"" + svgNumber(y) + "\" font-size=\"" + svgNumber(kLetter) +
           "\" font-weight=\"" + weight + "\" fill=\"" + kInk + "\">" + escaped(words) + "</text>\n";
}

std::string drawCell(const FilmFrame& frame, const PlacedPicture& cell, double x, double y,
                     std::size_t index) {
    const std::string box = " x=\"" + svgNumber(x) + "\" y=\"" + svgNumber(y) + "\" width=\"" +
                            svgNumber(kPictureWidth) + "\" height=\"" + svgNumber(cell.height) + "\"";
    std::string out = nestedPicture(frame.svg, box, "p" + std::to_string(index) + "-");
    if (out.empty()) out = textAt(x + 12.0, y + 0.5 * cell.height, "no picture", "400");
    out += "\n<rect" + box + " fill=\"none\" stroke=\"#777166\" stroke-width=\"1.5\"/>\n";
    double baseline = y + cell.height + kBelow + kLetter;
    out += textAt(x, baseline, fixedNumber(frame.time, 1) + " s", "700");
    for (const std::string& line : cell.lines) out += textAt(x, baseline += kLine, line, "400");
    return out;
}

}  // namespace

std::int32_t stripColumns(std::size_t frames, std::int32_t most) {
    const auto count = static_cast<std::int32_t>(std::min<std::size_t>(frames, 10000));
    if (count == 0) return 1;
    const std::int32_t rows = (count + std::max(1, most) - 1) / std::max(1, most);
    return (count + rows - 1) / rows;
}

std::string filmStrip(const std::vector<FilmFrame>& film, std::int32_t columns) {
    if (film.empty()) return {};
    const auto inRow = static_cast<std::size_t>(stripColumns(film.size(), columns));
    std::string body;
    double y = kMargin;
    for (std::size_t from = 0; from < film.size(); from += inRow) {
        double tallest = 0.0;
        for (std::size_t i = from; i < std::min(from + inRow, film.size()); ++i) {
            const PlacedPicture cell = cellOf(film[i]);
            body += drawCell(film[i], cell, kMargin + static_cast<double>(i - from) * (kPictureWidth + kGap),
                             y, i);
            tallest = std::max(tallest, cell.total());
        }
        y += tallest + kGap;
    }
    const std::string width = svgNumber(2.0 * kMargin + static_cast<double>(inRow) * (kPictureWidth + kGap) -
                                        kGap);
    const std::string height = svgNumber(std::ceil(y - kGap + 2.0 * kMargin));
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height +
           "\" font-family=\"Inter, Helvetica, Arial, sans-serif\">\n" +
           "<rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>\n" + body + "</svg>\n";
}

}  // namespace muster
