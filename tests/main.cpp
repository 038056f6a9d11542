// The entry point that all test programs share.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest.h>

#include "test_folders.h"

namespace muster {

std::string sourceFolder() {
    return MUSTER_SOURCE_DIR;
}
std::string programPath() {
    return MUSTER_PROGRAM;
}

}  // namespace muster
