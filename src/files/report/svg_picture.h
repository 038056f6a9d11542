// Pictures (whole SVG documents) as elements of another document.
#pragma once

#include <string>

namespace muster {

/// Size of a picture by its root element [px]; 0 without a picture.
struct PictureSize {
    double width = 0.0;
    double height = 0.0;
};

/// Reads width and height, or else those of the viewBox.
PictureSize pictureSize(const std::string& svg);

/// The picture as an <svg> element with `attributes` (` x="3"`...) in place of its own position and size. Ids
/// and references to them get the prefix, so that pictures in one document have different ids. Empty
/// for no picture.
std::string nestedPicture(const std::string& svg, const std::string& attributes, const std::string& prefix);

}  // namespace muster
