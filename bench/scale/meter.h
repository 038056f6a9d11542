// Counts of allocations, and the peak of memory.
#pragma once

#include <cstdint>

namespace muster::scale {

/// Allocations so far by operator new, where the program counts them.
std::int64_t allocationCount();
/// True in a program that is linked with the counting allocator.
bool allocationsCounted();
/// Called by the counting allocator.
void countAllocation();

/// Starts a new peak, as far as the system allows.
void resetPeakMemory();
/// Most resident memory of the process since then [MB]; 0 where the system does not tell.
double peakMemory();

}  // namespace muster::scale
