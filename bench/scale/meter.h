// Number of allocations and peak memory of the process.
#pragma once

#include <cstdint>

namespace muster::scale {

/// Allocations so far by operator new, where the program counts them.
std::int64_t allocationCount();
/// True in a program that is linked with the counting allocator.
bool allocationsCounted();
/// Called by the counting allocator.
void countAllocation();

/// Resets the peak, where the system allows it.
void resetPeakMemory();
/// Most resident memory of the process since then [MB]; 0 where the system does not report it.
double peakMemory();

}  // namespace muster::scale
