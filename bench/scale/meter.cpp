#include "scale/meter.h"

#include <atomic>
#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace muster::scale {
namespace {

std::atomic<std::int64_t> count{0};

}  // namespace

std::int64_t allocationCount() {
    return count.load(std::memory_order_relaxed);
}
// Before main() something has been allocated for certain.
bool allocationsCounted() {
    return allocationCount() > 0;
}
void countAllocation() {
    count.fetch_add(1, std::memory_order_relaxed);
}

void resetPeakMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ofstream("/proc/self/clear_refs") << "5\n";
}

double peakMemory() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        if (word != "VmHWM:") continue;
        double kilobytes = 0.0;
        status >> kilobytes;
        return kilobytes / 1024.0;
    }
    return 0.0;
}

}  // namespace muster::scale
