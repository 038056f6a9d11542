// Pictures (whole SVG documents) as elements of another document.
#pragma once

#include <string>

namespace muster {

/// What a picture's root says of its size [px]; 0 where there is no picture.
struct PictureSize {
    double width = 0.0;
    double height = 0.0;
};

/// Reads width and height, or else those of the viewBox.
PictureSize pictureSize(const std::string& svg);

/// The picture as an <svg> element with `attributes` (` x="3"`...) in place of its own place and size. Ids
/// and what refers to them get the prefix, so that pictures in one document do not take each other's. Empty
/// for no picture.
std::string nestedPicture(const std::string& svg, const std::string& attributes, const std::string& prefix);

}  // namespace muster
