// What a function of the WebAssembly module says beside its number.
#pragma once

#include <string>

namespace muster {

/// The text that muster_text() gives; kept until the next one.
std::string& lastText();

}  // namespace muster
