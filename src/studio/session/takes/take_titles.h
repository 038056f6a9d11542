// Titles of takes that are made from others.
#pragma once

#include <string>
#include <vector>

namespace muster {

/// A title for what is directed again: "Through the door" gives "Through the door, 2", and that one "Through
/// the door, 3", or the first number that none of `taken` has.
std::string nextTitle(const std::string& title, const std::vector<std::string>& taken);

}  // namespace muster
