#include "scale/meter.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <fstream>
#include <string>
#include <string_view>

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

double threadMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::clamp<std::size_t>(at, 1, values.size()) - 1];
}

void resetPeakMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ofstream("/proc/self/clear_refs") << "5\n";
}

namespace {

// An entry of the process's status that is in kilobytes [MB].
double statusEntry(std::string_view name) {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        if (word != name) continue;
        double kilobytes = 0.0;
        status >> kilobytes;
        return kilobytes / 1024.0;
    }
    return 0.0;
}

}  // namespace

double peakMemory() {
    return statusEntry("VmHWM:");
}

double residentMemory() {
    return statusEntry("VmRSS:");
}

}  // namespace muster::scale
